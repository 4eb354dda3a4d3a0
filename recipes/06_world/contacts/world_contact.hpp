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

// [lost_points]
/// A point of a fixed body and one that moves which is no longer where it was on the latter.
struct LostPoint
{
  int moving;             ///< the place of the body that moves
  Vector3<double> anchor; ///< [m], in that body's frame, where it was
  Vector3<double> normal; ///< [1], unit, world, towards that body
  WorldPoint point;       ///< what a solver knew of it
};

/// A point stays where it is on a body if it moves by no more than this fraction of its distance
/// from the centre: what rounding makes of it.
inline constexpr double stays_in_place = 1e-9;

/// Whether a solver has seen a point before.
inline bool is_known(const WorldPoint& point)
{
  return point.solved || is_active(point) || point.warm_start_impulse > 0;
}

/// What becomes of contacts of bodies that move with fixed ones in a step, beside their list.
struct ContactChanges
{
  std::vector<LostPoint> lost;             ///< points that are no longer where they were
  std::vector<std::pair<int, int>> ghosts; ///< boxes that were taken for ghosts, is_ghost()

  /// Forgets those of the step before.
  void clear()
  {
    lost.clear();
    ghosts.clear();
  }
};

/// Notes points that are lost of a contact of two bodies, one of which is fixed.
struct NoteLost
{
  ContactChanges* changes; ///< where; nowhere, if this is null
  const WorldContact& contact;
  bool fixed_a, fixed_b;

  /// Where a point is on the body that moves, by where it is on both.
  const Vector3<double>& moving(const Vector3<double>& on_a, const Vector3<double>& on_b) const
  {
    return fixed_a ? on_b : on_a;
  }
  /// Notes a point.
  void operator()(const WorldPoint& point) const
  {
    if (changes != nullptr && fixed_a != fixed_b && is_known(point))
    {
      changes->lost.push_back(
          {fixed_a ? contact.b : contact.a, moving(point.anchor_a, point.anchor_b),
           fixed_a ? contact.normal : Vector3<double>(-contact.normal), point});
    }
  }
  /// Notes all points.
  void all() const { std::for_each(contact.points.begin(), contact.points.end(), *this); }
};

/// That for a contact of two bodies.
inline NoteLost note_lost(
    ContactChanges* changes, const WorldContact& contact, const RigidBody& a, const RigidBody& b)
{
  return {changes, contact, is_fixed(a), is_fixed(b)};
}
// [lost_points]

} // namespace cookbook
