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
/// Where a path first meets a box along the axes: the part of it that lies in all three slabs; P10.
///
/// An empty box, whose least corner is beyond its greatest, meets nothing.
template <class Real>
std::optional<Hit<Real, 3>> first_hit_on(const CastPath<Real>& path, const Aabb<Real>& box)
{
  const Real infinite = std::numeric_limits<Real>::infinity();
  Vector3<Real> in, out;
  for (int i = 0; i < 3; ++i)
  {
    const Real to_min = box.min()[i] - path.origin[i], to_max = box.max()[i] - path.origin[i];
    const Real way = path.direction[i];
    in[i] = (way > Real(0) ? to_min : to_max) / way;
    out[i] = (way > Real(0) ? to_max : to_min) / way;
    if (way == Real(0)) // along the slab: always in it, or never
    {
      in[i] = to_min <= Real(0) && to_max >= Real(0) ? -infinite : infinite;
      out[i] = infinite;
    }
  }
  const Real enter = std::max({in.x(), in.y(), in.z()}),
             leave = std::min({out.x(), out.y(), out.z()});
  if (!(enter <= leave) || !(leave >= Real(0)) || enter == infinite)
  {
    return std::nullopt;
  }
  if (enter <= Real(0))
  {
    return hit_from_inside(path);
  }
  const int face = in.x() == enter ? 0 : in.y() == enter ? 1 : 2;
  Vector3<Real> normal = Vector3<Real>::Zero();
  normal[face] = path.direction[face] > Real(0) ? Real(-1) : Real(1);
  const Vector3<Real> point = point_at<Real>(path, enter).cwiseMax(box.min()).cwiseMin(box.max());
  return hit_at<Real>(path, enter, normal, point);
}
// [cast_box]

// [cast_obb]
/// Where a path first meets a turned box: the same, seen from the box.
template <class Real>
std::optional<Hit<Real, 3>> first_hit_on(const CastPath<Real>& path, const Obb<Real>& box)
{
  CastPath<Real> seen = path;
  seen.origin = box.axes.transpose() * (path.origin - box.center);
  seen.direction = box.axes.transpose() * path.direction;
  const auto hit = first_hit_on(seen, Aabb<Real>(-box.half_extents, box.half_extents));
  if (!hit || hit->t == Real(0))
  {
    return hit ? std::optional(hit_from_inside(path)) : std::nullopt;
  }
  return hit_at<Real>(path, hit->t, box.axes * hit->normal, box.center + box.axes * hit->point);
}
// [cast_obb]

} // namespace cookbook
