#pragma once

/// \file
/// \brief How often a program that links this has asked for memory, and how much it holds.

namespace cookbook
{

/// All calls of operator new so far.
long counted_allocations();

/// How much [bytes] it has been given and has not given back.
long held_bytes();

} // namespace cookbook
