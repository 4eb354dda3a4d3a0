#pragma once

/// \file
/// \brief How often a program that links this has asked for memory.

namespace cookbook
{

/// All calls of operator new so far.
long counted_allocations();

} // namespace cookbook
