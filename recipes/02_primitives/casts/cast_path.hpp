#pragma once

/// \file
/// \brief A ray or a segment on its way: what every cast starts from and ends with.

#include "01_math/vectors/power_of_two.hpp"
#include "02_primitives/shapes/answers.hpp"
#include "02_primitives/shapes/shapes.hpp"
#include "common/math/norm.hpp"
#include "common/math/wide.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

namespace cookbook
{

// [cast_path]
/// A ray or a segment in the number type that casts compute in.
///
/// Only where products of its numbers would leave that type's range are they divided by powers of
/// two: lengths by 2^`size`, and the direction so that t is 2^`time` times what is computed.
template <class Real>
struct CastPath
{
  Vector3<Real> origin;    ///< [m / 2^size]
  Vector3<Real> direction; ///< of any length; from start to end of a segment
  bool ends;               ///< true for a segment, where t is at most 1
  int size = 0;            ///< exponent of the power of two that was taken out of all lengths
  int time = 0;            ///< exponent of the power of two that was taken out of t
};

/// What a cast that starts inside answers: t = 0, the origin, and the unit vector against the
/// direction; +y if the direction is zero.
template <class Real>
Hit<Real, 3> hit_from_inside(const CastPath<Real>& path)
{
  return {Real(0), path.origin, normalize<Real>(-path.direction).unit};
}

/// The point that is reached at `t`; also at an infinite t it stays where it does not move.
template <class Real>
Vector3<Real> point_at(const CastPath<Real>& path, const Real& t)
{
  Vector3<Real> point = path.origin + t * path.direction;
  if (!(t <= std::numeric_limits<Real>::max()))
  {
    point = (path.direction.array() == Real(0)).select(path.origin, point);
  }
  return point;
}

/// A hit at `t`, unless the path ends before it, or t is less than 0 or not a number.
template <class Real>
std::optional<Hit<Real, 3>> hit_at(
    const CastPath<Real>& path, const Real& t, const Vector3<Real>& normal,
    const Vector3<Real>& point)
{
  const Real end = path.time == 0 ? Real(1) : std::ldexp(Real(1), -path.time);
  const bool reached = t >= Real(0) && (!path.ends || t <= end);
  return reached ? std::optional(Hit<Real, 3>{t, point, normal}) : std::nullopt;
}

/// The same, where the point is no better known than as that of the path.
template <class Real>
std::optional<Hit<Real, 3>>
hit_at(const CastPath<Real>& path, const Real& t, const Vector3<Real>& normal)
{
  return hit_at<Real>(path, t, normal, point_at<Real>(path, t));
}
// [cast_path]

} // namespace cookbook
