#pragma once

/// \file
/// \brief The contact points of an island as solvers that go from point to point need them.

#include "05_resolution/contact_constraint/contact_constraint.hpp"
#include "06_world/islands/island_view.hpp"
#include "06_world/islands/previous_state.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace cookbook
{

// [island_points]
/// A contact point of an island.
struct IslandPoint : ContactConstraint<double>
{
  RigidBody* a;                ///< the body that the normal points away from
  RigidBody* b;                ///< the body that it points to
  const WorldContact* contact; ///< whose point it is
  WorldPoint* cached;          ///< its impulses, kept from frame to frame
};

/// How a body moves in a substep before a solver pushes it.
struct FreeMotion
{
  Vector3<double> velocity;         ///< [m/s], world, after the external acceleration
  Vector3<double> angular_velocity; ///< [rad/s], world, the same
  bool pushed;                      ///< whether the solver has changed it, or corrected the pose
};

/// How a body moves as a step begins.
struct StepStart
{
  Vector3<double> velocity;         ///< [m/s], world
  Vector3<double> angular_velocity; ///< [rad/s], world
  bool pushed; ///< whether the solver pushes it, or corrects its pose, in the step
};

/// Room of a step that stays from step to step.
struct SolverScratch
{
  std::vector<IslandPoint> points;  ///< of an island
  std::vector<FreeMotion> free;     ///< of the bodies of islands, one island after the other
  std::vector<StepStart> starts;    ///< of the same
  std::vector<PreviousState> moved; ///< how these have moved before poses are corrected
  std::vector<int> pushed;          ///< the numbers of those that are pushed in a substep
};

/// Computes the effective masses of a point at the present orientations.
inline void compute_masses(IslandPoint& point)
{
  compute_masses<double>(point, *point.a, *point.b);
}

/// The axes of a body by which its arms are taken.
using FindAxes = Matrix3<double>(const RigidBody&);

/// Those of its present orientation.
inline Matrix3<double> axes_now(const RigidBody& body)
{
  return body.axes;
}

/// What the points of a contact have in common.
struct ContactFrame
{
  SurfaceAxes<double> surface; ///< [1], world
  Matrix3<double> axes_a;      ///< [1], of body A, to take its arms by
  Matrix3<double> axes_b;      ///< [1], of body B
};

/// That of a contact of two bodies.
inline ContactFrame frame_of(
    const RigidBody& a, const RigidBody& b, const WorldContact& contact,
    FindAxes& find_axes = axes_now)
{
  return {surface_axes(contact.normal), find_axes(a), find_axes(b)};
}

/// A contact point of two bodies as they are, without its masses; friction is turned with it.
inline ContactConstraint<double> constraint_of(
    const RigidBody& a, const RigidBody& b, const WorldContact& contact, const ContactFrame& frame,
    const WorldPoint& of)
{
  const Arms<double> arms{frame.axes_a * of.anchor_a, frame.axes_b * of.anchor_b};
  const double separation = separation_of(a, b, contact.normal, of);
  const Vector2<double> friction = frame.surface.along(of.friction);
  const double impulse = of.warm_start_impulse, mu = contact.friction;
  return {contact.normal, frame.surface, arms, mu, separation, impulse, 0, friction, 0, {}};
}

/// A contact point of an island.
inline IslandPoint island_point(
    RigidBody& a, RigidBody& b, const WorldContact& contact, const ContactFrame& frame,
    WorldPoint& of)
{
  IslandPoint point{constraint_of(a, b, contact, frame, of), &a, &b, &contact, &of};
  compute_masses(point);
  return point;
}

/// The points of an island, contact by contact, in the scratch buffer of the world.
inline std::span<IslandPoint>
points_of(IslandView world, const Island& island, FindAxes& find_axes = axes_now)
{
  std::vector<IslandPoint>& points = world.scratch.points;
  points.clear();
  for (const int number : island.contacts)
  {
    WorldContact& contact = world.contacts[index_of(number)];
    RigidBody& a = world.bodies[index_of(contact.a)];
    RigidBody& b = world.bodies[index_of(contact.b)];
    const ContactFrame frame = frame_of(a, b, contact, find_axes);
    for (WorldPoint& point : contact.points)
    {
      points.push_back(island_point(a, b, contact, frame, point));
    }
  }
  return points;
}

/// Stores the impulses of points, with which the next frame begins.
inline void store(std::span<const IslandPoint> points)
{
  for (const IslandPoint& point : points)
  {
    point.cached->impulse = point.cached->warm_start_impulse = point.impulse;
    point.cached->friction = point.surface.in_world(point.friction);
  }
}

/// How far apart [m] the surfaces are at a point where the bodies are now.
inline double separation_of(const IslandPoint& point)
{
  return separation_of(*point.a, *point.b, point.normal, *point.cached);
}

/// How fast [m/s] the surfaces part at a point.
inline double separating_velocity(const IslandPoint& point)
{
  return separating_velocity<double>(*point.a, *point.b, point);
}

/// Adds to the normal impulse at a point, whose sum is never below zero; R7.
inline void add_impulse(IslandPoint& point, double change)
{
  add_impulse<double>(*point.a, *point.b, point, change);
}

/// Solves the friction at a point; R6.
inline void add_friction(IslandPoint& point)
{
  add_friction<double>(*point.a, *point.b, point);
}

/// Warm starting of a point.
inline void warm_start(const IslandPoint& point)
{
  warm_start<double>(*point.a, *point.b, point);
}
// [island_points]

} // namespace cookbook
