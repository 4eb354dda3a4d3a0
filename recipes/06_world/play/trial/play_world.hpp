#pragma once

/// \file
/// \brief A world that is played with: its solver changes while it runs, bodies are pulled and
/// balls thrown.

#include "06_world/game_world/game_world.hpp"
#include "06_world/game_world/solver_names.hpp"
#include "06_world/game_world/world_inputs.hpp"
#include "06_world/game_world/world_queries.hpp"
#include "06_world/islands/island_points.hpp"
#include "06_world/play/trial/play_scenes.hpp"

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
  void change(const std::string& name, int substeps) { *now_ = solver_named(name, substeps); }

  /// Solves by the one of now; copies share it.
  void operator()(IslandView world, std::span<const Island> islands, double step) const
  {
    (*now_)(world, islands, step);
  }

private:
  std::shared_ptr<WorldSolver> now_ = std::make_shared<WorldSolver>(solver_named("soft_steps"));
};

/// The body that the pointer holds.
struct Held
{
  BodyId body;            ///< which
  Vector3<double> anchor; ///< [m], in the body's frame, where it is held
  Vector3<double> target; ///< [m], world, where the pointer wants that point
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
  std::optional<Held> held{};
  std::vector<BodyId> thrown{}; ///< balls that are there, the oldest first
  int throws = 0;               ///< how many there were

  Play(const Scene& scene, bool may_sleep)
      : world(scene, WorldSolver(solver), may_sleep), orbit(orbit_around(scene))
  {
  }
};

/// A vector of at most this length.
inline Vector3<double> limited(const Vector3<double>& v, double most)
{
  const double length = v.norm();
  return length > most ? Vector3<double>(most / length * v) : v;
}

// [pull]
/// Pulls the held point towards its target: by the impulse of a step, as if it could lift ten times
/// the body's weight and no more, so that nothing is torn through a wall.
inline void pull(GameWorld& world, const Held& held)
{
  constexpr double per_second = 12, fastest = 20, strongest = 100; // [1/s], [m/s], [m/s²]
  const RigidBody& body = world.body(held.body);
  const double h = world.scene().step;
  const Vector3<double> arm = body.orientation * held.anchor;
  const Vector3<double> point = body.motion.center + arm;
  const Vector3<double> wanted = limited(per_second * (held.target - point), fastest);
  const Vector3<double> missing =
      wanted - velocity_at_arm(body.motion, arm) - h * world.scene().gravity;
  const double speed = missing.norm();
  if (speed > 0)
  {
    const Vector3<double> direction = missing / speed;
    const double mass = effective_mass(inverse_mass_at<double>(body, direction, arm));
    const double size = std::min(mass * speed, strongest * h / body.inverse_mass);
    apply_impulse(world, held.body, size * direction, point);
  }
  const Motion<double> moved = world.body(held.body).motion;
  world.set_velocity(held.body, moved.velocity, 0.9 * moved.angular_velocity);
}
// [pull]

/// Takes hold of the body that a ray meets first, and says whether it did: not where that is fixed,
/// or where there is none.
inline bool take_hold(Play& play, const Ray<double>& ray)
{
  const auto movable = [&](BodyId id) { return !is_fixed(play.world.body(id)); };
  const std::optional<BodyHit> met = WorldQueries(play.world).cast(ray);
  play.held.reset();
  if (met && movable(met->body))
  {
    const RigidBody& body = play.world.body(met->body);
    const Vector3<double> point = ray.origin + met->hit.t * ray.direction;
    const Vector3<double> anchor = body.orientation.conjugate() * (point - body.motion.center);
    play.held = {met->body, anchor, point};
  }
  return play.held.has_value();
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
  if (play.held && play.world.has(play.held->body))
  {
    pull(play.world, *play.held);
  }
  play.world.step();
}

} // namespace cookbook::play
