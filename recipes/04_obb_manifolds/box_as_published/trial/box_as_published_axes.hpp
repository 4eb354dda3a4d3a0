#pragma once

/// \file
/// \brief Whether, which way and how deep two boxes overlap, as the seed book's published code has
/// it.

#include "04_obb_manifolds/separating_axes/separating_axes.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace cookbook
{

// [published_faults]
/// Which faults are in; all of them as published, each can be mended alone.
struct PublishedFaults
{
  bool crosses_a_with_a = true;  ///< X08: cross products of A's axes with A's, none with B's
  bool erases_negatives = true;  ///< X09: a component below 1e-6 becomes 0, so each negative one
  bool casts_a_twice = true;     ///< X10: the yes-or-no test compares A's projection with A's
  bool measures_union = true;    ///< X11: depth as lengths of projections less the whole they cover
  bool turns_by_begin = true;    ///< X12: normal turned round where B's projection begins first
  bool drops_touching = true;    ///< X13: depth 0 is no contact
  bool drops_short_axes = true;  ///< X14: cross products of squared length below 1e-3 left out
  bool tests_points_bare = true; ///< X15: points where edges pass planes, tested without tolerance
  bool merges_within_1_cm = true; ///< X16: points 1 cm apart are one, whatever the boxes' size
  bool forgets_features = true;   ///< X17: a point does not know what met there
};

/// Every fault mended.
inline constexpr PublishedFaults no_faults{false, false, false, false, false,
                                           false, false, false, false, false};
// [published_faults]

// [published_axes]
/// The fifteen directions to try, of any length, zero for those left out: X08, X09, X14.
template <class Real>
std::array<Vector3<Real>, 15>
published_axes(const Obb<Real>& a, const Obb<Real>& b, const PublishedFaults& faults)
{
  std::array<Vector3<Real>, 15> axes;
  for (int i = 0; i < 3; ++i)
  {
    axes[std::size_t(i)] = a.axes.col(i);
    axes[std::size_t(3 + i)] = b.axes.col(i);
    for (int j = 0; j < 3; ++j)
    {
      const Vector3<Real> other = faults.crosses_a_with_a ? a.axes.col(j) : b.axes.col(j);
      axes[std::size_t(6 + 3 * i + j)] = a.axes.col(i).cross(other);
    }
  }
  const Real sine = std::numeric_limits<Real>::epsilon();
  for (Vector3<Real>& axis : axes)
  {
    const Vector3<Real> kept = (axis.array() < Real(1e-6)).select(Real(0), axis);
    axis = faults.erases_negatives ? kept : axis;
    const bool short_axis =
        axis.squaredNorm() < (faults.drops_short_axes ? Real(1e-3) : sine * sine);
    axis = short_axis ? Vector3<Real>::Zero() : axis;
  }
  return axes;
}
// [published_axes]

// [published_overlap]
/// The interval that a box's projection covers along a unit vector.
template <class Real>
struct Projection
{
  Real begin; ///< [m]
  Real end;   ///< [m]
};

/// A box's projection, seen from a point.
template <class Real>
Projection<Real>
projection(const Obb<Real>& box, const Vector3<Real>& from, const Vector3<Real>& unit)
{
  const Real middle = unit.dot(box.center - from);
  const Real radius = (box.axes.transpose() * unit).cwiseAbs().dot(box.half_extents);
  return {middle - radius, middle + radius};
}

/// The published yes-or-no test; X08, X10.
template <class Real>
bool overlap_as_published(
    const Obb<Real>& a, const Obb<Real>& b, const PublishedFaults& faults = {})
{
  const std::array<Vector3<Real>, 15> axes = published_axes(a, b, faults);
  const Obb<Real>& second = faults.casts_a_twice ? a : b;
  return std::all_of(
      axes.begin(), axes.end(),
      [&](const Vector3<Real>& axis)
      {
        const Projection<Real> of_a = projection<Real>(a, a.center, axis);
        const Projection<Real> of_b = projection<Real>(second, a.center, axis);
        return of_b.begin <= of_a.end && of_a.begin <= of_b.end;
      });
}

/// How far two projections overlap, and the unit vector turned the way that is taken for A to B;
/// X11, X12.
template <class Real>
LeastOverlap<Real> published_overlap(
    const Obb<Real>& a, const Obb<Real>& b, const Vector3<Real>& unit,
    const PublishedFaults& faults)
{
  const Projection<Real> of_a = projection(a, a.center, unit), of_b = projection(b, a.center, unit);
  const Real lengths = of_a.end - of_a.begin + of_b.end - of_b.begin;
  const Real whole = std::max(of_a.end, of_b.end) - std::min(of_a.begin, of_b.begin);
  const Real mtv_length = std::min(of_a.end - of_b.begin, of_b.end - of_a.begin);
  const bool back = faults.turns_by_begin ? of_b.begin < of_a.begin
                                          : of_b.begin + of_b.end < of_a.begin + of_a.end;
  return {
      back ? Vector3<Real>(-unit) : unit, faults.measures_union ? lengths - whole : mtv_length, -1};
}

/// The least of them; nothing where one is negative or, by X13, zero, or where the balls around the
/// boxes are apart, which is no fault.
template <class Real>
std::optional<LeastOverlap<Real>>
least_as_published(const Obb<Real>& a, const Obb<Real>& b, const PublishedFaults& faults = {})
{
  const Real radius = a.half_extents.norm() + b.half_extents.norm();
  if ((b.center - a.center).squaredNorm() > radius * radius)
  {
    return std::nullopt;
  }
  LeastOverlap<Real> least{Vector3<Real>::Zero(), std::numeric_limits<Real>::max(), -1};
  const std::array<Vector3<Real>, 15> axes = published_axes(a, b, faults);
  for (int axis = 0; axis < box_axes; ++axis)
  {
    if (axes[std::size_t(axis)].isZero(0))
    {
      continue;
    }
    const Vector3<Real> unit = axes[std::size_t(axis)].normalized();
    const LeastOverlap<Real> found = published_overlap(a, b, unit, faults);
    if (faults.drops_touching ? !(found.depth > Real(0)) : !(found.depth >= Real(0)))
    {
      return std::nullopt;
    }
    least = found.depth < least.depth ? LeastOverlap<Real>{found.normal, found.depth, axis} : least;
  }
  return least.axis < 0 ? std::nullopt : std::optional(least);
}
// [published_overlap]

} // namespace cookbook
