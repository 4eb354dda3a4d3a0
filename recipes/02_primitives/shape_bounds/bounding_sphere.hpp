#pragma once

/// \file
/// \brief The smallest sphere around points in space, and around a shape.

#include "02_primitives/closest_points/closest_points.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace cookbook
{

/// The centre of the smallest sphere through 2, 3 or 4 points; nothing where they lie on a line, or
/// 4 of them in a plane.
template <class Real>
std::optional<Vector3<Real>> center_through(std::span<const Vector3<Real>> points)
{
  const Vector3<Real>& a = points[0];
  const Vector3<Real> b = points[1] - a;
  if (points.size() == 2)
  {
    return Vector3<Real>(a + b / 2);
  }
  const Vector3<Real> c = points[2] - a, b_c = b.cross(c);
  Vector3<Real> sum = c.squaredNorm() * b_c.cross(b) - b.squaredNorm() * b_c.cross(c);
  Real volume = b_c.squaredNorm();
  if (points.size() == 4)
  {
    const Vector3<Real> d = points[3] - a;
    sum = d.squaredNorm() * b_c + c.squaredNorm() * d.cross(b) + b.squaredNorm() * c.cross(d);
    volume = b_c.dot(d);
  }
  return volume == Real(0) ? std::nullopt : std::optional<Vector3<Real>>(a + sum / (2 * volume));
}

/// A sphere, and the points that it rests on.
template <class Real>
struct RestingSphere
{
  Vector3<Real> center;                ///< [m]
  Real squared;                        ///< [m²], of the radius
  std::array<Vector3<Real>, 4> points; ///< [m], on it; the first `count` are used
  std::size_t count;                   ///< 1 to 4
};

/// The smallest sphere around a new point and those that a smaller sphere rests on, tried in turn:
/// the new point and one, two or three of the others.
template <class Real>
RestingSphere<Real> sphere_with(const Vector3<Real>& point, const RestingSphere<Real>& smaller)
{
  RestingSphere<Real> best{point, std::numeric_limits<Real>::infinity(), {}, 0};
  for (unsigned chosen = 1; chosen < 1u << smaller.count; ++chosen)
  {
    RestingSphere<Real> sphere{point, Real(0), {point}, 1};
    for (std::size_t i = 0; i < smaller.count; ++i)
    {
      if ((chosen >> i & 1u) != 0 && sphere.count < 4)
      {
        sphere.points[sphere.count++] = smaller.points[i];
      }
    }
    const auto center =
        center_through<Real>(std::span<const Vector3<Real>>(sphere.points.data(), sphere.count));
    if (!center)
    {
      continue;
    }
    sphere.center = *center;
    sphere.squared = (point - *center).squaredNorm();
    for (std::size_t i = 0; i < smaller.count; ++i)
    {
      sphere.squared = std::max(sphere.squared, (smaller.points[i] - *center).squaredNorm());
    }
    best = sphere.squared < best.squared ? sphere : best;
  }
  return best;
}

/// The centre of the smallest sphere around points, of which there is at least one; P22.
///
/// The smallest sphere around all points rests on the one that is farthest outside of a smaller
/// one: so we take that in, and the sphere grows until it holds all.
template <class Real>
Vector3<Real> minimal_sphere_center(std::span<const Vector3<Real>> points)
{
  RestingSphere<Real> sphere{points[0], Real(0), {points[0]}, 1};
  while (true)
  {
    Vector3<Real> farthest = sphere.center;
    Real squared = sphere.squared;
    for (const Vector3<Real>& point : points)
    {
      const Real here = (point - sphere.center).squaredNorm();
      farthest = here > squared ? point : farthest;
      squared = std::max(squared, here);
    }
    const RestingSphere<Real> larger = sphere_with<Real>(farthest, sphere);
    if (!(squared > sphere.squared) || !(larger.squared > sphere.squared))
    {
      return sphere.center;
    }
    sphere = larger;
  }
}

/// The sphere about the centre of the smallest one around points, wider by `radius`; its own radius
/// is taken from the centre as it is rounded, and rounded upwards where it is computed wider.
template <class Real>
Sphere<Real> sphere_around(
    std::span<const Vector3<Wide<Real>>> points, const Wide<Real>& radius,
    const PairFrame<Wide<Real>>& frame)
{
  using W = Wide<Real>;
  const Vector3<Real> center = frame.out(minimal_sphere_center<W>(points)).template cast<Real>();
  W farthest(0);
  for (const Vector3<W>& point : points)
  {
    farthest = std::max(farthest, (point - frame.in(center)).norm());
  }
  const W all = (farthest + radius) / frame.scale;
  const Real rounded = static_cast<Real>(all);
  const bool below = W(rounded) < all;
  return {center, below ? std::nextafter(rounded, std::numeric_limits<Real>::infinity()) : rounded};
}

/// The smallest sphere around points, of which there is at least one; P22.
template <class Real>
Sphere<Real> minimal_sphere(std::span<const Vector3<Real>> points)
{
  using W = Wide<Real>;
  Aabb<Real> bounds;
  for (const Vector3<Real>& point : points)
  {
    bounds.extend(point);
  }
  const PairFrame<W> frame = pair_frame<Real>(points[0], bounds);
  std::vector<Vector3<W>> seen;
  for (const Vector3<Real>& point : points)
  {
    seen.push_back(frame.in(point));
  }
  return sphere_around<Real>(std::span<const Vector3<W>>(seen), W(0), frame);
}

/// The smallest sphere around a shape.
template <BoundedShape Shape>
Sphere<NumberOf<Shape>> bounding_sphere(const Shape& shape)
{
  using Real = NumberOf<Shape>;
  const PairFrame<Wide<Real>> frame = pair_frame<Real>(shape, shape);
  const auto hull = rounded_hull(shape, frame);
  return sphere_around<Real>(
      std::span<const Vector3<Wide<Real>>>(hull.corners), hull.radius, frame);
}

} // namespace cookbook
