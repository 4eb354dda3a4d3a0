/// \file
/// \brief Wide steps in registers of any width, compiled once for charts and tests.

#include "05_resolution/wide_solver/trial/wide_solver_runs.hpp"

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
