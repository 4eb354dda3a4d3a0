#pragma once

/// \file
/// \brief The methods that move ropes, by name, as tables and charts list them.

#include "07_constraints/rope/rope.hpp"

#include <functional>
#include <string>
#include <vector>

namespace cookbook
{

/// A method, and how much it is given.
struct RopeMethod
{
  std::string name;
  std::function<void(Rope&, const StepSettings&)> step;
  int substeps = 1;
  int iterations = 1;
  double compliance = 0;    ///< [m/N], of each link
  int passes_per_solve = 1; ///< what a solve costs, in passes of XPBD, by instructions

  /// What a frame costs, in passes of XPBD along the rope.
  int passes() const { return substeps * iterations * passes_per_solve; }
};

/// Springs, by the forces at the start of a step.
inline RopeMethod mass_spring(double stiffness, int substeps)
{
  const auto step = [](Rope& rope, const StepSettings& settings)
  { step_mass_spring(rope.particles, rope.links, settings); };
  return {"mass-spring", step, substeps, 1, 1 / stiffness, 1};
}

/// Springs, by the forces at the end of a step.
inline RopeMethod implicit_euler_of(double stiffness, int substeps = 1)
{
  const auto step = [](Rope& rope, const StepSettings& settings)
  { step_implicit(rope.particles, rope.links, settings); };
  return {"implicit Euler", step, substeps, 1, 1 / stiffness, 5};
}

/// One link after the other.
inline RopeMethod xpbd(int substeps, int iterations)
{
  const auto step = [](Rope& rope, const StepSettings& settings)
  { step_xpbd(rope.particles, rope.links, settings); };
  return {"XPBD", step, substeps, iterations, 0, 1};
}

/// All links at once, along their directions after the step.
inline RopeMethod direct_current(int substeps, int iterations = 1)
{
  const auto step = [](Rope& rope, const StepSettings& settings)
  { step_direct(rope.particles, rope.links, settings, LinkDirections::current); };
  return {"direct, current", step, substeps, iterations, 0, 2};
}

/// All links at once, along their directions before the step.
inline RopeMethod direct_previous(int substeps, int iterations = 1)
{
  const auto step = [](Rope& rope, const StepSettings& settings)
  { step_direct(rope.particles, rope.links, settings, LinkDirections::previous); };
  return {"direct, previous", step, substeps, iterations, 0, 2};
}

} // namespace cookbook
