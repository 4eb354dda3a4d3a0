#pragma once

/// \file
/// \brief Where a camera stands and which way it looks, for every eye, target and up.

#include "01_math/numbers/difference_of_products.hpp"
#include "01_math/transforms/transforms.hpp"
#include "01_math/vectors/power_of_two.hpp"
#include "common/math/norm.hpp"
#include "common/math/vector.hpp"

namespace cookbook
{

// [perpendicular_to_both]
/// The unit vector perpendicular to both, on the side of a × b; zero where they are parallel or
/// zero.
///
/// No threshold: the components of the cross product are right to two roundings, so that also
/// nearly parallel vectors have a direction, and only truly parallel ones have none.
inline Vector3<double> perpendicular_to_both(const Vector3<double>& a, const Vector3<double>& b)
{
  const Vector3<double> zero(0, 0, 0);
  return normalize<double>(accurate_cross<double>(enlarged(a), enlarged(b)), zero).unit;
}
// [perpendicular_to_both]

// [any_right]
/// What is to the right where `up` does not say: perpendicular to the view, and to the world's y
/// axis; for a view along y, the x axis.
inline Vector3<double> any_right(const Vector3<double>& forward)
{
  const Vector3<double> level = perpendicular_to_both(forward, Vector3<double>::UnitY());
  return level.isZero(0) ? Vector3<double>::UnitX() : level;
}
// [any_right]

// [look_at]
/// The pose of a camera at `eye` that looks at `target`: its x axis is right, y up, −z ahead.
///
/// Where the eye is at the target, it looks along −z. Where `up` is zero or parallel to the view,
/// the world's y axis is up; for a view along y, x is to the right.
template <class Real>
Isometry3<Real>
look_at(const Vector3<Real>& eye, const Vector3<Real>& target, const Vector3<Real>& up)
{
  using V = Vector3<double>;
  const V &from = eye.template cast<double>(), &to = target.template cast<double>();
  const V whole = to - from, ahead = whole.allFinite() ? whole : V(to / 2 - from / 2);
  const V forward = ahead.isZero(0) ? V(0, 0, -1) : ahead;
  const V by_up = perpendicular_to_both(forward, up.template cast<double>());
  const V right = by_up.isZero(0) ? any_right(forward) : by_up;
  const V back = normalize<double>(enlarged(-forward)).unit;
  Matrix3<double> axes;
  axes << right, normalize<double>(back.cross(right)).unit, back;
  return pose<Real>(axes.template cast<Real>(), eye);
}
// [look_at]

} // namespace cookbook
