#pragma once

/// \file
/// \brief How far the shapes of bodies reach, and how thin they are.

#include "06_world/contacts/scene.hpp"

#include <limits>

namespace cookbook
{

// [body_sizes]
/// How far [m] a shape reaches from its centre.
inline double reach_of(const SphereShape& ball)
{
  return ball.radius;
}
inline double reach_of(const BoxShape& box)
{
  return box.half_extents.norm();
}
inline double reach_of(const PlaneShape&)
{
  return 0;
}

/// How far [m] the nearest point of a shape's surface is from its centre.
inline double thinness_of(const SphereShape& ball)
{
  return ball.radius;
}
inline double thinness_of(const BoxShape& box)
{
  return box.half_extents.minCoeff();
}
inline double thinness_of(const PlaneShape&)
{
  return std::numeric_limits<double>::infinity();
}

/// How deep [m] bodies may get into each other and nobody minds, of which the thinner one has this
/// thinness [m]: by a twentieth of its smallest size.
inline double harmless_depth(double thinness)
{
  return thinness / 10;
}
// [body_sizes]

} // namespace cookbook
