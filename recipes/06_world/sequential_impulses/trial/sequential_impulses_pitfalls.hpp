#pragma once

/// \file
/// \brief Passes over contacts that clamp the wrong thing, kept to be asserted to fail.

#include "06_world/sequential_impulses/trial/sequential_impulses_scenes.hpp"

namespace cookbook
{

// [clamped_change]
/// One pass that lets no single correction pull, instead of no sum of them: what a point got too
/// much it never hands back.
template <class Real>
void correct_by_pushes_only(const PushProblem<Real>& problem, Eigen::VectorX<Real>& impulses)
{
  for (Eigen::Index i = 0; i < impulses.size(); ++i)
  {
    const Real change = -problem.speed(impulses, i) / problem.response(i, i);
    impulses(i) += std::max(Real(0), change);
  }
}
// [clamped_change]

} // namespace cookbook
