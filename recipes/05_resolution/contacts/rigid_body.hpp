#pragma once

/// \file
/// \brief A body of a world: pose, motion, and how much a push changes it, in the body's own frame.

#include "02_primitives/shapes/shapes.hpp"
#include "05_resolution/contacts/scene.hpp"
#include "05_resolution/impulse/body.hpp"

#include <cmath>
#include <variant>

namespace cookbook
{

// [rigid_body]
/// A body as a world moves it.
struct RigidBody
{
  Vector3<double> position;         ///< [m], world, centre of mass
  Quaternion<double> orientation;   ///< unit, body to world
  Vector3<double> velocity;         ///< [m/s], world
  Vector3<double> angular_velocity; ///< [rad/s], world
  double inverse_mass;              ///< [1/kg]; 0: fixed
  Vector3<double> moments;          ///< [kg m²], along the body's axes; 0 where it is fixed
  Matrix3<double> axes;             ///< [1], the orientation as a matrix; a ball's stay the world's
  Matrix3<double> inverse_inertia;  ///< [1/(kg m²)], world
  bool round;                       ///< a ball: where it touches does not turn with it
};

/// True if no push moves the body.
inline bool is_fixed(const RigidBody& body)
{
  return body.inverse_mass == 0;
}

/// Takes a body's mass, so that nothing moves it any more.
inline void fix(RigidBody& body)
{
  body.velocity.setZero();
  body.angular_velocity.setZero();
  body.inverse_mass = 0;
  body.moments.setZero();
  body.inverse_inertia.setZero();
}

/// True if a body's pose and motion are numbers, and finite.
inline bool is_finite(const RigidBody& body)
{
  return body.position.allFinite() && body.orientation.coeffs().allFinite() &&
         body.velocity.allFinite() && body.angular_velocity.allFinite();
}

/// Brings the matrices of a body up to date with its orientation; a ball's are the same in all.
inline void update_axes(RigidBody& body)
{
  if (body.round)
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
  const Vector3<double> spin = body.axes.transpose() * body.angular_velocity;
  return (body.velocity.squaredNorm() / body.inverse_mass +
          spin.cwiseProduct(body.moments).dot(spin)) /
         2;
}

/// Moves a body with its velocities for a time [s].
inline void move(RigidBody& body, double time)
{
  body.position += time * body.velocity;
  const Vector3<double> half_turn = (time / 2) * body.angular_velocity;
  const double angle = half_turn.norm();
  const double sine_by_angle = angle > 1e-4 ? std::sin(angle) / angle : 1 - angle * angle / 6;
  const Vector3<double> axis = half_turn * sine_by_angle;
  const Quaternion<double> turn(std::cos(angle), axis.x(), axis.y(), axis.z());
  body.orientation = (turn * body.orientation).normalized();
  update_axes(body);
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
  const bool fixed = body.mass == 0;
  const Vector3<double> moments = fixed ? Vector3<double>(0, 0, 0) : mass_properties(body).moments;
  RigidBody made{
      body.position,
      body.orientation.normalized(),
      body.velocity,
      body.angular_velocity,
      fixed ? 0 : inverse_of(body.mass),
      moments,
      Matrix3<double>::Identity(),
      fixed ? Matrix3<double>(Matrix3<double>::Zero())
            : world_inverse_inertia<double>(moments, Matrix3<double>::Identity()),
      std::holds_alternative<SphereShape>(body.shape)};
  update_axes(made);
  return made;
}
// [rigid_body]

} // namespace cookbook
