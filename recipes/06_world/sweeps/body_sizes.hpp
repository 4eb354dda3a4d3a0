#pragma once

/// \file
/// \brief How far the shapes of bodies reach, and how thin they are.

#include "06_world/contacts/scene.hpp"

#include <limits>

namespace cookbook
{

// [body_sizes]
/// How far [m] a shape reaches from its centre.
inline double bounding_radius_of(const SphereShape& sphere)
{
  return sphere.radius;
}
inline double bounding_radius_of(const BoxShape& box)
{
  return box.half_extents.norm();
}
inline double bounding_radius_of(const ConvexShape& shape)
{
  return extent(shape).outer;
}
inline double bounding_radius_of(const PlaneShape&)
{
  return 0;
}

/// How far [m] the nearest point of a shape's surface is from its centre.
inline double inner_radius_of(const SphereShape& sphere)
{
  return sphere.radius;
}
inline double inner_radius_of(const BoxShape& box)
{
  return box.half_extents.minCoeff();
}
inline double inner_radius_of(const ConvexShape& shape)
{
  return extent(shape).inner;
}
inline double inner_radius_of(const PlaneShape&)
{
  return std::numeric_limits<double>::infinity();
}

/// The allowed penetration [m] of bodies of which the thinner one has this inner radius [m]: a
/// twentieth of its smallest size.
inline double allowed_penetration(double inner_radius)
{
  return inner_radius / 10;
}
// [body_sizes]

} // namespace cookbook
