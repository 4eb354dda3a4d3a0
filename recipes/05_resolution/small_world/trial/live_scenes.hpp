#pragma once

/// \file
/// \brief The scenes of the live figure, a ball to throw at them, and what is measured of a world.

#include "05_resolution/small_world/trial/small_scenes.hpp"
#include "05_resolution/small_world/trial/small_world_picture.hpp"

#include <string>
#include <vector>

namespace cookbook::small_world
{

/// Five balls that fall from 3 m, with a restitution of 0, ¼, ½, ¾ and 1.
template <class World>
World dropped_spheres()
{
  World world = ground<World>();
  for (int i = 0; i < 5; ++i)
  {
    RigidBody ball = sphere({1.2 * (i - 2), 3.3, 0}, 0.3, 1);
    ball.restitution = 0.25 * i;
    add(world, ball);
  }
  return world;
}

/// A ball of 10 cm that flies at 30 m/s at a wall of 2 cm, which stands on the ground.
template <class World>
World ball_at_wall()
{
  World world = ground<World>();
  add(world, box({0, 1, 0}, {0.01, 1, 1.5}, 0));
  RigidBody ball = sphere({-3.2, 1.2, 0}, 0.1, 1);
  ball.restitution = 0.5;
  ball.motion.velocity.x() = 30;
  add(world, ball);
  return world;
}

/// Cubes and balls, 40 of them, that fall onto a heap; each cube is turned.
template <class World>
World heap()
{
  World world = ground<World>();
  for (int i = 0; i < 40; ++i)
  {
    const Vector3<double> center(
        1.1 * (i % 3 - 1) + 0.1 * (i % 4), 0.8 + 1.1 * (i / 9),
        1.1 * (i / 3 % 3 - 1) + 0.1 * (i % 5));
    RigidBody body = i % 3 == 2 ? sphere(center, 0.3, 1) : box(center, {0.3, 0.3, 0.3}, 1);
    set_orientation(body, Quaternion<double>(4, i % 4 - 1.5, i % 3 - 1, i % 5 - 2));
    add(world, body);
  }
  return world;
}

/// A scene: what it is called, how it is looked at, and where a ball is thrown.
template <class World>
struct LiveScene
{
  std::string name;
  World (*make)();
  double distance;      ///< [m] of the camera
  double aim;           ///< [m] how high over the middle a ball is aimed
  Vector3<double> from; ///< [m] where it is thrown
};

/// From where a ball is thrown at most scenes.
inline const Vector3<double> from_the_front{-3, 1.5, 6};

/// The scenes of the seven steps.
struct StepScenes
{
  static constexpr int most_balls = 12; ///< that may be thrown at a scene

  /// The list of them.
  template <class World>
  static std::vector<LiveScene<World>> list()
  {
    const Vector3<double> front = from_the_front, left(-6, 1.2, 0);
    return {
        {"tower of 10", [] { return tower<World>(10); }, 16, 6, front},
        {"tower of 5", [] { return tower<World>(5); }, 11, 3, front},
        {"pyramid of 55", [] { return pyramid<World>(10); }, 18, 4, front},
        {"heap of 40", heap<World>, 11, 1, front},
        {"floor of 36 cubes", [] { return floor_of_cubes<World>(6); }, 12, 0.4, front},
        {"five bouncing balls", dropped_spheres<World>, 9, 0.4, front},
        {"ball at a thin wall", ball_at_wall<World>, 8, 1, left}};
  }
};

/// Throws a ball of 4 kg from a place at a point [m] over the middle, at a speed [m/s].
template <class World>
void throw_ball(World& world, const Vector3<double>& from, double aim, double speed)
{
  const Vector3<double> way = Vector3<double>(0, aim, 0) - from;
  const double time = way.norm() / speed;
  RigidBody ball = sphere(from, 0.3, 4);
  ball.restitution = 0.3;
  ball.motion.velocity = way / time - time / 2 * world.gravity;
  add(world, ball);
}

/// The energy [J] of a body in motion and of its height above y = 0; of a fixed one, none.
inline double energy_of(const RigidBody& body, const Vector3<double>& gravity)
{
  if (body.inverse_mass == 0)
  {
    return 0;
  }
  const auto& [center, velocity, angular_velocity] = body.motion;
  const Vector3<double> spin = body.orientation.conjugate() * angular_velocity;
  const double turning = spin.cwiseAbs2().dot(body.moments) / 2;
  return (velocity.squaredNorm() / 2 - gravity.dot(center)) / body.inverse_mass + turning;
}

/// What is measured of a world.
struct Measured
{
  double energy = 0;        ///< [J]
  double overlap = 0;       ///< [m], the deepest
  std::size_t contacts = 0; ///< the contact points that a step solves
  std::size_t awake = 0;    ///< the bodies that are moved
};

/// Measures a world.
template <class World>
Measured measure(const World& world)
{
  Measured measured{.contacts = world.contacts.size()};
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    measured.energy += energy_of(world.bodies[i], world.gravity);
    measured.awake += world.bodies[i].inverse_mass > 0 && !sleeps(world, i) ? 1U : 0U;
  }
  const auto deepen = [&](const auto& contacts)
  {
    for (const auto& contact : contacts)
    {
      measured.overlap = std::max(measured.overlap, -contact.separation);
    }
  };
  deepen(world.contacts);
  if constexpr (requires { world.asleep; })
  {
    deepen(world.asleep);
  }
  return measured;
}

} // namespace cookbook::small_world
