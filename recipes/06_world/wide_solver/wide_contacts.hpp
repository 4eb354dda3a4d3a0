#pragma once

/// \file
/// \brief The contacts of islands side by side, colour by colour, and all that is done to them.

#include "06_world/soft_steps/stick_drift.hpp"
#include "06_world/wide_solver/islands_together.hpp"
#include "06_world/wide_solver/lane_numbers.hpp"
#include "06_world/wide_solver/passes_in_lanes.hpp"
#include "06_world/wide_solver/wide_rotations.hpp"
#include "common/simd/lanes.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace cookbook
{

// [widest_passes]
/// The passes in the widest registers of this processor, where cookbook::wide_passes is linked;
/// otherwise in those of the processors that this file is compiled for. All give the same bits.
#if defined(COOKBOOK_WIDE_PASSES)
WidePasses widest_passes();
#else
inline WidePasses widest_passes()
{
  return passes_in_lanes<Lanes>();
}
#endif
// [widest_passes]

/// The contacts of islands, and their bodies, as lanes.
class WideContacts
{
public:
  /// Lanes for these passes.
  explicit WideContacts(const WidePasses& passes = widest_passes()) : turns(passes), passes_(passes)
  {
  }

  IslandsTogether islands; ///< those whose contacts are taken
  WideRotations turns;     ///< how their bodies move on

  /// Takes the contacts of all islands, their impulses as they are for one of so many small steps
  /// [s].
  void take(IslandView world, double substep, int substeps)
  {
    const double fraction = 1.0 / substeps;
    take_bodies(world);
    groups_.find(world, islands.contacts(), passes_.lanes);
    numbers_.clear(groups_, passes_.lanes, static_cast<int>(world.bodies.size()));
    for_each_contact(
        world,
        [&](const WorldContact& contact, std::size_t lane)
        {
          numbers_.put(contact, lane);
          std::size_t place = moving_first(lane);
          const RigidBody& a = world.bodies[index_of(contact.a)];
          const RigidBody& b = world.bodies[index_of(contact.b)];
          const ContactFrame frame = frame_of(a, b, contact, lagged_axes);
          for (const WorldPoint& point : contact.points)
          {
            ContactConstraint<double> at = constraint_of(a, b, contact, frame, point);
            at.impulse *= fraction;
            at.friction *= fraction;
            at.drift = drift_of(at, a, b, substep);
            numbers_.put(at, place++, lane);
          }
        });
    compute_masses();
  }

  /// Finds what impulses feel, by the inverse masses that the bodies have here.
  void compute_masses() { passes_.compute_masses(view()); }

  /// Pushes as the step before has ended.
  void warm_start() { passes_.warm_start(view()); }

  /// Forgets what the points of these bodies have been given.
  void discard_warm_start(IslandView world, std::span<const TurningBody> bodies)
  {
    for_each_contact(
        world,
        [&](const WorldContact& contact, std::size_t lane)
        {
          const auto touches = [&](const TurningBody& one)
          { return one.number == contact.a || one.number == contact.b; };
          if (std::any_of(bodies.begin(), bodies.end(), touches))
          {
            for (std::size_t i = 0; i < contact.points.size(); ++i)
            {
              numbers_.discard_warm_start(moving_first(lane) + i, lane);
            }
          }
        });
  }

  /// Corrects every point once, with a spring, in a small step [s], whose middle is a time [s]
  /// after arms were taken; whether that is the last time.
  void solve(const Softness<double>& spring, double substep, double elapsed, bool last)
  {
    const auto rounded = [](double number) { return static_cast<float>(number); };
    passes_.solve(
        view(),
        {rounded(spring.bias_rate), rounded(spring.mass_scale), rounded(spring.impulse_scale)},
        rounded(substep), rounded(elapsed), last);
  }

  /// Carries all gaps on for a small step [s].
  void update_separations(double substep)
  {
    passes_.update_separations(view(), static_cast<float>(substep));
  }

  /// Writes down what the points have been given in so many small steps.
  void store(IslandView world, int substeps)
  {
    const float scale = static_cast<float>(substeps);
    for_each_contact(
        world,
        [&](WorldContact& contact, std::size_t lane)
        {
          std::size_t place = moving_first(lane);
          const SurfaceAxes<double> surface = surface_axes(contact.normal);
          for (WorldPoint& known : contact.points)
          {
            const ContactConstraint<float> at = numbers_.pushed(place++, lane);
            known.impulse = at.total_impulse;
            known.warm_start_impulse = scale * at.impulse;
            known.friction = surface.in_world((scale * at.friction).cast<double>());
          }
        });
  }

  /// Takes how the bodies of all islands move.
  void put_motions(std::span<const RigidBody> bodies)
  {
    islands.for_each_body([&](int i) { put_motion(bodies[index_of(i)], body(i)); });
  }

  /// Gives them back how they are pushed here.
  void take_motions(std::span<RigidBody> bodies)
  {
    islands.for_each_body([&](int i) { take_motion(body(i), bodies[index_of(i)]); });
  }

  /// A body of the world, to be pushed here.
  LaneBody& body(int number) { return bodies_[index_of(number)]; }

private:
  WideView view() { return numbers_.view(groups_.all(), bodies_.data()); }

  /// The place of the first point of a lane.
  std::size_t moving_first(std::size_t lane) const
  {
    return groups_.all()[lane / passes_.lanes].first;
  }

  /// Calls `call(contact, lane)` for all contacts, with their lanes among all.
  template <class Call>
  void for_each_contact(IslandView world, const Call& call)
  {
    for (std::size_t lane = 0; lane < groups_.taken().size(); ++lane)
    {
      const int taken = groups_.taken()[lane];
      if (taken != WideGroups::none)
      {
        call(world.contacts[index_of(islands.contacts()[index_of(taken)])], lane);
      }
    }
  }

  /// Bodies have their places in the world; behind them is the null body, whose numbers are all
  /// zero, as of what is fixed: nothing moves it. A kinematic one only has its velocities.
  void take_bodies(IslandView world)
  {
    bodies_.assign(world.bodies.size() + 1, {});
    for (std::size_t island = 0; island < islands.all().size(); ++island)
    {
      const float speed = static_cast<float>(islands.correction_speeds()[island]);
      for (const int i : islands.all()[island].bodies)
      {
        put_inverse_masses(world.bodies[index_of(i)], body(i));
        body(i).inverse_inertia[3] = speed;
      }
    }
    for (const int i : islands.contacts())
    {
      for (const int one : {world.contacts[index_of(i)].a, world.contacts[index_of(i)].b})
      {
        if (is_driven(world.bodies[index_of(one)]))
        {
          put_motion(world.bodies[index_of(one)], body(one));
        }
      }
    }
  }

  WidePasses passes_;
  WideGroups groups_;
  LaneNumbers numbers_;
  std::vector<LaneBody> bodies_; // by their places in the world
};

} // namespace cookbook
