#pragma once

/// \file
/// \brief A level of the game: bricks, pigs, and how many birds there are against them.

// [head]
#include "05_resolution/small_world/small_world.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace cookbook::game
{
// [head]

// [level]
/// What a brick is made of, by its density [kg/m³].
enum class Material
{
  wood = 500,
  stone = 2500
};

/// A brick, seen from the side: x to the right, y up. All bricks are equally deep.
struct Brick
{
  Material material;
  Vector2<double> center;       ///< [m]
  Vector2<double> half_extents; ///< [m]
};

/// A pig, and the push that breaks it.
struct Pig
{
  Vector2<double> center; ///< [m]
  double radius;          ///< [m]
  double strength;        ///< [N s], an impulse above it breaks the pig
};

/// Where a game begins.
struct Level
{
  std::string name;
  int birds;
  std::vector<Brick> bricks;
  std::vector<Pig> pigs;
};

/// Half of how deep [m] every brick is, along z.
inline constexpr double half_depth = 0.25;
/// The mass [kg] of every pig.
inline constexpr double pig_mass = 40;
// [level]

// [bodies]
/// A point of the side view in the world.
inline Vector3<double> in_world(const Vector2<double>& point)
{
  return {point.x(), point.y(), 0};
}

/// The ground, from 10 m behind the sling to 25 m before it: what rolls further falls.
inline small_world::RigidBody body_of_ground()
{
  return small_world::box({7.5, -0.5, 0}, {17.5, 0.5, 30}, 0);
}

/// The body that a brick is.
inline small_world::RigidBody body_of(const Brick& brick)
{
  const Vector3<double> half(brick.half_extents.x(), brick.half_extents.y(), half_depth);
  const double volume = 8 * half.prod();
  return small_world::box(
      in_world(brick.center), half, volume * static_cast<double>(brick.material));
}

/// The body that a pig is.
inline small_world::RigidBody body_of(const Pig& pig)
{
  return small_world::sphere(in_world(pig.center), pig.radius, pig_mass);
}
// [bodies]

// [check]
/// Refuses bodies that overlap by more than a centimetre: they would fly apart at the first step.
inline void check_apart(
    const std::vector<small_world::RigidBody>& bodies, const std::vector<std::string>& names)
{
  for (std::size_t j = 1; j < bodies.size(); ++j)
  {
    for (std::size_t i = 0; i < j; ++i)
    {
      const auto manifold = small_world::manifold_of(bodies[i], bodies[j]);
      if (manifold && manifold->depth > 0.01)
      {
        throw std::invalid_argument(
            names[i] + " and " + names[j] + " overlap by " + std::to_string(manifold->depth) +
            " m; it must be at most 0.01 m");
      }
    }
  }
}

/// Refuses a level that cannot be played, by the member that is wrong and its value.
inline void check(const Level& level)
{
  using small_world::check;
  check("birds", level.birds, 1, 9);
  check("number of pigs", static_cast<double>(level.pigs.size()), 1, 9);
  check("number of bricks", static_cast<double>(level.bricks.size()), 0, 60);
  std::vector<small_world::RigidBody> bodies{body_of_ground()};
  std::vector<std::string> names{"the ground"};
  const auto add = [&](const std::string& name, const auto& part)
  {
    check(name + ": center.x()", part.center.x(), 3, 22);
    check(name + ": center.y()", part.center.y(), 0, 20);
    bodies.push_back(body_of(part));
    names.push_back(name);
  };
  for (const Pig& pig : level.pigs)
  {
    const std::string name = "pig " + std::to_string(names.size());
    check(name + ": radius", pig.radius, 0.1, 1);
    check(name + ": strength", pig.strength, 1, 1e4);
    add(name, pig);
  }
  for (const Brick& brick : level.bricks)
  {
    const std::string name = "brick " + std::to_string(names.size() - level.pigs.size());
    check(name + ": half_extents.x()", brick.half_extents.x(), 0.05, 5);
    check(name + ": half_extents.y()", brick.half_extents.y(), 0.05, 5);
    add(name, brick);
  }
  check_apart(bodies, names);
}
// [check]

} // namespace cookbook::game
