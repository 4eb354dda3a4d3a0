/// \file
/// \brief The solvers of the world, compiled once for programs and tests.

#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"
#include "06_world/game_world/game_world.hpp"
#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/wide_solver/wide_solver.hpp"

#include <span>

// [solvers_compiled_once]
#include "06_world/game_world/solver_named.hpp"
// [solvers_compiled_once]

namespace cookbook
{

GameWorld wide_world(const Scene& scene, const WidePasses& passes, const SoftSettings& how)
{
  return GameWorld(
      scene, [how, lanes = WideContacts(passes)](
                 IslandView view, std::span<const Island> islands, double step) mutable
      { wide_steps(view, islands, step, how, lanes); });
}

} // namespace cookbook
