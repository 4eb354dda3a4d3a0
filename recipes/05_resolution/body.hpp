#pragma once

/// \file
/// \brief Bodies that can be pushed and turned: mass, moments of inertia, motion.

#include "03_sphere_manifolds/collision.hpp"

namespace cookbook
{

// [inertia]
/// How hard a solid is to push, and to turn about each of its own axes.
template <class Real>
struct MassProperties
{
  Real mass;             ///< [kg], greater than zero
  Vector3<Real> moments; ///< [kg m²], about the centre of mass, along the body's axes; above zero
};

/// A solid ball of even density: mass [kg], radius [m]; R26.
template <class Real>
MassProperties<Real> solid_sphere(Real mass, Real radius)
{
  const Real moment = Real(2) / Real(5) * mass * radius * radius;
  return {mass, Vector3<Real>::Constant(moment)};
}

/// A solid box of even density: mass [kg], half extents [m]; R26.
template <class Real>
MassProperties<Real> solid_box(Real mass, const Vector3<Real>& half_extents)
{
  const Vector3<Real> squares = half_extents.cwiseProduct(half_extents);
  const Vector3<Real> others(
      squares.y() + squares.z(), squares.z() + squares.x(), squares.x() + squares.y());
  return {mass, others * (mass / Real(3))};
}
// [inertia]

// [body]
/// A moving body, and how much a push changes its motion.
template <class Real>
struct Body
{
  Motion<Real> motion;           ///< how it moves now
  Real inverse_mass;             ///< [1/kg], zero where no push moves it
  Matrix3<Real> inverse_inertia; ///< [1/(kg m²)], world; zero where no push turns it
};

/// The inverse inertia [1/(kg m²)] in the world of a body whose axes are the columns of a matrix.
template <class Real>
Matrix3<Real> world_inverse_inertia(const Vector3<Real>& moments, const Matrix3<Real>& axes)
{
  return axes * moments.cwiseInverse().asDiagonal() * axes.transpose();
}

/// A body with these mass properties, turned so that its axes are the columns of a matrix.
template <class Real>
Body<Real> movable(
    const Motion<Real>& motion, const MassProperties<Real>& properties, const Matrix3<Real>& axes)
{
  return {motion, Real(1) / properties.mass, world_inverse_inertia(properties.moments, axes)};
}

/// A body at rest that nothing moves, such as the ground.
template <class Real>
Body<Real> immovable(const Vector3<Real>& center)
{
  const Vector3<Real> zero = Vector3<Real>::Zero();
  return {{center, zero, zero}, Real(0), Matrix3<Real>::Zero()};
}
// [body]

} // namespace cookbook
