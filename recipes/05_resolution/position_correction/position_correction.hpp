#pragma once

/// \file
/// \brief How an overlap is taken away: at once, by a push, beside the motion, or by a soft spring.

#include "05_resolution/position_correction/softness.hpp"

#include <algorithm>

namespace cookbook
{

// [bias_velocity]
/// The speed [m/s] at which a depth [m] beyond a slop [m] is pushed out, at a rate [1/s], and at
/// `max_speed` [m/s] at most; R11 with a rate of β / step.
template <class Real>
Real bias_velocity(const Real& depth, const Real& slop, const Real& rate, const Real& max_speed)
{
  return std::min(max_speed, std::max(Real(0), Real(rate * (depth - slop))));
}
// [bias_velocity]

// [position_correction]
/// How far [m] one pass over positions takes two surfaces apart: a share [1] of the depth [m]
/// beyond a slop [m]; R12.
template <class Real>
Real position_correction(const Real& depth, const Real& slop, const Real& fraction)
{
  return fraction * std::max(Real(0), Real(depth - slop));
}
// [position_correction]

} // namespace cookbook
