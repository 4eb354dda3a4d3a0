#pragma once

/// \file
/// \brief A body of a world: pose, motion, and how much a push changes it, in the body's own frame.

#include "02_primitives/shapes/shapes.hpp"
#include "05_resolution/impulse/body.hpp"
#include "05_resolution/restitution/restitution.hpp"
#include "06_world/contacts/scene.hpp"
#include "06_world/shapes/pose.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace cookbook
{

// [rigid_body]
/// What a body of a world is known by: its place in lists, and in the upper 32 bits how many had
/// that place before.
using BodyId = std::uint64_t;

/// A body as a world moves it: one that can be pushed, and how it is turned.
struct RigidBody : Body<double>
{
  bool is_sphere;                 ///< a sphere: where it touches does not turn with it
  std::uint32_t generation;       ///< how many had its place in the world before
  Quaternion<double> orientation; ///< unit, body to world
  Quaternion<double>
      lagged_orientation;  ///< as it was turned when a solver took its arms, lagged_axes()
  Vector3<double> moments; ///< [kg m²], along the body's axes; 0 where it is fixed
  Matrix3<double> axes;    ///< [1], the orientation as a matrix; a ball's stay the world's
};

/// The place of a body in lists.
inline std::size_t index_of_id(BodyId id)
{
  return static_cast<std::size_t>(id & 0xFFFF'FFFF);
}

/// Whose place in a list of bodies that is.
inline BodyId id_at(std::span<const RigidBody> bodies, std::size_t place)
{
  return BodyId(bodies[place].generation) << 32 | place;
}

/// Where a body is, and how it is turned.
inline Pose pose_of(const RigidBody& body)
{
  return {body.motion.center, body.axes};
}

/// True if no push moves the body.
inline bool is_fixed(const RigidBody& body)
{
  return body.inverse_mass == 0;
}

/// What pulls a body that is not fixed, in a step.
struct ExternalAcceleration
{
  Vector3<double> acceleration = Vector3<double>::Zero();         ///< [m/s²], world
  Vector3<double> angular_acceleration = Vector3<double>::Zero(); ///< [rad/s²], world
};

/// What the forces of a step do to the body at a place; nothing behind the end of their list.
inline ExternalAcceleration
force_on(std::span<const ExternalAcceleration> forces, std::size_t place)
{
  return place < forces.size() ? forces[place] : ExternalAcceleration{};
}

/// Forces last as long as this, also where a step throws.
struct ClearForces
{
  std::vector<ExternalAcceleration>& forces;

  ~ClearForces() { forces.clear(); }
};

/// What gravity [m/s²] and the forces of a step do together to the body at a place.
inline ExternalAcceleration acceleration_on(
    const Vector3<double>& gravity, std::span<const ExternalAcceleration> forces, std::size_t place)
{
  ExternalAcceleration pull = force_on(forces, place);
  pull.acceleration += gravity;
  return pull;
}

/// The fastest approach [m/s] that is a rest in a step [s], where what pulls parts two bodies at
/// this acceleration [m/s²]: by gravity, or by what presses them, if that is more.
inline double
rest_threshold(const Vector3<double>& gravity, double separating_acceleration, double step)
{
  return restitution_threshold(std::max(gravity.norm(), -separating_acceleration), step);
}

/// How a body moves once something has pulled it for a time [s], where it is.
inline Motion<double>
accelerated(const Motion<double>& motion, const ExternalAcceleration& by, double time)
{
  const auto& [center, velocity, spin] = motion;
  return {center, velocity + time * by.acceleration, spin + time * by.angular_acceleration};
}

/// Has something pull a body for a time [s].
inline void apply_forces(RigidBody& body, const ExternalAcceleration& by, double time)
{
  body.motion = accelerated(body.motion, by, time);
}

/// Takes a body's mass, so that nothing moves it any more.
inline void fix(RigidBody& body)
{
  body.motion.velocity.setZero();
  body.motion.angular_velocity.setZero();
  body.inverse_mass = 0;
  body.moments.setZero();
  body.inverse_inertia.setZero();
}

/// True if a body's pose and motion are numbers, and finite.
inline bool is_finite(const RigidBody& body)
{
  return body.motion.center.allFinite() && body.orientation.coeffs().allFinite() &&
         body.motion.velocity.allFinite() && body.motion.angular_velocity.allFinite();
}

/// Brings the matrices of a body up to date with its orientation; a ball's are the same in all.
inline void update_axes(RigidBody& body)
{
  if (body.is_sphere)
  {
    return;
  }
  body.axes = body.orientation.toRotationMatrix();
  if (!is_fixed(body))
  {
    body.inverse_inertia = world_inverse_inertia(body.moments, body.axes);
  }
}

/// The energy [J] of a body's motion; zero if it is fixed.
inline double kinetic_energy(const RigidBody& body)
{
  if (is_fixed(body))
  {
    return 0;
  }
  const Vector3<double> spin = body.axes.transpose() * body.motion.angular_velocity;
  return (body.motion.velocity.squaredNorm() / body.inverse_mass +
          spin.cwiseProduct(body.moments).dot(spin)) /
         2;
}

/// Mass and moments of a shape; a plane has none.
inline MassProperties<double> mass_properties(const SceneBody& body)
{
  if (const BoxShape* box = std::get_if<BoxShape>(&body.shape))
  {
    return solid_box<double>(body.mass, box->half_extents);
  }
  if (const SphereShape* sphere = std::get_if<SphereShape>(&body.shape))
  {
    return solid_sphere<double>(body.mass, sphere->radius);
  }
  return {0, Vector3<double>::Zero()};
}

/// A body of a scene as it starts.
inline RigidBody rigid_body(const SceneBody& body)
{
  const bool fixed = body.mass == 0, is_sphere = std::holds_alternative<SphereShape>(body.shape);
  const Matrix3<double> axes = Matrix3<double>::Identity();
  const Motion<double> motion{body.position, body.velocity, body.angular_velocity};
  const MassProperties<double> mass = mass_properties(body);
  const Body<double> pushed =
      fixed ? Body<double>{motion, 0, Matrix3<double>::Zero()} : dynamic_body(motion, mass, axes);
  const Quaternion<double> orientation = body.orientation.normalized();
  RigidBody made{pushed, is_sphere, 0, orientation, orientation, mass.moments, axes};
  update_axes(made);
  return made;
}
// [rigid_body]

} // namespace cookbook
