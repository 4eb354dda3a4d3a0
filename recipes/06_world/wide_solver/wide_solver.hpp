#pragma once

/// \file
/// \brief Soft steps, many contacts at a time: what one contact teaches, on packs of floats.

#include "06_world/soft_steps/soft_steps.hpp"
#include "06_world/wide_solver/wide_contacts.hpp"

#include <algorithm>
#include <limits>
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
/// Those bodies that turn noticeably in a small step [s].
inline std::vector<TurningBody>
find_turning(IslandView world, double substep, const IslandsTogether& islands)
{
  std::vector<TurningBody> turning;
  islands.for_each_body([&](int i)
                        { add_turning(i, world.bodies[index_of(i)], substep, turning); });
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
  lanes.put_motions(world.bodies);
  lanes.warm_start();
}

/// Finds what impulses feel where any body of an island has turned by what is noticed in a small
/// step [s].
inline void update_masses(IslandView world, double substep, WideContacts& lanes)
{
  bool any = false;
  for (const Island& island : lanes.islands.all())
  {
    if (any_turns_too_far(world, island, substep))
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
/// Soft steps of the islands that `lanes` has, a contact in every lane of a pack of floats, for
/// run_substeps(); R13, R16. Other constraints are solved between the passes, in double.
class WideSteps
{
public:
  static constexpr double rounding = 8 * std::numeric_limits<float>::epsilon(); ///< [1]

  WideSteps(IslandView world, const SoftSettings& settings, WideContacts& lanes)
      : world_(world), settings_(settings), lanes_(lanes)
  {
  }

  int prepare(double step)
  {
    lanes_.take(world_, step / settings_.substeps, settings_.substeps);
    elapsed_ = -step / settings_.substeps / 2;
    each_island([&](const Island& island)
                { prepare_constraints(world_, island, settings_.substeps); });
    return settings_.substeps;
  }

  void solve(double substep)
  {
    each_island(
        [&](const Island& island)
        {
          update_joined_axes(world_, island);
          warm_start_constraints(world_, island, substep);
          solve_constraints(world_, island, joint_spring(substep));
        });
    std::vector<TurningBody> turning = find_turning(world_, substep, lanes_.islands);
    lanes_.put_motions(world_.bodies);
    warm_start(world_, turning, lanes_);
    elapsed_ += substep;
    lanes_.solve(contact_spring(substep, settings_), substep, elapsed_, false);
    lanes_.take_motions(world_.bodies);
  }

  /// Turns bodies, as many at a time as there are lanes.
  void rotate(std::span<const int> pushed, double substep)
  {
    lanes_.turns.rotate(world_.bodies, pushed, substep);
  }

  void relax(double substep)
  {
    each_island(
        [&](const Island& island)
        {
          update_joined_axes(world_, island);
          relax_constraints(world_, island);
        });
    lanes_.put_motions(world_.bodies);
    update_masses(world_, substep, lanes_);
    lanes_.update_separations(substep);
    lanes_.solve(rigid<double>(), substep, elapsed_, true);
    lanes_.take_motions(world_.bodies);
  }

  void store()
  {
    lanes_.islands.for_each_body([&](int i) { update_axes(world_.bodies[index_of(i)]); });
    lanes_.store(world_, settings_.substeps);
    each_island(
        [&](const Island& island)
        {
          store_constraints(world_, island, settings_.substeps);
          apply_torsional_friction(world_, island, settings_.torsional_radius);
        });
  }

private:
  template <class Call>
  void each_island(const Call& call)
  {
    std::for_each(lanes_.islands.all().begin(), lanes_.islands.all().end(), call);
  }

  IslandView world_;
  const SoftSettings& settings_;
  WideContacts& lanes_;
  double elapsed_ = 0; // [s], from the taking of arms to the middle of the small step
};

/// Moves the bodies of islands on by a step [s], as soft_steps() does. They may be of different
/// islands: none feels that there are others.
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
  WideSteps solver(world, settings, lanes);
  run_substeps(world, lanes.islands.all(), step, solver);
}
// [wide_steps]

} // namespace cookbook
