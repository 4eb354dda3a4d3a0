#pragma once

/// \file
/// \brief What a ball joint is, and where its bodies hold it.

#include "05_resolution/impulse/impulse.hpp"
#include "06_world/ball_joint/joint_inverse_mass.hpp"
#include "06_world/contacts/rigid_body.hpp"

namespace cookbook
{

// [ball_joint]
/// Holds an anchor of A and an anchor of B together.
struct BallJoint
{
  int a, b;                 ///< the two bodies by their places in the world; one may be fixed
  Vector3<double> anchor_a; ///< [m], in A's frame
  Vector3<double> anchor_b; ///< [m], in B's frame
  bool collides = false;    ///< whether the two may touch
  Vector3<double> impulse = Vector3<double>::Zero(); ///< [N s], on B in the last step, world
};

/// How a joint finds its bodies.
struct JointPose
{
  Arms<double> arms; ///< [m], world, to the middle between the anchors, so that no moment is left
  Vector3<double> error;   ///< [m], world, from A's anchor to B's
  Vector3<double> turning; ///< [m/s²], world, by which it bends, since the anchors go in circles
};

/// That of two bodies as they are.
inline JointPose joint_pose(const RigidBody& a, const RigidBody& b, const BallJoint& joint)
{
  const Vector3<double> to_a = a.orientation * joint.anchor_a;
  const Vector3<double> to_b = b.orientation * joint.anchor_b;
  const Vector3<double> error = b.motion.center + to_b - a.motion.center - to_a;
  return {
      {to_a + error / 2, to_b - error / 2},
      error,
      centripetal_acceleration(b.motion.angular_velocity, to_b) -
          centripetal_acceleration(a.motion.angular_velocity, to_a)};
}

/// The joint of two bodies, by their ids, that turn about a point [m], world, as they are now.
template <class World>
BallJoint ball_joint_at(const World& world, BodyId a, BodyId b, const Vector3<double>& point)
{
  const auto anchor = [&](const RigidBody& body) -> Vector3<double>
  { return body.orientation.conjugate() * (point - body.motion.center); };
  return {
      static_cast<int>(world.index(a)), static_cast<int>(world.index(b)), anchor(world.body(a)),
      anchor(world.body(b))};
}
// [ball_joint]

} // namespace cookbook
