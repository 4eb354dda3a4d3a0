#pragma once

/// \file
/// \brief A small world, step 1: contacts solved by impulses, frame by frame.

// [head]
#include "05_resolution/contact_constraint/contact_constraint.hpp"
#include "05_resolution/position_correction/position_correction.hpp"
#include "05_resolution/small_world/small_body.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace cookbook::small_world::step_1
{
// [head]

// [world]
/// A contact point, and the places of its two bodies in the world's list.
struct Contact : ContactConstraint<double>
{
  std::size_t a; ///< the body that the normal points away from
  std::size_t b; ///< the body that it points to, b > a
};

/// Bodies, and where they touched in the last step.
struct World
{
  Vector3<double> gravity{0, -9.81, 0}; ///< [m/s²]
  std::vector<RigidBody> bodies;
  std::vector<Contact> contacts;
};

/// Adds a body and returns its place; refuses one that is outside the ranges of check().
inline std::size_t add(World& world, const RigidBody& body)
{
  check(body);
  world.bodies.push_back(body);
  return world.bodies.size() - 1;
}
// [world]

// [collide]
/// A contact point as the solver needs it.
inline Contact make_contact(
    const World& world, std::size_t i, std::size_t j, const Vector3<double>& normal,
    const ContactPoint<double>& point)
{
  const RigidBody &a = world.bodies[i], &b = world.bodies[j];
  Contact contact{};
  contact.a = i;
  contact.b = j;
  contact.normal = normal;
  contact.surface = surface_axes(normal);
  contact.arms = {point.position - a.motion.center, point.position - b.motion.center};
  contact.coefficient = std::sqrt(a.friction * b.friction);
  contact.separation = -point.depth;
  contact.friction.setZero(); // Eigen does not set it
  compute_masses<double>(contact, a, b);
  return contact;
}

/// Adds the contact points of two bodies, if they touch and one of them can move.
inline void collide(World& world, std::size_t i, std::size_t j)
{
  const RigidBody &a = world.bodies[i], &b = world.bodies[j];
  if (a.inverse_mass == 0 && b.inverse_mass == 0)
  {
    return;
  }
  if (const std::optional<Manifold<double>> manifold = manifold_of(a, b))
  {
    for (const ContactPoint<double>& point : manifold->points)
    {
      world.contacts.push_back(make_contact(world, i, j, manifold->normal, point));
    }
  }
}

/// Finds all contact points: every body against every other.
inline void find_contacts(World& world)
{
  world.contacts.clear();
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    for (std::size_t j = i + 1; j < world.bodies.size(); ++j)
    {
      collide(world, i, j);
    }
  }
}
// [collide]

// [solve]
/// How often a step goes through all contact points.
inline constexpr int passes = 10;
/// The overlap [m] that stays, so that contacts are not lost.
inline constexpr double slop = 0.005;
/// The fraction [1] of the rest of an overlap that a step pushes out.
inline constexpr double push_fraction = 0.2;
/// How fast [m/s] an overlap is pushed out at most.
inline constexpr double max_push_speed = 3;

/// Solves one contact point: the impulse that gives it the velocity it is to have, then friction.
inline void solve(World& world, Contact& contact, double time)
{
  RigidBody &a = world.bodies[contact.a], &b = world.bodies[contact.b];
  const double push_out =
      bias_velocity(-contact.separation, slop, push_fraction / time, max_push_speed);
  const double target = contact.separation > 0 ? -contact.separation / time : push_out;
  const double residual = target - separating_velocity<double>(a, b, contact);
  add_impulse<double>(a, b, contact, contact.normal_mass * residual);
  add_friction<double>(a, b, contact);
}

/// Adds what gravity does in a time [s] to the velocity of each body that can move.
inline void apply_gravity(World& world, double time)
{
  for (RigidBody& body : world.bodies)
  {
    if (body.inverse_mass > 0)
    {
      body.motion.velocity += time * world.gravity;
    }
  }
}
// [solve]

// [step]
/// Moves a world on by a time [s].
inline void step(World& world, double time)
{
  check("time", time, 1e-6, 0.1);
  check("gravity.norm()", world.gravity.norm(), 0, 1e4);
  find_contacts(world);
  apply_gravity(world, time);
  for (int pass = 0; pass < passes; ++pass)
  {
    for (Contact& contact : world.contacts)
    {
      solve(world, contact, time);
    }
  }
  for (RigidBody& body : world.bodies)
  {
    integrate_position(body, time);
  }
}
// [step]

} // namespace cookbook::small_world::step_1
