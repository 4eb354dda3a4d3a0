#pragma once

/// \file
/// \brief The contact points of an island as solvers that go from point to point need them.

#include "05_resolution/friction/friction.hpp"
#include "05_resolution/islands/island.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace cookbook
{

// [island_points]
/// A contact point of an island.
struct IslandPoint
{
  RigidBody* a;                ///< the body that the normal points away from
  RigidBody* b;                ///< the body that it points to
  const WorldContact* contact; ///< whose point it is
  WorldPoint* sum;             ///< its impulses so far, which the next frame finds again
  Arms<double> arms;           ///< [m], world, at the start of the frame
  double normal_mass;          ///< [kg], that an impulse along the normal feels
  SlidingMass<double> sliding; ///< [kg], what one across it feels
  double apart;                ///< [m], the gap; solvers with small steps carry it on
};

/// What a solver may see and change.
struct IslandView
{
  std::span<RigidBody> bodies;      ///< all bodies of the world
  std::span<WorldContact> contacts; ///< all contacts of the world
  Vector3<double> gravity;          ///< [m/s²], world
  std::vector<IslandPoint>& room;   ///< for the points of an island; kept from step to step
};

/// Moves the bodies of one island on by a step [s], and sets the impulses of its contacts.
using IslandSolver = std::function<void(IslandView, const Island&, double)>;

/// Finds what impulses at a point feel, with the bodies as they are turned now; R1.
inline void find_masses(IslandPoint& point)
{
  const Vector3<double>& normal = point.contact->normal();
  const Body<double>&a = *point.a, &b = *point.b;
  point.normal_mass = effective_mass(inverse_mass_at(a, b, normal, point.arms));
  point.sliding = sliding_mass(a, b, normal, point.arms);
}

/// A contact point of an island, its bodies as they are.
inline IslandPoint
island_point(RigidBody& a, RigidBody& b, const WorldContact& contact, WorldPoint& of)
{
  const double apart = gap(a, b, contact.normal(), of);
  IslandPoint point{&a, &b, &contact, &of, arms_of(a, b, of), 0, {}, apart};
  find_masses(point);
  return point;
}

/// The points of an island, contact by contact, in the room that the world has for them; friction
/// of the frame before is turned into the plane of the contact as it is now.
inline std::span<IslandPoint> points_of(IslandView world, const Island& island)
{
  std::vector<IslandPoint>& points = world.room;
  points.clear();
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
  return parting_speed<double>(*point.a, *point.b, point.contact->normal(), point.arms);
}
// [island_points]

// [pushes]
/// Pushes along the normal at a point, or takes back at most what it has got; R7.
inline void add_impulse(IslandPoint& point, double change)
{
  const double sum = accumulated(point.sum->impulse, change);
  const Vector3<double> push = (sum - point.sum->impulse) * point.contact->normal();
  push_apart<double>(*point.a, *point.b, point.arms, push);
  point.sum->impulse = sum;
}

/// Takes away what slips at a point, with a friction within the cone; R6.
inline void add_friction(IslandPoint& point)
{
  const WorldContact& contact = *point.contact;
  const Vector3<double> sum = friction_impulse(
      sliding_velocity<double>(*point.a, *point.b, contact.normal(), point.arms), point.sliding,
      point.sum->friction, contact.friction * point.sum->impulse);
  push_apart<double>(*point.a, *point.b, point.arms, sum - point.sum->friction);
  point.sum->friction = sum;
}

/// Gives the bodies once more what the frame before, or the step before, has ended with.
inline void warm_start(IslandPoint& point)
{
  const Vector3<double> push = point.sum->impulse * point.contact->normal() + point.sum->friction;
  push_apart<double>(*point.a, *point.b, point.arms, push);
}
// [pushes]

} // namespace cookbook
