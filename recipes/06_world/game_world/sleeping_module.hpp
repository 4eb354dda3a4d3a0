#pragma once

/// \file
/// \brief Sleeping, as a module of a world: islands at rest are neither solved nor moved.

#include "01_math/turning/turn_between.hpp"
#include "06_world/game_world/world_state.hpp"
#include "06_world/sleeping/sleeping.hpp"

#include <algorithm>
#include <vector>

namespace cookbook
{

// [sleeping_module]
/// Puts islands that rest to sleep, and wakes them when something reaches them.
class Sleeping : public WorldModule
{
public:
  /// Puts islands that rest to sleep, and wakes the others: also all that touch or hang on a
  /// kinematic body in motion, and those of a joint that the game has changed.
  void predict(WorldState& world) override
  {
    states_.resize(world.bodies.size());
    const auto wake = [&](const auto& pair, bool changed)
    {
      const std::size_t a = index_of(pair.a), b = index_of(pair.b);
      if (changed || is_driven(world.bodies[a]) || is_driven(world.bodies[b]))
      {
        states_[a] = states_[b] = {};
      }
    };
    for (const WorldContact& contact : world.contacts)
    {
      wake(contact, false);
    }
    for (const ConstraintPair& pair : world.constraints)
    {
      wake(pair, pair.changed);
    }
    update_sleep(states_, world.islands.numbers(), SleepLimits<double>{});
    publish(world);
  }

  /// Watches whether the bodies that are awake rest; those that the game moves need not.
  void finished(WorldState& world) override
  {
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
    {
      if (!is_inactive(world, static_cast<int>(i)) && !is_driven(world.bodies[i]))
      {
        update_timer(world, i);
      }
    }
  }

  /// Wakes bodies, with all that hangs together with them. For those that are awake it is enough to
  /// begin their watch anew.
  void changed(WorldState& world, Bodies bodies) override
  {
    states_.resize(world.bodies.size());
    const auto asleep = [&](int body) { return is_asleep(world, body); };
    if (std::any_of(bodies.begin(), bodies.end(), asleep))
    {
      find_islands(world);
      hit(world, bodies);
    }
    for (const int body : bodies)
    {
      states_[index_of(body)] = {};
    }
  }

  /// Wakes the islands of bodies.
  void hit(WorldState& world, Bodies bodies) override
  {
    wake(states_, world.islands.numbers(), bodies);
    publish(world);
  }

private:
  void publish(WorldState& world) const
  {
    world.asleep.resize(states_.size());
    for (std::size_t i = 0; i < states_.size(); ++i)
    {
      world.asleep[i] = states_[i].asleep;
    }
  }

  /// Watches whether a body rests: what is pulled and falls freely does not, nor what is moved out
  /// of an overlap, whatever its velocity. Damps what nearly rests.
  void update_timer(WorldState& world, std::size_t i)
  {
    const double step = world.scene.step;
    RigidBody& body = world.bodies[i];
    const PreviousState start = start_state(world, i);
    const auto larger = [](const Vector3<double>& one, const Vector3<double>& other)
    { return one.squaredNorm() > other.squaredNorm() ? one : other; };
    const Vector3<double> displacement = body.motion.center - start.motion.center;
    const Vector3<double> turn = turn_between<double>(start.orientation, body.orientation);
    const bool falls = world.falls[i] && !acceleration_on(world, i).acceleration.isZero(0);
    const double radius = bounds_of(body, world.scene.bodies[i].shape, 0).sizes().norm() / 2;
    if (!world.falls[i])
    {
      const double slower = rest_damping<double>(
          body.motion.velocity, body.motion.angular_velocity, radius, step, SleepLimits<double>{});
      body.motion.velocity *= slower;
      body.motion.angular_velocity *= slower;
    }
    const SleepState<double> before = falls ? SleepState<double>{} : states_[i];
    states_[i] = update_sleep_state<double>(
        before, larger(body.motion.velocity, displacement / step),
        larger(body.motion.angular_velocity, turn / step), radius, step, SleepLimits<double>{});
  }

  std::vector<SleepState<double>> states_; // of all bodies
};
// [sleeping_module]

} // namespace cookbook
