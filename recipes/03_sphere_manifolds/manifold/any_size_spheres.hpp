#pragma once

/// \file
/// \brief Spheres, planes and capsules for answers at any finite size.

#include "03_sphere_manifolds/manifold/any_size.hpp"

#include <algorithm>
#include <cmath>

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

} // namespace cookbook
