#pragma once

/// \file
/// \brief The separating velocity of a bounce in time steps, from the speed that two surfaces had
/// as they touched.

#include <algorithm>
#include <cmath>

namespace cookbook
{

// [contact_step]
/// What a contact has to know of the time step in which it bounces, along its normal.
template <class Real>
struct ContactStep
{
  Real
      acceleration; ///< [m/s²], of the separating velocity by what pulls; negative where it presses
  Real duration;    ///< [s]
  Real depth;       ///< [m], at the start of the step; negative: a gap
};
// [contact_step]

// [impact_speed]
/// The speed [m/s] of approach at the moment of touch, zero or more; R19.
///
/// `speed` is the separating velocity once the step's gravity is in it. Half of that gravity is
/// taken out again, and what was fallen since the touch. Zero for surfaces that part, and where the
/// fall does not reach from touch to depth at all.
template <class Real>
Real impact_speed(Real speed, const ContactStep<Real>& step)
{
  using std::sqrt;
  const Real now = speed - step.acceleration * step.duration / Real(2);
  const Real squared = now * now + Real(2) * step.acceleration * step.depth;
  return now < Real(0) && squared > Real(0) ? sqrt(squared) : Real(0);
}
// [impact_speed]

// [rebound_speed]
/// The fastest approach [m/s] that is a rest and no bounce, under a gravity [m/s²]: two steps
/// [s] of it; R19.
template <class Real>
Real restitution_threshold(Real gravity, Real duration)
{
  return Real(2) * gravity * duration;
}

/// The separating velocity [m/s], zero or more, that a contact is to leave a step with; R19.
///
/// It takes the surfaces back to the touch, where they part by the restitution [1] times
/// `impact_speed`. Zero where that is no more than a threshold [m/s]. Whatever else undoes the
/// depth has to leave it alone in this step, or be told a depth of zero here.
template <class Real>
Real rebound_speed(Real speed, const ContactStep<Real>& step, Real restitution, Real threshold)
{
  using std::sqrt;
  const Real touch = impact_speed(speed, step);
  if (touch <= threshold)
  {
    return Real(0);
  }
  const Real back = restitution * touch;
  const Real squared = back * back - Real(2) * step.acceleration * step.depth;
  const Real now = squared > Real(0) ? sqrt(squared) : Real(0);
  return std::max(Real(0), Real(now + step.acceleration * step.duration / Real(2)));
}
// [rebound_speed]

} // namespace cookbook
