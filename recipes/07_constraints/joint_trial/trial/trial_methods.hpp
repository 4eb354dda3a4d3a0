#pragma once

/// \file
/// \brief All methods on trial: the solvers that a world takes for joints, and three that are here
/// to be compared.

#include "06_world/sequential_impulses/sequential_impulses.hpp"
#include "07_constraints/joint_trial/trial/joint_methods.hpp"
#include "07_constraints/joint_trial/trial/tree_steps.hpp"

#include <vector>

namespace cookbook
{

// [trial_methods]
/// joint_methods(), sequential impulses with passes over positions, conjugate gradients, and trees
/// of links; the last two throw std::logic_error where they cannot have a scene.
inline std::vector<JointMethod> trial_methods()
{
  const auto island_solver = [](auto solver)
  {
    return [solver](int count)
    {
      return one_by_one([solver, count](IslandView world, const Island& island, double step)
                        { solver(world, island, step, count); });
    };
  };
  const auto ngs = [](IslandView world, const Island& island, double step, int substeps)
  { sequential_impulses(world, island, step, {.substeps = substeps, .position_iterations = 3}); };
  const auto gradients = [](IslandView world, const Island& island, double step, int substeps)
  { gradient_steps(world, island, step, {.substeps = substeps}); };
  std::vector<JointMethod> all = joint_methods();
  all.insert(all.begin() + 1, {"ngs", "substep of 8 + 3 passes", 1, island_solver(ngs), 4});
  all.insert(
      all.end() - 1,
      {"conjugate_gradients", "substeps of 20 passes", 6, island_solver(gradients), 1});
  all.push_back({"articulated", "steps of RK4", 16, island_solver(&tree_steps), 2});
  return all;
}
// [trial_methods]

} // namespace cookbook
