#pragma once

/// \file
/// \brief What a collision keeps: momentum and angular momentum; and what it may lose: energy.

#include "05_resolution/impulse/body.hpp"

namespace cookbook
{

// [conserved]
/// What two bodies have in common: their sums.
template <class Real>
struct Conserved
{
  Vector3<Real> momentum;         ///< [kg m/s], world
  Vector3<Real> angular_momentum; ///< [kg m²/s], world, about the origin
  Real energy;                    ///< [J], of motion
};

/// What one body adds to the sums, with its mass [kg] and its inertia [kg m²] in the world.
template <class Real>
Conserved<Real>
conserved(const Motion<Real>& motion, const Real& mass, const Matrix3<Real>& inertia)
{
  const Vector3<Real> momentum = mass * motion.velocity;
  const Vector3<Real> spin = inertia * motion.angular_velocity;
  const Real twice = momentum.dot(motion.velocity) + spin.dot(motion.angular_velocity);
  return {momentum, motion.center.cross(momentum) + spin, twice / Real(2)};
}

/// The sums of two bodies.
template <class Real>
Conserved<Real> operator+(const Conserved<Real>& a, const Conserved<Real>& b)
{
  return {a.momentum + b.momentum, a.angular_momentum + b.angular_momentum, a.energy + b.energy};
}
// [conserved]

} // namespace cookbook
