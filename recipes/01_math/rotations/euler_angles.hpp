#pragma once

/// \file
/// \brief Axis and angle, and three angles, to a rotation matrix; and the three angles back.

#include "common/math/norm.hpp"
#include "common/math/trigonometry.hpp"

#include <cmath>
#include <limits>

namespace cookbook
{

// [rotation_about]
/// The rotation by an angle [rad] about an axis of any length, counter-clockwise as seen from the
/// axis's tip; M8. About the zero vector nothing turns.
template <class Real>
Matrix3<Real> rotation_about(const Vector3<Real>& axis, const Real& angle)
{
  const Vector3<Real> k = normalize<Real>(axis, Vector3<Real>::Zero()).unit;
  if (k.isZero(0))
  {
    return Matrix3<Real>::Identity();
  }
  // 1 + sin θ K + (1 - cos θ) K², where K² is the matrix of all products of two parts of k, less 1.
  const auto [s, c] = sine_cosine<Real>(angle);
  const Real versine = Real(1) - c;
  const Real x = versine * k.x(), y = versine * k.y(), z = versine * k.z();
  const Vector3<Real> v = s * k;
  Matrix3<Real> r;
  r << x * k.x() + c, x * k.y() - v.z(), x * k.z() + v.y(), //
      x * k.y() + v.z(), y * k.y() + c, y * k.z() - v.x(),  //
      x * k.z() - v.y(), y * k.z() + v.x(), z * k.z() + c;
  return r;
}
// [rotation_about]

/// Three angles [rad] of an orientation: about y, about the x that this turned, about the z that
/// both turned.
template <class Real>
struct EulerAngles
{
  Real heading; ///< about y, where the nose points
  Real pitch;   ///< about x, how far it points up
  Real roll;    ///< about z, how far the wings lean
};

// [from_euler_angles]
/// The rotation of three angles: Ry(heading) Rx(pitch) Rz(roll).
template <class Real>
Matrix3<Real> from_euler_angles(const EulerAngles<Real>& angles)
{
  using Axis = Vector3<Real>;
  return rotation_about<Real>(Axis::UnitY(), angles.heading) *
         rotation_about<Real>(Axis::UnitX(), angles.pitch) *
         rotation_about<Real>(Axis::UnitZ(), angles.roll);
}
// [from_euler_angles]

// [euler_angles]
/// The three angles of a rotation, the pitch from -π/2 to π/2, the others from -π to π.
///
/// Straight up or down, to within four roundings, heading and roll turn about one axis: the heading
/// is 0 there, and the roll all of it. The roll is what is left once the heading is undone, so that
/// the three angles give the rotation again, to rounding, however near that is.
template <class Real>
EulerAngles<Real> euler_angles(const Matrix3<Real>& r)
{
  using std::sqrt;
  const Real level = sqrt(r(0, 2) * r(0, 2) + r(2, 2) * r(2, 2));
  const bool locked = level <= Real(4) * std::numeric_limits<Real>::epsilon();
  const Real heading = locked ? Real(0) : arc_tangent<Real>(r(0, 2), r(2, 2));
  const auto [s, c] = sine_cosine<Real>(heading);
  const Real roll = arc_tangent<Real>(s * r(2, 1) - c * r(0, 1), c * r(0, 0) - s * r(2, 0));
  return {heading, arc_tangent<Real>(-r(1, 2), level), roll};
}
// [euler_angles]

} // namespace cookbook
