#pragma once

/// \file
/// \brief Soft steps, many contacts at a time: what one contact teaches, on packs of floats.

#include "06_world/soft_steps/soft_steps.hpp"
#include "06_world/wide_solver/wide_contacts.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace cookbook
{

// [fits_floats]
/// Whether what an island is about to be pushed by fits into floats, and its squares, too.
inline bool fits_floats(IslandView world, const Island& island, double step)
{
  constexpr double most = 1e15;
  const auto motion_fits = [&](const Motion<double>& motion)
  {
    return motion.velocity.cwiseAbs().maxCoeff() <= most &&
           motion.angular_velocity.cwiseAbs().maxCoeff() <= most;
  };
  const auto fits = [&](int i)
  {
    const RigidBody& body = world.bodies[index_of(i)];
    const double turning = body.inverse_inertia.cwiseAbs().maxCoeff();
    return body.inverse_mass * most >= 1 && body.inverse_mass <= most && turning <= most * most &&
           motion_fits(accelerated(body.motion, acceleration_on(world, i), step));
  };
  const auto driven_fit = [&](int i)
  {
    const WorldContact& contact = world.contacts[index_of(i)];
    const RigidBody &a = world.bodies[index_of(contact.a)], &b = world.bodies[index_of(contact.b)];
    return (!is_driven(a) || motion_fits(a.motion)) && (!is_driven(b) || motion_fits(b.motion));
  };
  return std::all_of(island.bodies.begin(), island.bodies.end(), fits) &&
         std::all_of(island.contacts.begin(), island.contacts.end(), driven_fit);
}
// [fits_floats]

// [wide_bodies]
/// Has forces pull all bodies for a small step [s]; those that turn noticeably in it.
inline std::vector<TurningBody> apply_forces(IslandView world, double substep, WideContacts& lanes)
{
  std::vector<TurningBody> turning;
  lanes.islands.for_each_body(
      [&](int i)
      {
        RigidBody& body = world.bodies[index_of(i)];
        take_motion(lanes.body(i), body);
        apply_forces(world, i, substep);
        put_motion(body, lanes.body(i));
        add_turning(i, body, substep, turning);
      });
  return turning;
}

/// Pushes as the step before has ended; of those that turn noticeably, which are reordered, whoever
/// would gain energy by it starts from nothing.
inline void warm_start(IslandView world, std::span<TurningBody> turning, WideContacts& lanes)
{
  lanes.warm_start();
  const auto gains = [&](const TurningBody& one)
  {
    RigidBody pushed = world.bodies[index_of(one.number)];
    take_motion(lanes.body(one.number), pushed);
    return kinetic_energy(pushed) > one.energy;
  };
  const auto cold = std::partition(turning.begin(), turning.end(), gains);
  if (cold == turning.begin())
  {
    return;
  }
  lanes.discard_warm_start(world, {turning.begin(), cold});
  lanes.islands.for_each_body([&](int i) { put_motion(world.bodies[index_of(i)], lanes.body(i)); });
  lanes.warm_start();
}

/// Moves all bodies on by a small step [s], and finds what impulses feel, where any of an island
/// turns by what is noticed.
inline void move(IslandView world, double substep, WideContacts& lanes)
{
  lanes.turns.move(
      world.bodies, lanes.islands, substep,
      [&](int i, RigidBody& body) { take_motion(lanes.body(i), body); });
  bool any = false;
  for (const Island& island : lanes.islands.all())
  {
    bool turned = false;
    for (const int i : island.bodies)
    {
      const RigidBody& body = world.bodies[index_of(i)];
      put_motion(body, lanes.body(i));
      turned = turned || turns_too_far(body, substep);
    }
    if (turned)
    {
      any = true;
      for (const int i : island.bodies)
      {
        update_axes(world.bodies[index_of(i)]);
        put_inverse_masses(world.bodies[index_of(i)], lanes.body(i));
      }
    }
  }
  if (any)
  {
    lanes.compute_masses();
  }
}
// [wide_bodies]

// [wide_steps]
/// Moves the bodies of islands on by a step [s], as soft_steps() does, a contact in every lane of a
/// pack of floats; R13, R16. They may be of different islands: none feels that there are others.
///
/// Contacts come colour by colour, so that the order differs from that of soft_steps(), and with it
/// the answer; poses stay in double. What does not fit into floats is left to soft_steps(). `lanes`
/// is kept from step to step for its room alone.
inline void wide_steps(
    IslandView world, std::span<const Island> islands, double step, const SoftSettings& settings,
    WideContacts& lanes)
{
  lanes.islands.clear();
  for (const Island& island : islands)
  {
    if (fits_floats(world, island, step))
    {
      update_lagged_anchors(world, island, settings.anchor_lag);
      lanes.islands.add(island, island_correction_speed(world, island, step, settings));
    }
    else
    {
      soft_steps(world, island, step, settings);
    }
  }
  const double substep = step / settings.substeps;
  lanes.take(world, settings.substeps);
  for (int i = 0; i < settings.substeps; ++i)
  {
    std::vector<TurningBody> turning = apply_forces(world, substep, lanes);
    warm_start(world, turning, lanes);
    lanes.solve(contact_spring(substep, settings), substep, false);
    move(world, substep, lanes);
    lanes.update_separations(substep);
    lanes.solve(rigid<double>(), substep, true);
  }
  lanes.islands.for_each_body(
      [&](int i)
      {
        take_motion(lanes.body(i), world.bodies[index_of(i)]);
        update_axes(world.bodies[index_of(i)]);
      });
  lanes.store(world, settings.substeps);
  for (const Island& island : lanes.islands.all())
  {
    apply_torsional_friction(world, island, settings.torsional_radius);
  }
}
// [wide_steps]

} // namespace cookbook
