#pragma once

/// \file
/// \brief A small world, step 6: islands and sleeping.

#include "02_primitives/shape_bounds/obb_bounds.hpp"
#include "05_resolution/contact_constraint/soft_contact.hpp"
#include "05_resolution/restitution/rebound_speed.hpp"
#include "05_resolution/small_world/small_body.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace cookbook::small_world::step_6
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
  std::vector<Contact> asleep;    ///< those between bodies that sleep or never move
  std::vector<double> rest_times; ///< [s], for which each body has hardly moved
};

/// How long [s] a body rests before it falls asleep.
inline constexpr double time_to_sleep = 0.5;

/// Whether a body is asleep: neither collided, solved nor moved.
inline bool is_asleep(const World& world, std::size_t i)
{
  return world.rest_times[i] >= time_to_sleep;
}

/// Whether nothing moves a body: it is fixed, or asleep.
inline bool is_still(const World& world, std::size_t i)
{
  const RigidBody& body = world.bodies[i];
  const bool moves = !body.motion.velocity.isZero(0) || !body.motion.angular_velocity.isZero(0);
  return is_asleep(world, i) || (body.inverse_mass == 0 && !moves);
}

/// Wakes a body, and with it its island; call it after changing one that sleeps.
inline void wake(World& world, std::size_t i)
{
  world.rest_times[i] = 0;
}

/// Adds a body and returns its place; refuses one that is outside the ranges of check().
inline std::size_t add(World& world, const RigidBody& body)
{
  check(body);
  world.bodies.push_back(body);
  world.rest_times.push_back(0);
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

/// Adds the contact points of two bodies, if they touch and one of them moves.
inline void collide(World& world, std::size_t i, std::size_t j)
{
  const RigidBody &a = world.bodies[i], &b = world.bodies[j];
  if ((a.inverse_mass == 0 && b.inverse_mass == 0) || (is_still(world, i) && is_still(world, j)))
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

/// Of a body, the place of the body that stands for its whole island (union-find).
inline std::size_t find_island(std::vector<std::size_t>& parents, std::size_t i)
{
  while (parents[i] != i)
  {
    i = parents[i] = parents[parents[i]];
  }
  return i;
}

/// Islands, as the parents of all bodies: those that touch, directly or through others, but not
/// through a fixed one. A contact with a fixed body that moves keeps an island awake.
inline std::vector<std::size_t> find_islands(World& world)
{
  std::vector<std::size_t> parents(world.bodies.size());
  std::iota(parents.begin(), parents.end(), std::size_t(0));
  const auto join = [&](const Contact& contact)
  {
    const bool a_moves = world.bodies[contact.a].inverse_mass > 0;
    const bool b_moves = world.bodies[contact.b].inverse_mass > 0;
    if (a_moves && b_moves)
    {
      parents[find_island(parents, contact.a)] = find_island(parents, contact.b);
    }
    else if (!is_still(world, a_moves ? contact.b : contact.a))
    {
      wake(world, a_moves ? contact.a : contact.b);
    }
  };
  std::for_each(world.contacts.begin(), world.contacts.end(), join);
  std::for_each(world.asleep.begin(), world.asleep.end(), join);
  return parents;
}

/// Gives all bodies of an island the shortest rest of any: it is awake, or asleep, as a whole.
inline void share_rest(World& world)
{
  std::vector<std::size_t> parents = find_islands(world);
  std::vector<double> shortest(parents.size(), time_to_sleep);
  for (std::size_t i = 0; i < parents.size(); ++i)
  {
    double& rest = shortest[find_island(parents, i)];
    rest = std::min(rest, world.rest_times[i]);
  }
  for (std::size_t i = 0; i < parents.size(); ++i)
  {
    const bool is_fixed = world.bodies[i].inverse_mass == 0;
    world.rest_times[i] = is_fixed ? 0 : shortest[find_island(parents, i)];
  }
}

/// Moves contact points from one list to another: those that are asleep now, or those that are not.
inline void
move_contacts(const World& world, std::vector<Contact>& from, std::vector<Contact>& to, bool asleep)
{
  const auto stays = [&](const Contact& contact)
  { return asleep != (is_still(world, contact.a) && is_still(world, contact.b)); };
  const auto moved = std::stable_partition(from.begin(), from.end(), stays);
  to.insert(to.end(), moved, from.end());
  from.erase(moved, from.end());
}

/// After a step of a time [s]: updates how long each body has rested on others, and puts whole
/// islands to sleep.
inline void put_to_sleep(World& world, double time)
{
  std::vector<bool> touches(world.bodies.size());
  for (const std::vector<Contact>* contacts : {&world.contacts, &world.asleep})
  {
    for (const Contact& contact : *contacts)
    {
      touches[contact.a] = touches[contact.b] = true;
    }
  }
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    const auto& [center, velocity, angular_velocity] = world.bodies[i].motion;
    const double speed =
        fastest_point<double>(velocity, angular_velocity, world.bodies[i].half_extents.norm());
    const bool rests = touches[i] && speed <= 0.05;
    world.rest_times[i] = rests ? world.rest_times[i] + time : 0;
  }
  share_rest(world);
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    if (is_asleep(world, i))
    {
      world.bodies[i].motion.velocity.setZero();
      world.bodies[i].motion.angular_velocity.setZero();
    }
  }
  move_contacts(world, world.contacts, world.asleep, true);
}

/// Finds all contact points, and gives them the impulses of the step before.
inline void find_contacts(World& world)
{
  std::vector<Contact> before = std::move(world.contacts);
  world.contacts.clear();
  find_pairs(world);
  share_rest(world);
  const std::size_t awake = before.size();
  move_contacts(world, world.asleep, before, false);
  if (before.size() > awake) // bodies have woken: find their contacts too
  {
    std::sort(before.begin(), before.end(), comes_before);
    world.contacts.clear();
    find_pairs(world);
  }
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
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    if (!is_still(world, i))
    {
      integrate_position(world.bodies[i], time);
    }
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
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    if (world.bodies[i].inverse_mass > 0 && !is_asleep(world, i))
    {
      world.bodies[i].motion.velocity += time * world.gravity;
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
  put_to_sleep(world, time);
}

} // namespace cookbook::small_world::step_6
