#pragma once

/// \file
/// \brief Two more ways to step a free spin: Runge and Kutta's, and one axis after the other.

#include "05_resolution/spinning_bodies/gyroscopic_terms.hpp"

namespace cookbook
{

/// How orientation and spin of a body change.
template <class Real>
struct SpinRate
{
  Eigen::Matrix<Real, 4, 1> orientation; ///< [1/s], x, y, z, w
  Vector3<Real> spin;                    ///< [rad/s²], along the body's axes
};

/// The change of a body with this orientation, x, y, z, w, and this spin [rad/s] along its axes.
template <class Real>
SpinRate<Real> spin_rate(
    const Vector3<Real>& moments, const Eigen::Matrix<Real, 4, 1>& orientation,
    const Vector3<Real>& spin)
{
  const Quaternion<Real> now(orientation);
  const Quaternion<Real> half_spin(0, spin.x() / 2, spin.y() / 2, spin.z() / 2);
  return {(now * half_spin).coeffs(), gyroscopic_acceleration(moments, spin)};
}

/// The classical method of Runge and Kutta, of fourth order: keeps neither momentum nor energy.
template <class Real>
Spinning<Real> runge_kutta_spin(const Spinning<Real>& body, const Vector3<Real>& moments, Real step)
{
  const Eigen::Matrix<Real, 4, 1> q = body.orientation.coeffs();
  const Vector3<Real> w = own_spin(body);
  const auto after = [&](const SpinRate<Real>& rate, Real time) -> SpinRate<Real>
  { return spin_rate<Real>(moments, q + time * rate.orientation, w + time * rate.spin); };
  const SpinRate<Real> a = spin_rate<Real>(moments, q, w);
  const SpinRate<Real> b = after(a, step / 2);
  const SpinRate<Real> c = after(b, step / 2);
  const SpinRate<Real> d = after(c, step);
  const Real sixth = step / 6;
  const Vector3<Real> spin = w + sixth * (a.spin + 2 * b.spin + 2 * c.spin + d.spin);
  const Quaternion<Real> orientation(Eigen::Matrix<Real, 4, 1>(
      q + sixth * (a.orientation + 2 * b.orientation + 2 * c.orientation + d.orientation)));
  return {orientation.normalized(), orientation.normalized() * spin};
}

/// The body's axes one after the other, x, y, z, y, x: keeps the angular momentum, and the energy
/// of some bodies only.
template <class Real>
Spinning<Real> axes_in_turn(const Spinning<Real>& body, const Vector3<Real>& moments, Real step)
{
  Tumbling<Real> now{body.orientation, moments.cwiseProduct(own_spin(body))};
  for (const Eigen::Index axis : {0, 1, 2, 1, 0})
  {
    const Real time = axis == 2 ? step : step / 2;
    now = turned_about<Real>(now, {axis, 1 / moments[axis]}, time);
  }
  const Quaternion<Real> orientation = now.orientation.normalized();
  return {orientation, orientation * now.momentum.cwiseQuotient(moments)};
}

} // namespace cookbook
