#pragma once

/// \file
/// \brief A body of a scene as it starts.

#include "06_world/contacts/rigid_body.hpp"
#include "06_world/shapes/box_shape.hpp"
#include "06_world/shapes/plane_shape.hpp"
#include "06_world/shapes/sphere_shape.hpp"

#include <variant>

namespace cookbook
{

// [start_body]
/// Mass and moments of a body; a plane has none.
inline MassProperties<double> mass_properties(const SceneBody& body)
{
  return std::visit(
      [&](const auto& shape) { return mass_properties(shape, body.mass); }, body.shape);
}

/// A body of a scene as it starts.
inline RigidBody rigid_body(const SceneBody& body)
{
  const MotionType type = motion_type(body);
  const bool dynamic = type == MotionType::dynamic;
  const bool is_sphere = std::holds_alternative<SphereShape>(body.shape);
  const Matrix3<double> axes = Matrix3<double>::Identity();
  const Motion<double> motion{body.position, body.velocity, body.angular_velocity};
  const MassProperties<double> mass =
      dynamic ? mass_properties(body) : MassProperties<double>{0, Vector3<double>::Zero()};
  const Body<double> pushed =
      dynamic ? dynamic_body(motion, mass, axes) : Body<double>{motion, 0, Matrix3<double>::Zero()};
  const Quaternion<double> orientation = body.orientation.normalized();
  RigidBody made{pushed, is_sphere, type, 0, orientation, orientation, mass.moments, axes};
  update_axes(made);
  return made;
}
// [start_body]

} // namespace cookbook
