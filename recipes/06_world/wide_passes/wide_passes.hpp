#pragma once

/// \file
/// \brief The wide solver's passes, compiled for each instruction set.

#include "03_sphere_manifolds/sphere_pairs/sphere_pairs.hpp"
#include "06_world/wide_solver/wide_view.hpp"

namespace cookbook
{

// [wide_passes]
/// The passes for an instruction set: four contacts at a time, with AVX2 eight, with AVX-512
/// sixteen.
///
/// All give the same bits, for whoever shares a body with a contact is in another group.
WidePasses wide_passes(InstructionSet set);
// [wide_passes]

} // namespace cookbook
