#pragma once

/// \file
/// \brief Ways to damp a velocity that are wrong, kept to be asserted to fail.

#include "common/math/vector.hpp"

#include <cmath>

namespace cookbook
{

// [damped_as_published]
/// A velocity after one step that leaves a fixed fraction of it, whatever the step's length.
template <class Place, class Real>
Place damped_as_published(
    const Place& velocity, const Place& acceleration, const Real& share, const Real& step)
{
  return share * (velocity + step * acceleration);
}

/// A velocity with components below a threshold [m/s] set to zero.
///
/// A body at rest is to stay there. But one that begins to fall has a small velocity too: if a step
/// adds less than the threshold, it hangs in the air.
template <class Real>
Real snapped(const Real& velocity, const Real& threshold)
{
  using std::abs;
  return abs(velocity) < threshold ? Real(0) : velocity;
}
// [damped_as_published]

/// The share left after one step of explicit Euler: negative from rate·step = 1 on, and growing
/// from 2 on.
template <class Real>
Real explicit_damping_factor(const Real& rate, const Real& step)
{
  return Real(1) - rate * step;
}

} // namespace cookbook
