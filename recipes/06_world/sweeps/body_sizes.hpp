#pragma once

/// \file
/// \brief How far the shapes of bodies reach, and how thin they are.

#include "06_world/contacts/scene.hpp"
#include "06_world/shapes/box_shape.hpp"
#include "06_world/shapes/plane_shape.hpp"
#include "06_world/shapes/sphere_shape.hpp"

namespace cookbook
{

// [body_sizes]
/// How far [m] a shape reaches from its centre; a plane has none, and turns by nothing.
template <class Shape>
double bounding_radius_of(const Shape& shape)
{
  return extent(shape).outer;
}
inline double bounding_radius_of(const PlaneShape&)
{
  return 0;
}

/// How far [m] the nearest point of a shape's surface is from its centre.
template <class Shape>
double inner_radius_of(const Shape& shape)
{
  return extent(shape).inner;
}

/// Lengths that differ by less than this fraction of a size are equal: rounding of 2.2e-16 moves
/// places up to a million sizes from the origin by 2.2e-10 of a size.
inline constexpr double length_rounding = 1e-9;

/// A depth has grown where it did by more than one of so many parts of the allowed penetration:
/// bodies at rest are not left that much deeper by a solver.
inline constexpr double deepening_parts = 10;

/// The allowed penetration [m] of bodies of which the thinner one has this inner radius [m]: a
/// twentieth of its smallest size.
inline double allowed_penetration(double inner_radius)
{
  return inner_radius / 10;
}
// [body_sizes]

} // namespace cookbook
