#pragma once

/// \file
/// \brief The angle between two vectors: right for every angle and every size.

#include "01_math/numbers/difference_of_products.hpp"
#include "01_math/plain_vectors/plain_vectors.hpp"
#include "01_math/vectors/power_of_two.hpp"
#include "common/math/norm.hpp"
#include "common/math/trigonometry.hpp"
#include "common/math/wide.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace cookbook
{

// [angle_acos]
/// The angle by the cosine, as it is published [rad]: not a number where rounding makes the cosine
/// more than 1.
template <class Real>
Real angle_acos(const Vector3<Real>& a, const Vector3<Real>& b)
{
  return std::acos(a.dot(b) / std::sqrt(a.squaredNorm() * b.squaredNorm()));
}

/// The angle by the cosine of unit vectors, which is first brought back to [-1, 1] [rad].
template <class Real>
Real angle_clamped(const Vector3<Real>& a, const Vector3<Real>& b)
{
  return std::acos(std::clamp(a.normalized().dot(b.normalized()), Real(-1), Real(1)));
}
// [angle_acos]

// [angle_kahan]
/// The angle by Kahan's formula [rad]: half of it stands between the diagonals of a rhombus.
template <class Real>
Real angle_kahan(const Vector3<Real>& a, const Vector3<Real>& b)
{
  const Vector3<Real> p = a * b.norm(), q = b * a.norm();
  return Real(2) * arc_tangent<Real>((p - q).norm(), (p + q).norm());
}
// [angle_kahan]

// [angle_in_double]
/// The angle between vectors of ordinary size, or one of which is zero [rad].
///
/// The cross product loses digits where the vectors are nearly parallel: then it is formed with
/// care.
inline double angle_of_ordinary(const Vector3<double>& a, const Vector3<double>& b)
{
  // Adding 0 makes 0 of -0, for the arc tangent of (0, -0) is π.
  const double cosine = a.dot(b) + 0.0;
  const double sine = a.cross(b).norm();
  if (2 * sine < cosine)
  {
    const Vector3<double> p = a * 0x1p300, q = b * 0x1p300; // small products keep their digits
    return arc_tangent(length<double>(accurate_cross<double>(p, q)), p.dot(q));
  }
  return arc_tangent(sine, cosine);
}
// [angle_in_double]

// [angle]
/// The angle between two vectors, from 0 to π [rad]; M5. Zero if one of them is zero.
///
/// Within 12 u of itself, or the smallest number, for all finite vectors, however small the angle
/// and whatever their lengths.
template <class Real>
Real angle(const Vector3<Real>& a, const Vector3<Real>& b)
{
  if constexpr (std::is_same_v<Real, float>)
  {
    // In double the products are exact, no square overflows, and only zero vectors make zeros.
    const Vector3<double> p = widen(a), q = widen(b);
    return static_cast<float>(arc_tangent(p.cross(q).norm(), p.dot(q) + 0.0));
  }
  else
  {
    const bool ordinary = is_ordinary(a.squaredNorm()) && is_ordinary(b.squaredNorm());
    return ordinary ? angle_of_ordinary(a, b)
                    : angle_of_ordinary(scaled<double>(a).v, scaled<double>(b).v);
  }
}
// [angle]

// [signed_angle]
/// The angle that turns `a` to `b`, from -π to π [rad]: positive where it turns counter-clockwise
/// seen from the tip of `axis`.
///
/// The axis may have any length. Where it is perpendicular to a × b, as the zero vector is, the
/// angle is positive. Where it is that to rounding, or a × b is below the smallest number, either
/// sign may be.
template <class Real>
Real signed_angle(const Vector3<Real>& a, const Vector3<Real>& b, const Vector3<Real>& axis)
{
  const Vector3<double> p = a.template cast<double>(), q = b.template cast<double>();
  const Vector3<double> n = axis.template cast<double>();
  double side; // of the turn, seen along the axis
  if constexpr (std::is_same_v<Real, float>)
  {
    side = n.dot(p.cross(q)); // the cross product's products are exact, and all fit
  }
  else
  {
    const Vector3<double> turn = accurate_cross<double>(enlarged(p), enlarged(q));
    side = scaled<double>(n).v.dot(scaled<double>(turn).v);
  }
  const Real size = angle<Real>(a, b);
  return side < 0 ? -size : size;
}
// [signed_angle]

// [equal]
/// Whether two vectors differ by no more than a few roundings of numbers as large as `size`.
///
/// The size is that of what both were computed from [unit of the vectors]: the difference of two
/// vectors does not know how large its terms were.
template <class Real>
bool equal_within_roundings(const Vector3<Real>& a, const Vector3<Real>& b, Real size)
{
  const Real allowed = Real(4) * std::numeric_limits<Real>::epsilon() * size;
  return (a - b).cwiseAbs().maxCoeff() <= allowed;
}
// [equal]

} // namespace cookbook
