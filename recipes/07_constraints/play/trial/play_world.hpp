#pragma once

/// \file
/// \brief A world that is played with: its solver changes while it runs, bodies are pulled and
/// balls thrown.

#include "06_world/game_world/game_world.hpp"
#include "06_world/game_world/solver_names.hpp"
#include "06_world/game_world/world_queries.hpp"
#include "06_world/islands/island_points.hpp"
#include "07_constraints/play/trial/hand.hpp"
#include "07_constraints/play/trial/play_scenes.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cookbook::play
{

/// A solver that another takes the place of while the world runs.
class ChangingSolver
{
public:
  /// Has the world go on by another solver.
  void change(const WorldSolver& to) { *now_ = to; }

  /// Solves by the one of now; copies share it.
  void operator()(IslandView world, std::span<const Island> islands, double step) const
  {
    (*now_)(world, islands, step);
  }

private:
  std::shared_ptr<WorldSolver> now_ = std::make_shared<WorldSolver>(solver_named("soft_steps"));
};

/// A ball to be thrown.
struct Throw
{
  double mass;  ///< [kg]
  double speed; ///< [m/s]
};

/// A world, and what a player does to it.
struct Play
{
  ChangingSolver solver;
  GameWorld world;
  Orbit orbit;
  Hand hand;
  Vector2<double> pointer{0, 0}; ///< [pixels], where it was
  std::vector<BodyId> thrown{};  ///< balls that are there, the oldest first
  int throws = 0;                ///< how many there were

  Play(const Scene& scene, bool may_sleep)
      : world(scene, WorldSolver(solver), may_sleep),
        orbit(orbit_around(scene)),
        hand(add_hand(world))
  {
  }
};

/// A vector of at most this length.
inline Vector3<double> limited(const Vector3<double>& v, double most)
{
  const double length = v.norm();
  return length > most ? Vector3<double>(most / length * v) : v;
}

/// Takes hold of the body that a ray meets first, by a joint that could lift ten times its weight
/// and no more, so that nothing is torn through a wall.
inline bool take_hold(Play& play, const Ray<double>& ray)
{
  constexpr double strongest = 100; // [m/s²]
  const auto force = [](const RigidBody& body) { return strongest / body.inverse_mass; };
  return take_hold(play.world, play.hand, ray, force);
}

/// Throws a ball along a ray, a little higher, so that it passes where the ray meets something.
inline void throw_ball(Play& play, const Ray<double>& ray, const Throw& how)
{
  constexpr std::size_t most = 20;
  constexpr double radius = 0.3;
  const std::optional<BodyHit> met = WorldQueries(play.world).cast(ray);
  const double way = met ? std::min(met->hit.t, 3 * play.orbit.distance) : play.orbit.distance;
  SceneBody ball = ball_body(numbered("thrown", ++play.throws), radius, ray.origin, how.mass);
  ball.velocity = how.speed * ray.direction - way / how.speed / 2 * play.world.scene().gravity;
  if (play.thrown.size() == most)
  {
    play.world.remove(play.thrown.front());
    play.thrown.erase(play.thrown.begin());
  }
  play.thrown.push_back(play.world.add(ball));
}

/// Wakes all bodies, so that another solver has something to do.
inline void wake_all(GameWorld& world)
{
  for (std::size_t i = 0; i < world.bodies().size(); ++i)
  {
    const Motion<double> motion = world.bodies()[i].motion;
    if (world.has(world.id(i)))
    {
      world.set_velocity(world.id(i), motion.velocity, motion.angular_velocity);
    }
  }
}

/// Goes on by a step.
inline void step(Play& play)
{
  pull(play.world, play.hand);
  play.world.step();
}

} // namespace cookbook::play
