#pragma once

/// \file
/// \brief Bounces that read the speed at the wrong moment, kept to be asserted to fail.

#include "05_resolution/restitution/restitution.hpp"

namespace cookbook
{

// [restitution_pitfalls]
/// The separating velocity [m/s] of a bounce that gives back the speed as it is once the step's
/// gravity is in it: too fast, by up to 1 + e halves of a step's gravity.
template <class Real>
Real rebound_after_gravity(Real speed, Real restitution, Real threshold)
{
  return speed < -threshold ? Real(-restitution * speed) : Real(0);
}

/// The same with the speed as it was before the step's gravity, which is added afterwards: too
/// slow.
///
/// Impulses come before gravity in the code published with the seed book. Gravity then pulls a body
/// that rests a little into the floor at every step.
template <class Real>
Real rebound_before_gravity(Real speed, const ContactStep<Real>& step, Real restitution)
{
  const Real gravity = step.acceleration * step.duration;
  const Real before = speed - gravity;
  return before < Real(0) ? Real(-restitution * before + gravity) : speed;
}
// [restitution_pitfalls]

} // namespace cookbook
