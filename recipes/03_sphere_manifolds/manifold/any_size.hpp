#pragma once

/// \file
/// \brief Answers for shapes of any finite size, also where sums and squares of their numbers would
/// be infinite.

#include "02_primitives/shapes/shapes.hpp"
#include "03_sphere_manifolds/manifold/manifold.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cookbook
{

/// The largest of a sphere's numbers, without sign.
template <class Real>
Real largest(const Sphere<Real>& sphere)
{
  return std::max(sphere.center.cwiseAbs().maxCoeff(), sphere.radius);
}

/// A plane's distance from the origin, without sign.
template <class Real>
Real largest(const Plane<Real>& plane)
{
  return std::abs(plane.distance);
}

/// The largest of a capsule's numbers, without sign.
template <class Real>
Real largest(const Capsule<Real>& capsule)
{
  const Segment<Real>& segment = capsule.segment;
  return std::max(
      segment.start.cwiseAbs().cwiseMax(segment.end.cwiseAbs()).maxCoeff(), capsule.radius);
}

/// The largest of a box's lengths, without sign.
template <class Real>
Real largest(const Obb<Real>& box)
{
  return box.center.cwiseAbs().cwiseMax(box.half_extents).maxCoeff();
}

/// A vector times two to the power of `exponent`.
template <class Real>
Vector3<Real> scaled(const Vector3<Real>& v, int exponent)
{
  return v.unaryExpr([exponent](Real x) { return std::ldexp(x, exponent); });
}

/// A sphere times two to the power of `exponent`, seen from the origin.
template <class Real>
Sphere<Real> scaled(const Sphere<Real>& sphere, int exponent)
{
  return {scaled(sphere.center, exponent), std::ldexp(sphere.radius, exponent)};
}

/// A plane times two to the power of `exponent`, seen from the origin.
template <class Real>
Plane<Real> scaled(const Plane<Real>& plane, int exponent)
{
  return {plane.normal, std::ldexp(plane.distance, exponent)};
}

/// A capsule times two to the power of `exponent`, seen from the origin.
template <class Real>
Capsule<Real> scaled(const Capsule<Real>& capsule, int exponent)
{
  const Segment<Real>& segment = capsule.segment;
  return {
      {scaled(segment.start, exponent), scaled(segment.end, exponent)},
      std::ldexp(capsule.radius, exponent)};
}

/// A box times two to the power of `exponent`, seen from the origin.
template <class Real>
Obb<Real> scaled(const Obb<Real>& box, int exponent)
{
  return {scaled(box.center, exponent), box.axes, scaled(box.half_extents, exponent)};
}

/// A manifold times two to the power of `exponent`; lengths that do not fit become infinite.
template <class Real>
Manifold<Real> scaled(Manifold<Real> manifold, int exponent)
{
  manifold.depth = std::ldexp(manifold.depth, exponent);
  for (ContactPoint<Real>& point : manifold.points)
  {
    point.position = scaled(point.position, exponent);
    point.depth = std::ldexp(point.depth, exponent);
  }
  return manifold;
}

// [at_any_size]
/// Numbers up to this size have sums that fit.
template <class Real>
inline const Real sums_fit = std::numeric_limits<Real>::max() / Real(16);

/// Numbers up to this size have sums of squares that fit.
template <class Real>
inline const Real squares_fit = std::sqrt(std::numeric_limits<Real>::max()) / Real(16);

/// The manifold that `find(a, b)` gives for shapes of numbers up to `most`; larger ones are made
/// that small first, and the answer is enlarged. Powers of two are exact.
template <class Real, class First, class Second, class Find>
std::optional<Manifold<Real>>
at_any_size(const First& a, const Second& b, Real most, const Find& find)
{
  const Real size = std::max(largest(a), largest(b));
  if (!(size > most))
  {
    return find(a, b);
  }
  const int exponent = std::ilogb(size) - std::ilogb(most) + 1;
  const std::optional<Manifold<Real>> found = find(scaled(a, -exponent), scaled(b, -exponent));
  return found ? std::optional(scaled(*found, exponent)) : std::nullopt;
}
// [at_any_size]

/// The manifold with its points moved by an offset [m].
template <class Real, std::size_t Capacity>
std::optional<Manifold<Real, Capacity>>
translated(std::optional<Manifold<Real, Capacity>> manifold, const Vector3<Real>& offset)
{
  if (manifold)
  {
    for (ContactPoint<Real>& point : manifold->points)
    {
      point.position += offset;
    }
  }
  return manifold;
}

} // namespace cookbook
