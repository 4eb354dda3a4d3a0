#pragma once

/// \file
/// \brief The contact of two bodies of a world: points that stay on the bodies, and their gaps.

#include "05_resolution/impulse/impulse.hpp"
#include "06_world/contacts/rigid_body.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace cookbook
{

/// A number of a body or contact as a place in a list.
inline std::size_t index_of(int number)
{
  return static_cast<std::size_t>(number);
}

// [world_contact]
/// What a solver knows of a contact point; carried from frame to frame. Of small steps, friction
/// and what is carried are those of the last, times their number.
struct WorldPoint
{
  Vector3<double> anchor_a = Vector3<double>::Zero(); ///< [m], in A's frame, on its surface
  Vector3<double> anchor_b = Vector3<double>::Zero(); ///< [m], in B's frame, on its surface
  Vector3<double> friction = Vector3<double>::Zero(); ///< [N s], on B, across the normal, world
  double impulse = 0; ///< [N s], by the solver in this step, along the normal, zero or more
  double warm_start_impulse = 0; ///< [N s], along it, with which the next step begins
  std::uint32_t feature = 0;     ///< which features of the shapes meet here
  bool solved = false;           ///< whether the impulse is more than a guess
  bool over_constrained = false; ///< whether it is more than any load, is_over_constrained()
};

/// Two bodies of a world that touch, or may in this step.
struct WorldContact
{
  int a = 0;                                        ///< the place of body A in the world's lists
  int b = 0;                                        ///< that of body B, greater than a
  double friction = 0;                              ///< [1], of the two surfaces together
  double restitution = 0;                           ///< [1], of the two surfaces together
  Vector3<double> normal = Vector3<double>::Zero(); ///< [1], unit, world, from A to B
  std::vector<WorldPoint> points; ///< where they may press on each other; none if they are apart
};

/// The two bodies of a contact.
inline std::pair<int, int> pair_of(const WorldContact& contact)
{
  return {contact.a, contact.b};
}

/// Whether two bodies press on each other at a point.
inline bool is_active(const WorldPoint& point)
{
  return point.impulse > 0;
}

/// Whether two bodies press on each other at any point of a contact.
inline bool is_touching(const WorldContact& contact)
{
  return std::any_of(contact.points.begin(), contact.points.end(), is_active);
}

/// The arms [m], world, of a contact point as its bodies are turned now.
inline Arms<double> arms_of(const RigidBody& a, const RigidBody& b, const WorldPoint& point)
{
  return {a.axes * point.anchor_a, b.axes * point.anchor_b};
}

/// How far apart [m] the two surfaces are at a contact point, along a normal from A to B; negative
/// where they overlap.
inline double separation_of(
    const RigidBody& a, const RigidBody& b, const Vector3<double>& normal, const WorldPoint& point)
{
  const Arms<double> arms = arms_of(a, b, point);
  const Vector3<double> between = (b.motion.center + arms.b) - (a.motion.center + arms.a);
  return normal.dot(between);
}
// [world_contact]

} // namespace cookbook
