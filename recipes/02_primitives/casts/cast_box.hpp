#pragma once

/// \file
/// \brief Where a path first meets a box, along the axes or turned.

#include "02_primitives/casts/cast_path.hpp"
#include "02_primitives/shapes/more_shapes.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace cookbook
{

// [cast_box]
/// The part of a path that lies between two planes perpendicular to an axis: from `in` to `out`.
template <class Real>
struct SlabSpan
{
  Real in;  ///< [1], where it enters
  Real out; ///< [1], where it leaves
};

/// The part between `least` and `most`, for a path from `origin` that goes `way` along the axis.
template <class Real>
SlabSpan<Real>
slab_span(const Real& least, const Real& most, const Real& origin, const Real& direction)
{
  const Real infinite = std::numeric_limits<Real>::infinity();
  const Real to_least = least - origin, to_most = most - origin;
  if (direction == Real(0)) // along the slab: always in it, or never
  {
    return {to_least <= Real(0) && to_most >= Real(0) ? -infinite : infinite, infinite};
  }
  const Real one = to_least / direction, other = to_most / direction;
  return {std::min(one, other), std::max(one, other)};
}

/// Where a path first meets a box along the axes: the part of it that lies in all three slabs; P10.
///
/// An empty box, whose least corner is beyond its greatest, meets nothing.
template <class Real>
std::optional<Hit<Real, 3>> first_hit_on(const CastPath<Real>& path, const Aabb<Real>& box)
{
  const Vector3<Real>&least = box.min(), &most = box.max(), &o = path.origin, &d = path.direction;
  const SlabSpan<Real> x = slab_span<Real>(least.x(), most.x(), o.x(), d.x());
  const SlabSpan<Real> y = slab_span<Real>(least.y(), most.y(), o.y(), d.y());
  const SlabSpan<Real> z = slab_span<Real>(least.z(), most.z(), o.z(), d.z());
  const Real enter = std::max(std::max(x.in, y.in), z.in);
  const Real leave = std::min(std::min(x.out, y.out), z.out);
  const bool meets =
      enter <= leave && leave >= Real(0) && enter < std::numeric_limits<Real>::infinity();
  if (!meets || box.isEmpty())
  {
    return std::nullopt;
  }
  if (enter <= Real(0))
  {
    return hit_from_inside(path);
  }
  const bool on_x = x.in == enter, on_y = !on_x && y.in == enter, on_z = !on_x && !on_y;
  const auto against = [](bool on, const Real& direction)
  { return Real(on ? (direction > Real(0) ? -1 : 1) : 0); };
  const Vector3<Real> normal(against(on_x, d.x()), against(on_y, d.y()), against(on_z, d.z()));
  const Vector3<Real> point = point_at<Real>(path, enter).cwiseMax(least).cwiseMin(most);
  return hit_at<Real>(path, enter, normal, point);
}
// [cast_box]

// [cast_obb]
/// Where a path first meets an oriented box: the same, seen from the box.
template <class Real>
std::optional<Hit<Real, 3>> first_hit_on(const CastPath<Real>& path, const Obb<Real>& box)
{
  const Vector3<Real> x = box.axes.col(0), y = box.axes.col(1), z = box.axes.col(2);
  const Vector3<Real> origin = path.origin - box.center, &direction = path.direction;
  CastPath<Real> seen = path;
  seen.origin = {x.dot(origin), y.dot(origin), z.dot(origin)};
  seen.direction = {x.dot(direction), y.dot(direction), z.dot(direction)};
  const auto hit = first_hit_on(seen, Aabb<Real>(-box.half_extents, box.half_extents));
  if (!hit || hit->t == Real(0))
  {
    return hit ? std::optional(hit_from_inside(path)) : std::nullopt;
  }
  const auto to_world = [&](const Vector3<Real>& v) -> Vector3<Real>
  { return v.x() * x + v.y() * y + v.z() * z; };
  return hit_at<Real>(path, hit->t, to_world(hit->normal), box.center + to_world(hit->point));
}
// [cast_obb]

} // namespace cookbook
