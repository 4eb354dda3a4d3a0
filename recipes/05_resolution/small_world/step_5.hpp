#pragma once

/// \file
/// \brief A small world, step 5: restitution.

#include "02_primitives/shape_bounds/obb_bounds.hpp"
#include "05_resolution/contact_constraint/soft_contact.hpp"
#include "05_resolution/restitution/rebound_speed.hpp"
#include "05_resolution/small_world/small_body.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace cookbook::small_world::step_5
{

/// A contact point, and the places of its two bodies in the world's list.
struct Contact : ContactConstraint<double>
{
  std::size_t a;                 ///< the body that the normal points away from
  std::size_t b;                 ///< the body that it points to, b > a
  unsigned id;                   ///< which features of the two bodies meet here
  std::optional<double> rebound; ///< [m/s], separating velocity after an impact; none if it is none
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

/// A contact point as the solver needs it.
inline Contact make_contact(
    const World& world, std::size_t i, std::size_t j, const Vector3<double>& normal,
    const ContactPoint<double>& point)
{
  const RigidBody &a = world.bodies[i], &b = world.bodies[j];
  Contact contact{};
  contact.a = i;
  contact.b = j;
  contact.id = point.feature;
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

/// The order of contact points: by their bodies, then by their ids.
inline bool comes_before(const Contact& one, const Contact& other)
{
  return std::tie(one.a, one.b, one.id) < std::tie(other.a, other.b, other.id);
}

/// Warm starting: gives a contact point the impulses that it had in the step before, if it was
/// there.
inline void remember_impulses(Contact& contact, const std::vector<Contact>& before)
{
  const auto old = std::lower_bound(before.begin(), before.end(), contact, comes_before);
  if (old != before.end() && !comes_before(contact, *old))
  {
    contact.impulse = old->impulse;
    contact.friction = contact.surface.along(old->surface.in_world(old->friction));
  }
}

/// The axis-aligned bounding box (AABB) of a body; P7.
inline Aabb<double> bounds_of(const RigidBody& body)
{
  const Vector3<double>& radius = body.half_extents;
  return body.is_sphere ? Aabb<double>(body.motion.center - radius, body.motion.center + radius)
                        : cookbook::bounds_of(box_of(body));
}

/// A body's AABB, and its place.
struct Bounds
{
  Aabb<double> aabb;
  std::size_t body;
};

/// Broad phase, sort and sweep: the AABBs in order of where they begin along x; each is held
/// against those that begin before it ends.
inline void find_pairs(World& world)
{
  std::vector<Bounds> sorted;
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    sorted.push_back({bounds_of(world.bodies[i]), i});
  }
  const auto begins_before = [](const Bounds& one, const Bounds& other)
  { return one.aabb.min().x() < other.aabb.min().x(); };
  std::sort(sorted.begin(), sorted.end(), begins_before);
  for (auto one = sorted.begin(); one != sorted.end(); ++one)
  {
    const double end = one->aabb.max().x();
    for (auto other = one + 1; other != sorted.end() && other->aabb.min().x() <= end; ++other)
    {
      if (one->aabb.intersects(other->aabb))
      {
        collide(world, std::min(one->body, other->body), std::max(one->body, other->body));
      }
    }
  }
}

/// Finds all contact points, and gives them the impulses of the step before.
inline void find_contacts(World& world)
{
  const std::vector<Contact> before = std::move(world.contacts);
  world.contacts.clear();
  find_pairs(world);
  std::sort(world.contacts.begin(), world.contacts.end(), comes_before);
  for (Contact& contact : world.contacts)
  {
    remember_impulses(contact, before);
  }
}

/// How often a step moves the bodies.
inline constexpr int substeps = 4;
/// The frequency of the contacts' springs, as a fraction [1] of the substeps' rate.
inline constexpr double spring_rate = 0.125;
/// The damping ratio [1] of the springs.
inline constexpr double damping_ratio = 5;
/// How fast [m/s] an overlap is pushed out at most.
inline constexpr double max_push_speed = 3;

/// Solves every contact point once, as a damped spring where the surfaces overlap; an impact is
/// stopped where it is.
inline void solve(World& world, const Softness<double>& spring, double time)
{
  for (Contact& contact : world.contacts)
  {
    const Softness<double> softness = contact.rebound ? rigid<double>() : spring;
    solve_contact<double>(
        world.bodies[contact.a], world.bodies[contact.b], contact, softness, time, max_push_speed);
    contact.total_impulse += contact.impulse;
  }
}

/// Moves all bodies on by a time [s], and the separations at their contact points with them.
inline void integrate_positions(World& world, double time)
{
  for (RigidBody& body : world.bodies)
  {
    integrate_position(body, time);
  }
  for (Contact& contact : world.contacts)
  {
    contact.separation += time * separating_velocity<double>(
                                     world.bodies[contact.a], world.bodies[contact.b], contact);
  }
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

/// Applies the impulses that all contact points begin with.
inline void apply_warm_start(World& world)
{
  for (const Contact& contact : world.contacts)
  {
    warm_start<double>(world.bodies[contact.a], world.bodies[contact.b], contact);
  }
}

/// Finds the contact points at which bodies meet faster than they would at rest, and the velocity
/// to separate with after this step, before the next gravity acts for a substep [s]; R19.
inline void find_impacts(World& world, double time, double substep)
{
  const double threshold = restitution_threshold(world.gravity.norm(), time);
  for (Contact& contact : world.contacts)
  {
    const RigidBody &a = world.bodies[contact.a], &b = world.bodies[contact.b];
    const double falls = (b.inverse_mass > 0 ? 1 : 0) - (a.inverse_mass > 0 ? 1 : 0);
    const double acceleration = falls * world.gravity.dot(contact.normal);
    const ContactStep<double> now{acceleration, substep, -contact.separation};
    const double speed = separating_velocity<double>(a, b, contact) + acceleration * substep;
    const double restitution = std::max(a.restitution, b.restitution);
    if (impact_speed(speed, now) > threshold)
    {
      const double rebound = rebound_speed(speed, now, restitution, threshold);
      contact.rebound = restitution > 0 ? rebound - acceleration * substep : 0;
    }
  }
}

/// Gives contact points of impacts that pressed in this step the velocity to separate with.
inline void apply_restitution(World& world)
{
  for (int pass = 0; pass < 10; ++pass)
  {
    for (Contact& contact : world.contacts)
    {
      RigidBody &a = world.bodies[contact.a], &b = world.bodies[contact.b];
      if (contact.rebound && contact.total_impulse > 0)
      {
        const double residual = *contact.rebound - separating_velocity<double>(a, b, contact);
        add_impulse<double>(a, b, contact, contact.normal_mass * residual);
      }
    }
  }
}

/// Moves a world on by a time [s], in substeps.
inline void step(World& world, double time)
{
  check("time", time, 1e-6, 0.1);
  check("gravity.norm()", world.gravity.norm(), 0, 1e4);
  find_contacts(world);
  const double substep = time / substeps;
  find_impacts(world, time, substep);
  const Softness<double> spring = softness(spring_rate / substep, damping_ratio, substep);
  for (int i = 0; i < substeps; ++i)
  {
    apply_gravity(world, substep);
    apply_warm_start(world);
    solve(world, spring, substep);
    integrate_positions(world, substep);
    solve(world, rigid<double>(), substep);
  }
  apply_restitution(world);
}

} // namespace cookbook::small_world::step_5
