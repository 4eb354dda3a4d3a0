#pragma once

/// \file
/// \brief The small world at its last step.

#include "05_resolution/small_world/step_7.hpp"

namespace cookbook
{

// [small_world]
/// The small world: `small_world::World`, `add`, `step`.
namespace small_world = small::step_7;
// [small_world]

} // namespace cookbook
