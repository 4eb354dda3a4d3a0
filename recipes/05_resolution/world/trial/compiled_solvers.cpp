/// \file
/// \brief The solvers of the world, compiled once for programs and tests.

#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"
#include "05_resolution/wide_solver/wide_solver.hpp"
#include "05_resolution/world/trial/world_runs.hpp"
#include "05_resolution/world/world.hpp"

#include <span>

// [solvers_compiled_once]
#include "05_resolution/world/solver_named.hpp"
// [solvers_compiled_once]

namespace cookbook
{

World wide_world(const Scene& scene, const WidePasses& passes, const SoftSettings& how)
{
  return World(
      scene, [how, lanes = WideContacts(passes)](
                 IslandView view, std::span<const Island> islands, double step) mutable
      { wide_steps(view, islands, step, how, lanes); });
}

} // namespace cookbook
