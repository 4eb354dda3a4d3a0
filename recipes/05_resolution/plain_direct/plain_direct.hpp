#pragma once

/// \file
/// \brief All contact points of the small world as one system of equations, solved directly.

#include "05_resolution/plain_direct/contact_system.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cookbook::small_world::plain_direct
{

// [solve]
/// Stores the impulses in their contact points; the largest change [N s] along a normal.
inline double store_impulses(World& world, const VectorXd& impulses)
{
  double change = 0;
  Index row = 0;
  for (Contact& contact : world.contacts)
  {
    change = std::max(change, std::abs(impulses[row] - contact.impulse));
    contact.impulse = impulses[row];
    contact.friction = impulses.segment<2>(row + 1);
    row += 3;
  }
  return change;
}

/// Cuts the friction of each contact point to its cone; R6.
inline VectorXd clamp_to_cones(World& world, VectorXd impulses)
{
  Index row = 1;
  for (Contact& contact : world.contacts)
  {
    contact.friction =
        within_cone<double, 2>(contact.friction, contact.coefficient * contact.impulse);
    impulses.segment<2>(row) = contact.friction;
    row += 3;
  }
  return impulses;
}

/// The velocities of all bodies after a step [s], from an active set for each set of bounds, until
/// the normal impulses that bound the friction change no more.
inline VectorXd solve(World& world, const System& system, double time, double max_speed)
{
  const VectorXd speeds = compute_speeds(world, system, time, max_speed);
  std::vector<State> states(static_cast<std::size_t>(speeds.size()), State::free);
  VectorXd impulses = VectorXd::Zero(speeds.size());
  bool changes = !world.contacts.empty();
  for (int pass = 0; pass < 20 && changes; ++pass)
  {
    impulses = solve_within(compute_matrix(world, system), speeds, compute_bounds(world), states);
    changes = store_impulses(world, impulses) > 1e-6 * impulses.cwiseAbs().maxCoeff();
  }
  return system.velocities + system.response * clamp_to_cones(world, impulses);
}
// [solve]

// [step]
/// Stores the velocities in their bodies, six numbers for each.
inline void set_velocities(World& world, const VectorXd& velocities)
{
  Index row = 0;
  for (RigidBody& body : world.bodies)
  {
    body.motion.velocity = velocities.segment<3>(row);
    body.motion.angular_velocity = velocities.segment<3>(row + 3);
    row += 6;
  }
}

/// Moves a world on by a time [s]: with velocities that open overlaps; it keeps those that do not.
inline void step(World& world, double time)
{
  check("time", time, 1e-6, 0.1);
  step_4::find_contacts(world);
  const System system = compute_system(world, time);
  set_velocities(world, solve(world, system, time, 1));
  step_4::integrate_positions(world, time);
  set_velocities(world, solve(world, system, time, 0));
}

/// The impulse [N s] along the normals that two bodies exchanged in the last step: over its length,
/// the load [N].
inline double impulse_between(const World& world, std::size_t a, std::size_t b)
{
  double sum = 0;
  for (const Contact& contact : world.contacts)
  {
    sum += contact.a == a && contact.b == b ? contact.impulse : 0;
  }
  return sum;
}
// [step]

} // namespace cookbook::small_world::plain_direct
