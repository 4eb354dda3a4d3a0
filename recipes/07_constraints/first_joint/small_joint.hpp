#pragma once

/// \file
/// \brief A ball joint in the small world: anchors of two bodies that stay together.

#include "05_resolution/small_world/small_world.hpp"
#include "06_world/ball_joint/joint_inverse_mass.hpp"
#include "07_constraints/first_joint/joined_step.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>

namespace cookbook::small_world
{

// [small_joint]
/// Holds an anchor of body A and an anchor of body B together.
struct BallJoint
{
  std::size_t a, b;         ///< the bodies' places in the world
  Vector3<double> anchor_a; ///< [m], in A's frame
  Vector3<double> anchor_b; ///< [m], in B's frame

  Vector3<double> impulse = Vector3<double>::Zero(); ///< [N s], on B in the last substep, world
  Arms<double> arms{};                               ///< [m], world
  Vector3<double> error = Vector3<double>::Zero();   ///< [m], from A's anchor to B's, world
  Vector3<double> turning = Vector3<double>::Zero(); ///< [m/s], what turning adds to it
  Matrix3<double> mass = Matrix3<double>::Zero();    ///< [kg], 1/K
};

/// The joint of two bodies that turn about a point [m], world, as they are now; refuses bodies that
/// are not there, or of which none can move.
inline BallJoint
ball_joint_at(const World& world, std::size_t a, std::size_t b, const Vector3<double>& point)
{
  const RigidBody &one = world.bodies.at(a), &other = world.bodies.at(b);
  if (one.inverse_mass + other.inverse_mass == 0 || a == b)
  {
    throw std::invalid_argument(
        "a joint of bodies " + std::to_string(a) + " and " + std::to_string(b) +
        ": one of two has to move");
  }
  const auto anchor = [&](const RigidBody& body) -> Vector3<double>
  { return body.orientation.conjugate() * (point - body.motion.center); };
  return {a, b, anchor(one), anchor(other)};
}

/// Takes the bodies as they are before a substep [s], and applies the impulse of the last one; R36.
inline void prepare_joint(World& world, BallJoint& joint, double substep)
{
  RigidBody &a = world.bodies[joint.a], &b = world.bodies[joint.b];
  const Vector3<double> to_a = a.orientation * joint.anchor_a;
  const Vector3<double> to_b = b.orientation * joint.anchor_b;
  const Vector3<double>&w_a = a.motion.angular_velocity, &w_b = b.motion.angular_velocity;
  joint.error = b.motion.center + to_b - a.motion.center - to_a;
  joint.turning = substep / 2 * (w_b.cross(w_b.cross(to_b)) - w_a.cross(w_a.cross(to_a)));
  joint.arms = {to_a + joint.error / 2, to_b - joint.error / 2};
  joint.mass = joint_inverse_mass(a, b, joint.arms).inverse();
  apply_impulse<double>(a, b, joint.arms, joint.impulse);
}

/// Holds the anchors together by a damped spring, or rigidly, as the softness says; R13, R36.
inline void solve_joint(World& world, BallJoint& joint, const Softness<double>& softness)
{
  RigidBody &a = world.bodies[joint.a], &b = world.bodies[joint.b];
  const Vector3<double> bias = softness.bias_rate * joint.error + joint.turning;
  const Vector3<double> velocity = relative_velocity(a.motion, b.motion, joint.arms);
  const Vector3<double> change = -softness.mass_scale * (joint.mass * (velocity + bias)) -
                                 softness.impulse_scale * joint.impulse;
  joint.impulse += change;
  apply_impulse<double>(a, b, joint.arms, change);
}
// [small_joint]

} // namespace cookbook::small_world
