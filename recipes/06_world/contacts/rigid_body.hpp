#pragma once

/// \file
/// \brief A body of a world: pose, motion, and how much a push changes it, in the body's own frame.

#include "02_primitives/shapes/shapes.hpp"
#include "05_resolution/impulse/body.hpp"
#include "06_world/body/external_acceleration.hpp"
#include "06_world/contacts/scene.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
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
  MotionType motion_type;         ///< fixed from the start or later, kinematic, or dynamic
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

/// True if no push moves the body: it is fixed or kinematic.
inline bool is_fixed(const RigidBody& body)
{
  return body.inverse_mass == 0;
}

/// True if no push moves the body, but a game does.
inline bool is_driven(const RigidBody& body)
{
  return body.motion_type == MotionType::kinematic &&
         !(body.motion.velocity.isZero(0) && body.motion.angular_velocity.isZero(0));
}

/// True if a body is where it is for a whole step, whatever happens.
inline bool stays(const RigidBody& body)
{
  return is_fixed(body) && !is_driven(body);
}

/// Whether two bodies of a scene, the smaller number first, pass through each other: they ignore
/// each other, or no push moves either.
inline bool
never_touch(const Scene& scene, std::span<const RigidBody> bodies, const std::pair<int, int>& pair)
{
  const auto fixed = [&](int i) { return is_fixed(bodies[static_cast<std::size_t>(i)]); };
  return ignores(scene, pair) || (fixed(pair.first) && fixed(pair.second));
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
  body.motion_type = MotionType::fixed;
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
// [rigid_body]

} // namespace cookbook
