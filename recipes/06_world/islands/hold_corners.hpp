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

// [hold_corners]
/// The radius [m] of a body's corner at the end of an arm, of which it is so large a share [1]; one
/// that is fixed has no say.
inline double corner_radius(const RigidBody& body, const Vector3<double>& arm, double share)
{
  return is_fixed(body) ? std::numeric_limits<double>::infinity() : share * arm.norm();
}

/// Has two bodies turn against each other less, by what they press on each other in a step, if it
/// is at a single point: a corner. Several points rub against each turn but one about their line;
/// balls roll on.
inline void hold_corner(std::span<RigidBody> bodies, const WorldContact& contact, double share)
{
  RigidBody &a = bodies[place_of(contact.a)], &b = bodies[place_of(contact.b)];
  const auto begin = contact.points.begin(), end = contact.points.end();
  const auto point = std::find_if(begin, end, is_pressed);
  if (a.round || b.round || point == end || std::any_of(point + 1, end, is_pressed))
  {
    return;
  }
  const double radius =
      std::min(corner_radius(a, point->on_a, share), corner_radius(b, point->on_b, share));
  apply_torsional_friction<double>(a, b, contact.friction * point->impulse * radius);
}

/// The same for all bodies of an island.
inline void hold_corners(IslandView world, const Island& island, double share)
{
  for (const int number : island.contacts)
  {
    hold_corner(world.bodies, world.contacts[place_of(number)], share);
  }
}
// [hold_corners]

} // namespace cookbook
