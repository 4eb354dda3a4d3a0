#pragma once

/// \file
/// \brief Ways to move a particle that are wrong, kept to be asserted to fail.

#include "05_resolution/integrators/trial/spring.hpp"

namespace cookbook
{

// [verlet_as_published]
/// A particle that remembers where it was a step ago instead of how fast it moves.
template <class Place>
struct PositionPair
{
  Place now;    ///< [m]
  Place before; ///< [m], one step ago
};

/// One step that adds the force [N], not the acceleration: right for a mass of 1 kg only.
///
/// A particle let go from rest, with both positions the same, also gets a whole step's fall where
/// half of it is due.
template <class Place, class Real>
PositionPair<Place>
verlet_as_published(const PositionPair<Place>& from, const Place& force, const Real& step)
{
  return {from.now + (from.now - from.before) + step * step * force, from.now};
}
// [verlet_as_published]

// [spring_as_published]
/// The change of velocity [m/s] that a spring makes in one step, whatever the step's length.
///
/// Its damper asks how fast the end moves, not which way: it brakes a spring that lengthens and
/// drives one that shortens. An arm of length zero makes it not a number.
template <class Real>
Vector3<Real> spring_as_published(
    const Spring<Real>& spring, const Vector3<Real>& arm, const Vector3<Real>& velocity)
{
  const Real stretch = arm.norm() - spring.rest_length;
  const Real push = -(spring.stiffness * stretch + spring.damping * velocity.norm());
  return push * (arm / arm.norm());
}
// [spring_as_published]

} // namespace cookbook
