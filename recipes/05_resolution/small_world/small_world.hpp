#pragma once

/// \file
/// \brief The small world at its last step.

#include "05_resolution/small_world/step_7.hpp"

// [small_world]
/// The small world: a World, its bodies, `add` and `step`.
namespace cookbook::small_world
{
using namespace step_7;
} // namespace cookbook::small_world
// [small_world]
