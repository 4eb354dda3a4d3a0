#pragma once

/// \file
/// \brief What the kernel of every batch begins with: a register's lanes, and a name for each
/// instruction set.

#include "common/simd/pack.hpp"

#include <cstddef>

/// The name a_b, where b is a macro too: sphere_pairs_ and COOKBOOK_INSTRUCTION_SET.
#define COOKBOOK_NAMED(a, b) COOKBOOK_JOIN(a, b)
#define COOKBOOK_JOIN(a, b) a##b ///< for COOKBOOK_NAMED alone

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

// [lanes]
/// How many floats a register holds.
inline constexpr std::size_t width = register_size / sizeof(float);

/// One pair in every lane of a register.
using Lanes = Pack<float, width>;
// [lanes]

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
