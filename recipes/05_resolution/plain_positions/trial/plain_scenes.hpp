#pragma once

/// \file
/// \brief More scenes for the small world's data: loads, slopes, slides and piles.

#include "05_resolution/small_world/trial/small_scenes.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>

namespace cookbook::small_world
{

/// A cube of a mass [kg] on one of 1 kg, both of 1 m.
template <class World>
World heavy_on_light(double mass)
{
  World world = tower<World>(1);
  add(world, box({0, 1.5, 0}, {0.5, 0.5, 0.5}, mass));
  return world;
}

/// A cube on a plane that falls along x by an angle [°], both of a friction [1].
template <class World>
World slope(double degrees, double friction)
{
  World world;
  RigidBody plane = box({0, 0, 0}, {100, 0.5, 100}, 0);
  const double angle = -degrees * std::numbers::pi / 180;
  set_orientation(plane, rotation_by<double>({0, 0, angle}));
  plane.friction = friction;
  add(world, plane);
  RigidBody block = cube(plane.orientation * Vector3<double>::UnitY());
  block.friction = friction;
  set_orientation(block, plane.orientation);
  add(world, block);
  return world;
}

/// How far [m] the last body of a world goes in a time [s].
template <class World>
double distance_gone(World world, double time)
{
  const Vector3<double> start = world.bodies.back().motion.center;
  run(world, time);
  return (world.bodies.back().motion.center - start).norm();
}

/// How far [m] the cube of slope() slides in a time [s]: half a t², a = g (sin θ - μ cos θ).
inline double right_slide(double degrees, double friction, double time)
{
  const double angle = degrees * std::numbers::pi / 180;
  const double acceleration = 9.81 * (std::sin(angle) - friction * std::cos(angle));
  return 0.5 * std::max(0.0, acceleration) * time * time;
}

/// Twenty oriented boxes and spheres of 0.1 to 1.9 kg that fall onto each other.
template <class World>
World pile(unsigned seed)
{
  std::mt19937 random(seed);
  const auto next = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; }; // -1 to 1
  World world = ground<World>();
  for (int i = 0; i < 20; ++i)
  {
    const double x = 1.5 * next(), z = 1.5 * next(), size = 0.3 + 0.2 * next();
    const Vector3<double> center(x, 1 + 0.8 * i, z);
    const double mass = 1 + 0.9 * next();
    RigidBody body = i % 2 == 0 ? box(center, {size, 0.3, 0.4}, mass) : sphere(center, size, mass);
    const double turn_x = next(), turn_y = next(), turn_z = next();
    set_orientation(body, Quaternion<double>(1, turn_x, turn_y, turn_z));
    add(world, body);
  }
  return world;
}

/// Whether every body of a pile is no deeper in the ground than it can fall within a frame, and no
/// faster than it fell: neither is so of what is not a number.
template <class World>
bool is_sane(const World& world)
{
  return std::all_of(
      world.bodies.begin() + 1, world.bodies.end(),
      [](const RigidBody& body)
      { return body.motion.center.y() > -0.3 && body.motion.velocity.norm() < 20; });
}

} // namespace cookbook::small_world
