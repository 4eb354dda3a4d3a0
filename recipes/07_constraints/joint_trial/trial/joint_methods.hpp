#pragma once

/// \file
/// \brief The solvers that are tried on joints, by name, each with what a frame of it costs.

#include "06_world/game_world/solvers.hpp"
#include "07_constraints/avbd/avbd.hpp"

#include <functional>
#include <string>
#include <vector>

namespace cookbook
{

// [joint_methods]
/// A solver, and how much it is given.
struct JointMethod
{
  std::string name;
  std::string counted;                    ///< what its count is of, in a frame
  int usual;                              ///< its count as it comes
  std::function<WorldSolver(int)> solver; ///< with another count
  int price;        ///< [1], what one of these costs, in substeps of soft_steps, rounded
  int per_step = 0; ///< counts in a step, where a frame takes several; else 0

  /// Steps of the world in a frame.
  int steps(int count) const { return per_step > 0 ? count / per_step : 1; }
};

/// The solvers of chapter 6, and AVBD. The direct one takes six substeps a step, up to 16 where
/// joints are taut; more are more steps.
inline std::vector<JointMethod> joint_methods()
{
  const auto named = [](const std::string& name)
  { return [name](int substeps) { return solver_named(name, substeps); }; };
  const auto direct = [](int) { return solver_named("direct"); };
  const auto avbd = [](int iterations) { return one_by_one(Avbd({.iterations = iterations})); };
  return {
      {"sequential_impulses", "substep of 8 passes", 1, named("sequential_impulses"), 2},
      {"soft_steps", "substeps", 4, named("soft_steps"), 1},
      {"wide_steps", "substeps", 4, named("wide_steps"), 1},
      {"position_based", "substeps", 20, named("position_based"), 1},
      {"avbd", "iterations", 10, avbd, 1},
      {"direct", "substeps or more", 6, direct, 2, 6}};
}
// [joint_methods]

} // namespace cookbook
