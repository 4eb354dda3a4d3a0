#pragma once

/// \file
/// \brief Where a path first meets a sphere or a capsule.

#include "02_primitives/casts/cast_path.hpp"

namespace cookbook
{

// [hit_around]
/// A hit on what is round about a center: the point is moved on to the surface, for the path is
/// rounded as its whole length is, and the surface only as the radius.
template <class Real>
std::optional<Hit<Real, 3>> hit_around(
    const CastPath<Real>& path, const Real& t, const Vector3<Real>& center, const Real& radius)
{
  const Vector3<Real> out = point_at(path, t) - center;
  const Real distance = out.norm(), along = out.dot(path.direction);
  if (!(radius > Real(0)) || !(distance > Real(0)))
  {
    return hit_at<Real>(path, t, hit_from_inside(path).normal, center);
  }
  const Vector3<Real> point = center + (radius / distance) * out;
  if (along > Real(0)) // a path that grazes, rounded to one that leaves
  {
    const Vector3<Real> across = out - along / path.direction.squaredNorm() * path.direction;
    return hit_at<Real>(path, t, normalize<Real>(across, hit_from_inside(path).normal).unit, point);
  }
  return hit_at<Real>(path, t, out / distance, point);
}
// [hit_around]

// [cast_sphere]
/// Where a path first meets a ball; P9.
template <class Real>
std::optional<Hit<Real, 3>> first_hit_on(const CastPath<Real>& path, const Sphere<Real>& sphere)
{
  using std::sqrt;
  const Vector3<Real> to_center = sphere.center - path.origin;
  const Real outside = to_center.squaredNorm() - sphere.radius * sphere.radius;
  if (outside <= Real(0))
  {
    return hit_from_inside(path);
  }
  const Real along = to_center.dot(path.direction), squared = path.direction.squaredNorm();
  if (!(along > Real(0)))
  {
    return std::nullopt; // the ball is behind, or nothing moves
  }
  // From the centre to where the path comes closest to it.
  const Vector3<Real> across = (along / squared) * path.direction - to_center;
  const Real half_chord_squared = sphere.radius * sphere.radius - across.squaredNorm();
  if (half_chord_squared < Real(0))
  {
    return std::nullopt;
  }
  const Real t = outside / (along + sqrt(half_chord_squared * squared));
  return hit_around<Real>(path, t, sphere.center, sphere.radius);
}
// [cast_sphere]

// [cast_cylinder]
/// Where a path first meets the round side of a capsule, from outside its endless cylinder.
///
/// Seen along the axis this is a path that meets a circle: cross products with the axis leave out
/// what is along it, and turn and stretch the rest, all alike.
template <class Real>
std::optional<Hit<Real, 3>> hit_on_side(const CastPath<Real>& path, const Capsule<Real>& capsule)
{
  using std::sqrt;
  const Vector3<Real> axis = capsule.segment.end - capsule.segment.start;
  const Vector3<Real> to_start = capsule.segment.start - path.origin;
  const Vector3<Real> normal = path.direction.cross(axis), to_axis = to_start.cross(axis);
  const Real length_squared = axis.squaredNorm(), squared = normal.squaredNorm();
  const Real radius_squared = capsule.radius * capsule.radius, miss = to_start.dot(normal);
  const Real outside = to_axis.squaredNorm() - radius_squared * length_squared;
  const Real along = to_axis.dot(normal),
             half_chord_squared = radius_squared * squared - miss * miss;
  if (!(outside > Real(0)) || !(along > Real(0)) || half_chord_squared < Real(0))
  {
    return std::nullopt;
  }
  const Real t = outside / (along + sqrt(half_chord_squared) * sqrt(length_squared));
  const Vector3<Real> from_start = t * path.direction - to_start;
  const Real fraction = from_start.dot(axis) / length_squared;
  if (!(fraction >= Real(0)) || !(fraction <= Real(1)))
  {
    return std::nullopt;
  }
  return hit_around<Real>(path, t, capsule.segment.start + fraction * axis, capsule.radius);
}
// [cast_cylinder]

// [cast_capsule]
/// Whether a capsule holds a point; its surface counts.
template <class Real>
bool capsule_holds(const Capsule<Real>& capsule, const Vector3<Real>& point)
{
  const Vector3<Real> axis = capsule.segment.end - capsule.segment.start;
  const Vector3<Real> from_start = point - capsule.segment.start;
  const Real along = from_start.dot(axis), whole = axis.squaredNorm();
  const Real radius_squared = capsule.radius * capsule.radius;
  if (along > Real(0) && along < whole)
  {
    return from_start.cross(axis).squaredNorm() <= radius_squared * whole;
  }
  const Vector3<Real> from_end = along > Real(0) ? point - capsule.segment.end : from_start;
  return from_end.squaredNorm() <= radius_squared;
}

/// Where a path first meets a capsule: the first of its round side and its two balls.
template <class Real>
std::optional<Hit<Real, 3>> first_hit_on(const CastPath<Real>& path, const Capsule<Real>& capsule)
{
  if (capsule_holds<Real>(capsule, path.origin))
  {
    return hit_from_inside(path);
  }
  std::optional<Hit<Real, 3>> first = hit_on_side(path, capsule);
  for (const Vector3<Real>& center : {capsule.segment.start, capsule.segment.end})
  {
    const auto hit = first_hit_on(path, Sphere<Real>{center, capsule.radius});
    if (hit && (!first || hit->t < first->t))
    {
      first = hit;
    }
  }
  return first;
}
// [cast_capsule]

} // namespace cookbook
