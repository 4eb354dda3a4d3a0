#pragma once

/// \file
/// \brief Bodies to build scenes of: the ground, boxes and balls by name, and turns without sines.

#include "06_world/contacts/scene.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace cookbook
{

/// The ground: all below y = 0.
inline SceneBody ground()
{
  return {.name = "ground", .shape = PlaneShape{{0, 1, 0}, 0}};
}

/// A box upright and at rest: half extents [m], centre [m], mass [kg].
inline SceneBody box_body(
    const std::string& name, const Vector3<double>& half_extents, const Vector3<double>& position,
    double mass = 1)
{
  return {.name = name, .shape = BoxShape{half_extents}, .mass = mass, .position = position};
}

/// A cube of 1 m, upright and at rest: centre [m], mass [kg].
inline SceneBody
cube_body(const std::string& name, const Vector3<double>& position, double mass = 1)
{
  return box_body(name, {0.5, 0.5, 0.5}, position, mass);
}

/// A ball at rest: radius [m], centre [m], mass [kg].
inline SceneBody
ball_body(const std::string& name, double radius, const Vector3<double>& position, double mass = 1)
{
  return {.name = name, .shape = SphereShape{radius}, .mass = mass, .position = position};
}

/// A body that the game moves, without a mass, otherwise like another.
inline SceneBody kinematic(SceneBody body)
{
  body.mass = 0;
  body.motion = MotionType::kinematic;
  return body;
}

/// The name of the one with a number, such as `box_7`.
inline std::string numbered(const std::string& what, int number)
{
  return std::string(what).append("_").append(std::to_string(number));
}

// [whole_turn]
/// The unit quaternion along whole numbers w, x, y, z, not all zero.
///
/// It takes one square root and four divisions, which are rounded alike on every machine; sines are
/// not.
inline Quaternion<double> whole_turn(int w, int x, int y, int z)
{
  const double length = std::sqrt(static_cast<double>(w * w + x * x + y * y + z * z));
  return {w / length, x / length, y / length, z / length};
}

/// The unit quaternion of a turn about z by the angle with this sine and cosine, cosine above −1.
inline Quaternion<double> turn_about_z(double sine, double cosine)
{
  const double half_cosine = std::sqrt((1 + cosine) / 2);
  return {half_cosine, 0, 0, sine / (2 * half_cosine)};
}
// [whole_turn]

/// How many bodies of a scene can move, to share a time among them; one if there is none.
inline double movable_bodies(const Scene& scene)
{
  const auto movable = [](const SceneBody& body) { return body.mass > 0; };
  const auto count = std::count_if(scene.bodies.begin(), scene.bodies.end(), movable);
  return std::max(1.0, static_cast<double>(count));
}

/// The momentum [kg m/s] of each body of a scene, whatever its direction, all together: what
/// rounding of their sum is to be held against.
inline double momentum_of_each(const Scene& scene)
{
  double sum = 0;
  for (const SceneBody& body : scene.bodies)
  {
    sum += body.mass * body.velocity.norm();
  }
  return sum;
}

} // namespace cookbook
