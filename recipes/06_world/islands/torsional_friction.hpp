#pragma once

/// \file
/// \brief Friction against turning, of the bodies of an island that stand on corners.

#include "05_resolution/friction/corner_friction.hpp"
#include "06_world/islands/island_points.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace cookbook
{

// [torsional_friction]
/// The radius [m] of a body's corner at the end of an arm, of which it is so large a share [1]; one
/// that is fixed has no say.
inline double corner_radius(const RigidBody& body, const Vector3<double>& arm, double fraction)
{
  return is_fixed(body) ? std::numeric_limits<double>::infinity() : fraction * arm.norm();
}

/// Has two bodies turn against each other less, by what they press on each other in a step, if it
/// is at a single point: a corner. Several points rub against each turn but one about their line;
/// balls roll on.
inline void
apply_torsional_friction(std::span<RigidBody> bodies, const WorldContact& contact, double fraction)
{
  RigidBody &a = bodies[index_of(contact.a)], &b = bodies[index_of(contact.b)];
  const auto begin = contact.points.begin(), end = contact.points.end();
  const auto point = std::find_if(begin, end, is_active);
  if (a.is_sphere || b.is_sphere || point == end || std::any_of(point + 1, end, is_active))
  {
    return;
  }
  const double radius = std::min(
      corner_radius(a, point->anchor_a, fraction), corner_radius(b, point->anchor_b, fraction));
  apply_torsional_friction<double>(a, b, contact.friction * point->impulse * radius);
}

/// The same for all bodies of an island.
inline void apply_torsional_friction(IslandView world, const Island& island, double fraction)
{
  for (const int number : island.contacts)
  {
    apply_torsional_friction(world.bodies, world.contacts[index_of(number)], fraction);
  }
}
// [torsional_friction]

} // namespace cookbook
