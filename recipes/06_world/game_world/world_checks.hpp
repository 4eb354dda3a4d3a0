#pragma once

/// \file
/// \brief Whether a scene makes sense, before anything moves in it.

#include "05_resolution/mass_properties/checked_mass.hpp"
#include "06_world/contacts/start_body.hpp"
#include "06_world/game_world/invalid_scene.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>

namespace cookbook
{

/// Checks a body's shape.
struct CheckShape
{
  const SceneBody& body; ///< whose it is

  void operator()(const BoxShape& box) const
  {
    checked(Obb<double>{{0, 0, 0}, Matrix3<double>::Identity(), box.half_extents});
  }
  void operator()(const SphereShape& sphere) const
  {
    check_finite("radius", sphere.radius);
    if (!(sphere.radius > 0))
    {
      throw InvalidShape("radius", "greater than zero", text_of(sphere.radius));
    }
  }
  void operator()(const ConvexShape& shape) const
  {
    const auto [inner, outer] = extent(shape);
    check_finite("extent.outer", outer);
    if (!(inner > 0 && inner <= outer))
    {
      throw InvalidShape(
          "extent.inner", "greater than zero, and no more than " + text_of(outer), text_of(inner));
    }
  }
  void operator()(const PlaneShape& plane) const
  {
    checked(Plane<double>{plane.normal, plane.offset});
    if (body.mass != 0)
    {
      throw InvalidShape("mass", "0 for a plane", text_of(body.mass));
    }
    if (body.motion == MotionType::kinematic)
    {
      throw InvalidShape("motion", "fixed for a plane", "kinematic");
    }
  }
};

/// Throws InvalidShape unless a number is between two others.
inline void check_range(const std::string& member, double value, double least, double most)
{
  check_finite(member, value);
  if (value < least || value > most)
  {
    throw InvalidShape(member, text_of(least).append(" to ").append(text_of(most)), text_of(value));
  }
}

/// Throws InvalidShape if a fixed body has a velocity.
inline void
check_still_if_fixed(const std::string& member, const Vector3<double>& value, const SceneBody& body)
{
  if (motion_type(body) == MotionType::fixed && !value.isZero(0))
  {
    const bool told = body.motion == MotionType::fixed;
    throw InvalidShape(
        member, told ? "zero, for the body is fixed" : "zero, for mass 0 means fixed",
        "length " + text_of(value.stableNorm()));
  }
}

/// Throws InvalidShape if a quaternion is far from a rotation.
inline void check_orientation(const Quaternion<double>& orientation)
{
  const double length = orientation.norm();
  if (!(length > 0.5 && length < 2))
  {
    throw InvalidShape(
        "orientation", "of length 1, or 0.5 to 2, which is made 1", "length " + text_of(length));
  }
}

/// Throws InvalidShape unless a body may be put there.
inline void check_can_teleport(
    const SceneBody& body, const Vector3<double>& position, const Quaternion<double>& orientation)
{
  if (std::holds_alternative<PlaneShape>(body.shape))
  {
    throw InvalidShape("shape", "a box or a ball to be put elsewhere", "a plane");
  }
  check_finite("position", position);
  check_orientation(orientation);
}

/// Throws InvalidShape unless a body of a scene can be moved as it is.
inline void check(const SceneBody& body)
{
  check_finite("mass", body.mass);
  if (body.mass < 0)
  {
    throw InvalidShape("mass", "zero or more", text_of(body.mass));
  }
  std::visit(CheckShape{body}, body.shape);
  check_finite("position", body.position);
  check_finite("velocity", body.velocity);
  check_finite("angular_velocity", body.angular_velocity);
  check_still_if_fixed("velocity", body.velocity, body);
  check_still_if_fixed("angular_velocity", body.angular_velocity, body);
  check_orientation(body.orientation);
  check_range("friction", body.friction, 0, 1e6);
  check_range("restitution", body.restitution, 0, 1);
  check_range("damping", body.damping, 0, 1e6);
  check_range("angular_damping", body.angular_damping, 0, 1e6);
  if (motion_type(body) == MotionType::dynamic)
  {
    checked(mass_properties(body));
  }
}

/// The body itself, or InvalidScene, which calls a body without a name by its number.
inline const SceneBody& checked(const SceneBody& body, std::size_t number)
{
  try
  {
    check(body);
  }
  catch (const InvalidShape& wrong)
  {
    const std::string name = body.name.empty() ? "body " + std::to_string(number) : body.name;
    throw InvalidScene(std::string(name).append(": ").append(wrong.what()));
  }
  return body;
}

/// Two bodies that pass through each other, the smaller number first; InvalidScene unless they are
/// two of so many.
inline std::pair<int, int> checked_pair(std::pair<int, int> pair, std::size_t bodies)
{
  const auto [a, b] = std::minmax(pair.first, pair.second);
  if (a < 0 || a == b || static_cast<std::size_t>(b) >= bodies)
  {
    throw InvalidScene(std::string("scene: ignored must be two of ")
                           .append(std::to_string(bodies))
                           .append(" bodies, got ")
                           .append(std::to_string(pair.first))
                           .append(" and ")
                           .append(std::to_string(pair.second)));
  }
  return {a, b};
}

/// The scene itself, with the pairs that ignore each other in order; or InvalidScene.
inline Scene checked(Scene scene)
{
  try
  {
    check_finite("gravity", scene.gravity);
    check_range("step", scene.step, 1e-9, 1e3);
    check_range("duration", scene.duration, 0, 1e9);
  }
  catch (const InvalidShape& wrong)
  {
    throw InvalidScene(std::string("scene: ").append(wrong.what()));
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
  {
    checked(scene.bodies[i], i);
  }
  for (std::pair<int, int>& pair : scene.ignored)
  {
    pair = checked_pair(pair, scene.bodies.size());
  }
  std::sort(scene.ignored.begin(), scene.ignored.end());
  return scene;
}

} // namespace cookbook
