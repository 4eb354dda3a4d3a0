#pragma once

/// \file
/// \brief Euler's equations with the angular velocity as the state: no gyroscopic term, an explicit
/// and an implicit one, the implicit midpoint, and what each of them keeps.

#include "05_resolution/spinning_bodies/cross_matrix.hpp"
#include "05_resolution/spinning_bodies/spinning_bodies.hpp"

#include <Eigen/LU>

namespace cookbook
{

// [gyroscopic_acceleration]
/// How fast [rad/s²] a free body's spin [rad/s] changes, both along its own axes; R24.
template <class Real>
Vector3<Real> gyroscopic_acceleration(const Vector3<Real>& moments, const Vector3<Real>& spin)
{
  const Vector3<Real> momentum = moments.cwiseProduct(spin);
  return momentum.cross(spin).cwiseQuotient(moments);
}
// [gyroscopic_acceleration]

// [explicit_term]
/// The spin [rad/s] of a body along its own axes.
template <class Real>
Vector3<Real> own_spin(const Spinning<Real>& body)
{
  return body.orientation.conjugate() * body.angular_velocity;
}

/// A body that gets a spin [rad/s] along its own axes, and turns with it for a step [s].
template <class Real>
Spinning<Real> spun(const Spinning<Real>& body, const Vector3<Real>& spin, Real step)
{
  const Vector3<Real> velocity = body.orientation * spin;
  const Vector3<Real> turn = step * velocity;
  return {(rotation_by(turn) * body.orientation).normalized(), velocity};
}

/// No gyroscopic term: the angular velocity stays as it is, and the angular momentum does not.
template <class Real>
Spinning<Real> without_term(const Spinning<Real>& body, const Vector3<Real>&, Real step)
{
  return spun<Real>(body, own_spin(body), step);
}

/// The explicit term: the change of the spin, as fast as it is at the start of the step.
template <class Real>
Spinning<Real> explicit_term(const Spinning<Real>& body, const Vector3<Real>& moments, Real step)
{
  const Vector3<Real> spin = own_spin(body);
  return spun<Real>(body, spin + step * gyroscopic_acceleration(moments, spin), step);
}

/// The explicit term, and the angular momentum brought back to its length.
template <class Real>
Spinning<Real> clamped_term(const Spinning<Real>& body, const Vector3<Real>& moments, Real step)
{
  const Vector3<Real> spin = own_spin(body);
  const Vector3<Real> next = spin + step * gyroscopic_acceleration(moments, spin);
  const Real before = moments.cwiseProduct(spin).norm();
  const Real after = moments.cwiseProduct(next).norm();
  return spun<Real>(body, after == Real(0) ? next : Vector3<Real>(next * (before / after)), step);
}
// [explicit_term]

// [implicit_term]
/// By how much I(ω − ω₀) + h ω × Iω changes with ω; R25.
template <class Real>
Matrix3<Real>
gyroscopic_jacobian(const Vector3<Real>& moments, const Vector3<Real>& spin, Real step)
{
  const Matrix3<Real> inertia = moments.asDiagonal();
  const Vector3<Real> momentum = moments.cwiseProduct(spin);
  return inertia + step * (cross_matrix(spin) * inertia - cross_matrix(momentum));
}

/// The spin at the end of an implicit step, by Newton's method from the spin at its start; R25.
template <class Real>
Vector3<Real>
implicit_spin(const Vector3<Real>& moments, const Vector3<Real>& start, Real step, int iterations)
{
  const Vector3<Real> relative = moments / moments.maxCoeff();
  Vector3<Real> spin = start;
  for (int i = 0; i < iterations; ++i)
  {
    const Vector3<Real> momentum = relative.cwiseProduct(spin);
    const Vector3<Real> missed = relative.cwiseProduct(spin - start) + step * spin.cross(momentum);
    spin -= gyroscopic_jacobian<Real>(relative, spin, step).partialPivLu().solve(missed);
  }
  return spin;
}

/// The implicit term, one step of Newton's method; R25.
template <class Real>
Spinning<Real> implicit_term(const Spinning<Real>& body, const Vector3<Real>& moments, Real step)
{
  return spun<Real>(body, implicit_spin<Real>(moments, own_spin(body), step, 1), step);
}
// [implicit_term]

// [implicit_midpoint]
/// The implicit midpoint: half an implicit step, solved to the end, and as far again.
template <class Real>
Spinning<Real>
implicit_midpoint(const Spinning<Real>& body, const Vector3<Real>& moments, Real step)
{
  const Vector3<Real> start = own_spin(body);
  const Vector3<Real> middle = implicit_spin<Real>(moments, start, step / 2, 4);
  const Vector3<Real> turn = step * middle;
  const Quaternion<Real> orientation = (body.orientation * rotation_by(turn)).normalized();
  return {orientation, orientation * Vector3<Real>(2 * middle - start)};
}
// [implicit_midpoint]

} // namespace cookbook
