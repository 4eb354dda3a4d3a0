#pragma once

/// \file
/// \brief A scene as plain data: bodies with shapes, gravity, the time step.

#include "06_world/shapes/shape.hpp"
#include "common/math/vector.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

class ConstraintSet;

// [scene]
/// What may change how a body moves.
enum class MotionType : std::uint8_t
{
  fixed,     ///< nothing; it stays where it is
  kinematic, ///< the game alone: it goes on with its velocity, pushes others, and nothing pushes it
  dynamic    ///< forces and contacts
};

/// What motion types are called, in their order.
inline constexpr std::array<const char*, 3> motion_names{"fixed", "kinematic", "dynamic"};

/// What a body is, and how it starts.
struct SceneBody
{
  std::string name;                        ///< by which results name it
  Shape shape;                             ///< how it collides
  double mass = 0;                         ///< [kg], of a dynamic body; without one it is fixed
  MotionType motion = MotionType::dynamic; ///< what may change how it moves, motion_type()
  Vector3<double> position = Vector3<double>::Zero();         ///< [m], world, centre of mass
  Quaternion<double> orientation{1, 0, 0, 0};                 ///< body to world; it is made unit
  Vector3<double> velocity = Vector3<double>::Zero();         ///< [m/s], world
  Vector3<double> angular_velocity = Vector3<double>::Zero(); ///< [rad/s], world
  double friction = 0.6;                                      ///< [1], of its surface
  double restitution = 0;                                     ///< [1], of its surface, 0 to 1
  double damping = 0;         ///< [1/s], damping of its velocity, zero or more
  double angular_damping = 0; ///< [1/s], damping of its angular velocity, zero or more
};

/// The motion type of a body of a scene: a dynamic one without a mass is fixed.
inline MotionType motion_type(const SceneBody& body)
{
  return body.motion == MotionType::dynamic && body.mass == 0 ? MotionType::fixed : body.motion;
}

/// Bodies and the world they are in.
struct Scene
{
  std::string name{};                         ///< such as tower_20, or of the file it was read from
  Vector3<double> gravity{0, -9.81, 0};       ///< [m/s²], world
  double step = 1.0 / 60;                     ///< [s], one frame
  double duration = 10;                       ///< [s], of a program that runs it
  std::vector<SceneBody> bodies{};            ///< results have them in this order
  std::vector<std::pair<int, int>> ignored{}; ///< bodies that pass through each other
  /// Joints and the like with which a world of it begins; their bodies are numbered as here.
  std::vector<std::shared_ptr<const ConstraintSet>> constraints{};
};

/// Whether two bodies of a scene, the smaller number first, pass through each other.
inline bool ignores(const Scene& scene, const std::pair<int, int>& pair)
{
  return std::binary_search(scene.ignored.begin(), scene.ignored.end(), pair);
}
// [scene]

/// How far apart [m] two bodies at rest may be and still be in contact: what a fall from rest
/// covers in two steps, so that a solver knows of a touch before there is an overlap.
inline double contact_margin(const Scene& scene)
{
  return 2 * scene.gravity.norm() * scene.step * scene.step;
}

} // namespace cookbook
