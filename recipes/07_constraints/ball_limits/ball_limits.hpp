#pragma once

/// \file
/// \brief A ball joint with limits, as a shoulder has: a cone for its swing, and two bounds for its
/// twist.

#include "06_world/constraints/joint_set.hpp"
#include "07_constraints/joint_frames/frame_rows.hpp"
#include "07_constraints/joint_frames/joint_drive.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace cookbook
{

// [ball_limits]
/// Holds the anchors of A and B together, and B's x axis within a cone about A's; R59. Its
/// coordinate is the twist of B against A about that axis, right-handed; beyond π it counts on.
struct ConeTwistJoint
{
  static constexpr const char* name = "cone-twist joints";

  int a, b;                       ///< the two bodies by their places in the world
  JointFrame frame_a;             ///< in A; x is the axis of the cone
  JointFrame frame_b;             ///< in B; x points along the limb
  double cone = std::numbers::pi; ///< [rad], 0 to π, between axis and limb at most
  JointDrive twist{};             ///< along the twist
  bool collides = false;          ///< whether the two may touch
  double angle = 0;               ///< [rad], twist as the last step ended
};

/// Refuses what makes no sense, std::invalid_argument.
inline void check_joint(const ConeTwistJoint& joint)
{
  check_frame(joint.frame_a, "frame_a");
  check_frame(joint.frame_b, "frame_b");
  check_drive(joint.twist, "twist");
  check_finite({joint.angle, 0, 0}, "angle");
  if (!(joint.cone >= 0 && joint.cone <= std::numbers::pi))
  {
    throw std::invalid_argument(
        "joint: cone is " + std::to_string(joint.cone) + "; it must be from 0 to pi");
  }
}

/// The row of the angle that a cone leaves to B's x axis; it turns about A's y axis where both axes
/// lie on one line.
inline ConstraintRow cone_row(const FramePose& pose, double cone)
{
  const Vector3<double> x_a = pose.a.col(0), x_b = pose.b.col(0);
  const Direction<double> across = normalize<double>(x_a.cross(x_b), pose.a.col(1));
  ConstraintRow row = angular_row(-across.unit, cone - arc_tangent(across.length, x_a.dot(x_b)));
  row.lower = 0;
  return row;
}

/// Takes down the twist when a step has ended, right while it changes by less than π in a step.
inline void follow_joint(ConeTwistJoint& joint, const RigidBody& a, const RigidBody& b)
{
  const FramePose pose = frame_pose(a, b, joint.frame_a, joint.frame_b);
  joint.angle = with_turns(twist_of(pose), joint.angle);
}

/// The rows: three of the point, one of the cone, then those of the twist.
inline void joint_rows(
    const ConeTwistJoint& joint, const RigidBody& a, const RigidBody& b, double step,
    JointRows& rows)
{
  const FramePose pose = frame_pose(a, b, joint.frame_a, joint.frame_b);
  add_point_rows(pose, a, rows);
  rows.add(cone_row(pose, joint.cone));
  const double twist = with_turns(twist_of(pose), joint.angle);
  add_drive_rows(joint.twist, twist_row(pose, twist), a, b, step, rows);
}

/// Cone-twist joints of a world; the impulses of each are those on B: three along A's axes, one of
/// the cone.
using ConeTwistJoints = JointSet<ConeTwistJoint>;

/// The cone-twist joint of two bodies, by their ids, at a point [m] with the limb along a
/// direction, both world; swing and twist are zero as they lie now. std::invalid_argument if that
/// is zero or not finite.
template <class World>
ConeTwistJoint cone_twist_at(
    const World& world, BodyId a, BodyId b, const Vector3<double>& point,
    const Vector3<double>& limb)
{
  const Quaternion<double> axes = axes_about(limb);
  return {
      static_cast<int>(world.index(a)), static_cast<int>(world.index(b)),
      frame_at(world.body(a), point, axes), frame_at(world.body(b), point, axes)};
}
// [ball_limits]

} // namespace cookbook
