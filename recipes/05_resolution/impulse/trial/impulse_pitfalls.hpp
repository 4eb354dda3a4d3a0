#pragma once

/// \file
/// \brief Four ways to resolve a collision that are wrong, kept to be asserted to fail.

#include "05_resolution/impulse/bounce.hpp"

#include <cmath>

namespace cookbook
{

// [bounce_divided]
/// A bounce that gives each of n points an n-th of its own impulse, in turn, pass by pass.
///
/// The n-th would be right if one impulse were shared, once. Here each point measures again what
/// the others left, so that n points in one place scale the speed by (1 − (1+e)/n) each time.
template <class Real, std::size_t Capacity>
BodyPair<Real> bounce_divided(
    BodyPair<Real> bodies, const Manifold<Real, Capacity>& manifold, Real restitution, int passes)
{
  const Real count = Real(static_cast<int>(manifold.points.size()));
  for (int pass = 0; pass < passes; ++pass)
  {
    for (const ContactPoint<Real>& point : manifold.points)
    {
      const Arms<Real> arms = arms_to(bodies, point.position);
      const Real whole = bounce_impulse(bodies.a, bodies.b, manifold.normal, arms, restitution);
      apply_impulse<Real>(bodies.a, bodies.b, arms, whole / count * manifold.normal);
    }
  }
  return bodies;
}
// [bounce_divided]

// [inverse_inertia_pitfalls]
/// The inverse inertia of a body as if it were never turned: right only while its axes are the
/// world's.
template <class Real>
Matrix3<Real> unturned_inverse_inertia(const Vector3<Real>& moments, const Matrix3<Real>&)
{
  return moments.cwiseInverse().asDiagonal();
}

/// An inverse that takes every matrix with a small determinant for a singular one and answers with
/// the identity; a determinant of inertia is small for every light or small body.
template <class Real>
Matrix3<Real> threshold_inverse(const Matrix3<Real>& matrix, Real threshold)
{
  using std::abs;
  if (abs(matrix.determinant()) < threshold)
  {
    return Matrix3<Real>::Identity();
  }
  return matrix.inverse();
}
// [inverse_inertia_pitfalls]

// [pushed_regardless]
/// A body after an impulse [N s] that is added to its velocity [m/s] as if the mass were one.
template <class Real>
Body<Real> pushed_regardless(Body<Real> body, const Vector3<Real>& impulse)
{
  body.motion.velocity += impulse;
  return body;
}
// [pushed_regardless]

} // namespace cookbook
