#pragma once

/// \file
/// \brief The contact points of an island as solvers that go from point to point need them.

#include "05_resolution/islands/island.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace cookbook
{

// [two_bodies]
/// Velocity [m/s] of B's surface at a contact point as seen from A's; arms [m] lead from the
/// centres of mass to the point.
inline Vector3<double> velocity_between(
    const RigidBody& a, const RigidBody& b, const Vector3<double>& arm_a,
    const Vector3<double>& arm_b)
{
  return b.velocity + b.angular_velocity.cross(arm_b) - a.velocity -
         a.angular_velocity.cross(arm_a);
}

/// Gives an impulse [N s], world, to B and its opposite to A.
inline void push_apart(
    RigidBody& a, RigidBody& b, const Vector3<double>& arm_a, const Vector3<double>& arm_b,
    const Vector3<double>& impulse)
{
  a.velocity -= a.inverse_mass * impulse;
  a.angular_velocity -= a.inverse_inertia * arm_a.cross(impulse);
  b.velocity += b.inverse_mass * impulse;
  b.angular_velocity += b.inverse_inertia * arm_b.cross(impulse);
}

/// The inverse mass [1/kg] of two bodies at a contact point, along a unit direction; R1.
inline double inverse_mass_between(
    const RigidBody& a, const RigidBody& b, const Vector3<double>& arm_a,
    const Vector3<double>& arm_b, const Vector3<double>& direction)
{
  const Vector3<double> lever_a = arm_a.cross(direction), lever_b = arm_b.cross(direction);
  return a.inverse_mass + b.inverse_mass + lever_a.dot(a.inverse_inertia * lever_a) +
         lever_b.dot(b.inverse_inertia * lever_b);
}
// [two_bodies]

// [island_points]
/// A contact point of an island.
struct IslandPoint
{
  RigidBody* a;                 ///< the body that the normal points away from
  RigidBody* b;                 ///< the body that it points to
  const WorldContact* contact;  ///< whose point it is
  WorldPoint* sum;              ///< its impulses so far, which the next frame finds again
  Vector3<double> arm_a, arm_b; ///< [m], world, at the start of the frame
  double normal_mass;           ///< [kg], what an impulse along the normal feels, 1/K
  double friction_mass;         ///< [kg], what one across it feels: the lesser of two directions
  double apart;                 ///< [m], the gap; solvers with small steps carry it on
};

/// Finds what impulses at a point feel, with the bodies as they are turned now.
inline void find_masses(IslandPoint& point)
{
  const Vector3<double>& normal = point.contact->normal();
  const Vector3<double> u = normal.unitOrthogonal(), v = normal.cross(u);
  const auto felt = [&](const Vector3<double>& way)
  { return inverse_mass_between(*point.a, *point.b, point.arm_a, point.arm_b, way); };
  point.normal_mass = 1 / felt(normal);
  point.friction_mass = 1 / std::max(felt(u), felt(v));
}

/// A contact point of an island, its bodies as they are.
inline IslandPoint
island_point(RigidBody& a, RigidBody& b, const WorldContact& contact, WorldPoint& of)
{
  const double apart = gap(a, b, contact.normal(), of);
  IslandPoint point{&a, &b, &contact, &of, a.axes * of.on_a, b.axes * of.on_b, 0, 0, apart};
  find_masses(point);
  return point;
}

/// The points of an island, contact by contact; friction of the frame before is turned into the
/// plane of the contact as it is now.
inline std::vector<IslandPoint> points_of(IslandView world, const Island& island)
{
  std::vector<IslandPoint> points;
  for (const int number : island.contacts)
  {
    WorldContact& contact = world.contacts[static_cast<std::size_t>(number)];
    RigidBody& a = world.bodies[static_cast<std::size_t>(contact.a)];
    RigidBody& b = world.bodies[static_cast<std::size_t>(contact.b)];
    const Vector3<double>& normal = contact.normal();
    for (WorldPoint& point : contact.points())
    {
      point.friction -= point.friction.dot(normal) * normal;
      points.push_back(island_point(a, b, contact, point));
    }
  }
  return points;
}

/// How far apart [m] the surfaces are at a point where the bodies are now.
inline double gap(const IslandPoint& point)
{
  return gap(*point.a, *point.b, point.contact->normal(), *point.sum);
}

/// How fast [m/s] the surfaces part at a point.
inline double parting_speed(const IslandPoint& point)
{
  return velocity_between(*point.a, *point.b, point.arm_a, point.arm_b)
      .dot(point.contact->normal());
}
// [island_points]

// [pushes]
/// Changes the sum of impulses along the normal at a point by what it still takes, but to no less
/// than zero: R7.
inline void add_impulse(IslandPoint& point, double change)
{
  const double sum = std::max(0.0, point.sum->impulse + change);
  push_apart(
      *point.a, *point.b, point.arm_a, point.arm_b,
      (sum - point.sum->impulse) * point.contact->normal());
  point.sum->impulse = sum;
}

/// Takes away what slips at a point, with a friction within the cone: R6, R7.
inline void add_friction(IslandPoint& point)
{
  const Vector3<double>& normal = point.contact->normal();
  const Vector3<double> moving = velocity_between(*point.a, *point.b, point.arm_a, point.arm_b);
  const Vector3<double> slip = moving - moving.dot(normal) * normal;
  Vector3<double> sum = point.sum->friction - point.friction_mass * slip;
  const double most = point.contact->friction * point.sum->impulse, size = sum.norm();
  if (size > most)
  {
    sum *= most / size;
  }
  push_apart(*point.a, *point.b, point.arm_a, point.arm_b, sum - point.sum->friction);
  point.sum->friction = sum;
}

/// Gives the bodies once more what the frame before, or the step before, has ended with.
inline void warm_start(IslandPoint& point)
{
  push_apart(
      *point.a, *point.b, point.arm_a, point.arm_b,
      point.sum->impulse * point.contact->normal() + point.sum->friction);
}
// [pushes]

} // namespace cookbook
