#pragma once

/// \file
/// \brief The manifold of two boxes as the code published beside the seed book computes it, in our
/// own words, with its ten mistakes X08 … X17.

#include "04_obb_manifolds/box_as_published/trial/published_points.hpp"
#include "04_obb_manifolds/separating_axes/separating_axes.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

namespace cookbook
{

/// The most points: 24 edges that pass six planes each.
inline constexpr std::size_t most_published_points = 144;

// [published_axes]
/// An axis without its negative components, X09; zero if it is then shorter than √0.001, X14.
template <class Real>
Vector3<Real> published_axis(const Vector3<Real>& axis)
{
  const Vector3<Real> kept = (axis.array() < Real(1e-6)).select(Real(0), axis);
  return kept.squaredNorm() < Real(1e-3) ? Vector3<Real>::Zero() : kept;
}

/// The fifteen axes to try, zero for those left out; X08: A's axes are crossed with A's own.
template <class Real>
std::array<Vector3<Real>, 15> published_axes(const Obb<Real>& a, const Obb<Real>& b)
{
  std::array<Vector3<Real>, 15> axes;
  for (int i = 0; i < 3; ++i)
  {
    axes[std::size_t(i)] = published_axis<Real>(a.axes.col(i));
    axes[std::size_t(3 + i)] = published_axis<Real>(b.axes.col(i));
    for (int j = 0; j < 3; ++j)
    {
      axes[std::size_t(6 + 3 * i + j)] = published_axis<Real>(a.axes.col(i).cross(a.axes.col(j)));
    }
  }
  return axes;
}
// [published_axes]

// [published_overlap]
/// A box's projection on an axis, seen from a point: its begin and its end.
template <class Real>
std::pair<Real, Real>
projection(const Obb<Real>& box, const Vector3<Real>& from, const Vector3<Real>& axis)
{
  const Real middle = axis.dot(box.center - from);
  const Real radius = (box.axes.transpose() * axis).cwiseAbs().dot(box.half_extents);
  return {middle - radius, middle + radius};
}

/// The yes-or-no test. X10: it compares A's projection with A's, so that B is never asked.
template <class Real>
bool overlap_as_published(const Obb<Real>& a, const Obb<Real>&)
{
  const auto overlaps = [&](const Vector3<Real>& axis)
  {
    const auto of_a = projection(a, a.center, axis), of_b = of_a;
    return of_b.first <= of_a.second && of_a.first <= of_b.second;
  };
  const std::array<Vector3<Real>, 15> axes = published_axes(a, a);
  return std::all_of(axes.begin(), axes.end(), overlaps);
}

/// The overlap along an axis of length 1, and the axis turned to what is taken for A to B.
///
/// X11: both lengths less the whole that they cover. X12: turned back where B begins before A.
template <class Real>
LeastOverlap<Real>
published_overlap(const Obb<Real>& a, const Obb<Real>& b, const Vector3<Real>& unit)
{
  const auto [begin_a, end_a] = projection(a, a.center, unit);
  const auto [begin_b, end_b] = projection(b, a.center, unit);
  const Real lengths = end_a - begin_a + end_b - begin_b;
  const Real whole = std::max(end_a, end_b) - std::min(begin_a, begin_b);
  return {begin_b < begin_a ? Vector3<Real>(-unit) : unit, lengths - whole, -1};
}

/// The least overlap; nothing where one is negative or, X13, zero, or where the spheres around the
/// boxes are apart, which is no mistake.
template <class Real>
std::optional<LeastOverlap<Real>> least_as_published(const Obb<Real>& a, const Obb<Real>& b)
{
  const Real radius = a.half_extents.norm() + b.half_extents.norm();
  if ((b.center - a.center).squaredNorm() > radius * radius)
  {
    return std::nullopt;
  }
  LeastOverlap<Real> least{Vector3<Real>::Zero(), std::numeric_limits<Real>::max(), -1};
  for (const Vector3<Real>& axis : published_axes(a, b))
  {
    if (!axis.isZero(0))
    {
      const LeastOverlap<Real> found = published_overlap<Real>(a, b, axis.normalized());
      if (!(found.depth > Real(0)))
      {
        return std::nullopt;
      }
      least = found.depth < least.depth ? found : least;
    }
  }
  const bool none = least.depth == std::numeric_limits<Real>::max();
  return none ? std::nullopt : std::optional(least);
}
// [published_overlap]

// [box_as_published]
/// The published manifold of two boxes. X16: points closer than 1 cm are one, however small the
/// boxes are.
///
/// Boxes can overlap without a point: then `points` is empty. Every point has the whole depth.
template <class Real>
std::optional<Manifold<Real, most_published_points>>
box_as_published(const Obb<Real>& a, const Obb<Real>& b)
{
  const std::optional<LeastOverlap<Real>> least = least_as_published(a, b);
  if (!least)
  {
    return std::nullopt;
  }
  const auto& [normal, depth, axis] = *least;
  const Real radius = (a.axes.transpose() * normal).cwiseAbs().dot(a.half_extents);
  const Real middle = normal.dot(a.center) + radius - depth / Real(2);
  PublishedPoints<Real> points;
  add_bare_crossings(b, a, points);
  add_bare_crossings(a, b, points);
  for (ContactPoint<Real>& point : points)
  {
    point.position += (middle - normal.dot(point.position)) * normal;
    point.depth = depth;
  }
  Manifold<Real, most_published_points> manifold{normal, depth, {}};
  for (const ContactPoint<Real>& point : merged(points, Real(0.01)))
  {
    manifold.points.push_back(point);
  }
  return manifold;
}
// [box_as_published]

} // namespace cookbook
