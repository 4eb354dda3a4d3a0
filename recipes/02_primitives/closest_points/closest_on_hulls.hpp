#pragma once

/// \file
/// \brief Where two shapes of corners and a radius are closest.

#include "02_primitives/closest_points/gjk_distance.hpp"
#include "02_primitives/closest_points/rounded_hull.hpp"
#include "02_primitives/shapes/answers.hpp"
#include "common/math/norm.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace cookbook
{

/// A point of each of two cores, the way from B's to A's, and what they are apart at least.
template <class Real>
struct CoreDistance
{
  Vector3<Real> a;          ///< [m]
  Vector3<Real> b;          ///< [m]
  Vector3<Real> difference; ///< [m], a − b, more exact than their difference
  Real least;               ///< [m], no two points are closer
};

/// Any two cores: GJK.
template <class Real, std::size_t SizeA, std::size_t SizeB>
CoreDistance<Real>
core_distance(const std::array<Vector3<Real>, SizeA>& a, const std::array<Vector3<Real>, SizeB>& b)
{
  const GjkDistance<Real> gjk = gjk_distance<Real>(Corners<Real>(a), Corners<Real>(b));
  CoreDistance<Real> distance{
      Vector3<Real>::Zero(), Vector3<Real>::Zero(), gjk.difference, gjk.least};
  for (std::size_t k = 0; k < gjk.pairs.size; ++k)
  {
    distance.a += gjk.weights[Eigen::Index(k)] * a[gjk.pairs.of_a[k]];
    distance.b += gjk.weights[Eigen::Index(k)] * b[gjk.pairs.of_b[k]];
  }
  return distance;
}

/// Two points.
template <class Real>
CoreDistance<Real>
core_distance(const std::array<Vector3<Real>, 1>& a, const std::array<Vector3<Real>, 1>& b)
{
  const Vector3<Real> difference = a[0] - b[0];
  return {a[0], b[0], difference, difference.norm()};
}

/// A point and a segment or a triangle.
template <class Real, std::size_t Size>
requires(Size == 2 || Size == 3) CoreDistance<Real> core_distance(
    const std::array<Vector3<Real>, 1>& a, const std::array<Vector3<Real>, Size>& b)
{
  std::array<Vector3<Real>, Size> from_a;
  for (std::size_t i = 0; i < Size; ++i)
  {
    from_a[i] = b[i] - a[0];
  }
  const Nearest<Real> nearest = nearest_on_simplex(from_a.data(), int(Size));
  return {a[0], a[0] + nearest.point, -nearest.point, nearest.point.norm()};
}

/// Two segments.
template <class Real>
CoreDistance<Real>
core_distance(const std::array<Vector3<Real>, 2>& a, const std::array<Vector3<Real>, 2>& b)
{
  const ClosestFractions<Real> at = closest_fractions<Real>({a[0], a[1]}, {b[0], b[1]});
  const Vector3<Real> on_a = a[0] + at.on_a * (a[1] - a[0]);
  return {on_a, on_a - at.difference, at.difference, at.difference.norm()};
}

// [closest_on_hulls]
/// The largest of a hull's numbers [m], without sign.
template <class Real, int Size>
Real largest_of(const RoundedHull<Real, Size>& hull)
{
  Real size = hull.radius;
  for (const Vector3<Real>& corner : hull.corners)
  {
    size = std::max(size, corner.cwiseAbs().maxCoeff());
  }
  return size;
}

/// Shapes that are closer than this fraction of their largest number may touch, but for rounding.
template <class Real>
inline const Real touching = Real(8) * std::numeric_limits<Real>::epsilon();

/// Where two hulls are closest. Touching to rounding is touching.
template <class Real, int SizeA, int SizeB>
ClosestPoints<Real, 3>
closest_on_hulls(const RoundedHull<Real, SizeA>& a, const RoundedHull<Real, SizeB>& b)
{
  const CoreDistance<Real> cores = core_distance(a.corners, b.corners);
  const Real radii = a.radius + b.radius;
  const Real contact = radii + touching<Real> * std::max(largest_of(a), largest_of(b));
  const Direction<Real> to_a = normalize<Real>(cores.difference);
  // Apart only with a direction that separates.
  if (to_a.length > contact &&
      (cores.least > contact || largest_separation<Real>(a.corners, b.corners) > contact))
  {
    return {cores.a - a.radius * to_a.unit, cores.b + b.radius * to_a.unit, to_a.length - radii};
  }
  // Midway through what lies in both, on the way between the cores.
  const Real first = std::max(to_a.length - b.radius, Real(0));
  const Real last = std::min(a.radius, to_a.length);
  const Vector3<Real> both = cores.a - (first + last) / Real(2) * to_a.unit;
  return {both, both, Real(0)};
}
// [closest_on_hulls]

} // namespace cookbook
