#pragma once

/// \file
/// \brief A hinge: two bodies that turn against each other about one axis, with limits, motor and
/// spring.

#include "06_world/constraints/joint_set.hpp"
#include "07_constraints/joint_frames/frame_rows.hpp"
#include "07_constraints/joint_frames/joint_drive.hpp"

namespace cookbook
{

// [hinge]
/// Holds the anchors of A and B together, and B's x axis on A's; R56. Its coordinate is the angle
/// of B against A about that axis, right-handed; beyond π it counts on.
struct HingeJoint
{
  static constexpr const char* name = "hinges";

  int a, b;              ///< the two bodies by their places in the world; one may be fixed
  JointFrame frame_a;    ///< in A; x is the axis
  JointFrame frame_b;    ///< in B; the angle is zero where the frames lie alike
  JointDrive drive{};    ///< along the angle
  bool collides = false; ///< whether the two may touch
  double angle = 0;      ///< [rad], as the last step ended, by which turns are counted
};

/// Refuses what makes no sense, std::invalid_argument.
inline void check_joint(const HingeJoint& joint)
{
  check_frame(joint.frame_a, "frame_a");
  check_frame(joint.frame_b, "frame_b");
  check_drive(joint.drive, "drive");
  check_finite({joint.angle, 0, 0}, "angle");
}

/// The angle [rad] of a hinge, with its turns: the nearest to that of the last step.
inline double hinge_angle(const HingeJoint& joint, const FramePose& pose)
{
  return with_turns(twist_of(pose), joint.angle);
}

/// Takes down the angle when a step has ended, right while it changes by less than π in a step.
inline void follow_joint(HingeJoint& joint, const RigidBody& a, const RigidBody& b)
{
  joint.angle = hinge_angle(joint, frame_pose(a, b, joint.frame_a, joint.frame_b));
}

/// The rows of a hinge: three of the point, two of the swing, then those of its drive.
inline void joint_rows(
    const HingeJoint& joint, const RigidBody& a, const RigidBody& b, double step, JointRows& rows)
{
  const FramePose pose = frame_pose(a, b, joint.frame_a, joint.frame_b);
  add_point_rows(pose, a, rows);
  add_swing_rows(pose, rows);
  add_drive_rows(joint.drive, twist_row(pose, hinge_angle(joint, pose)), a, b, step, rows);
}

/// Hinges of a world; the impulses of each are those on B: three along A's axes, two about them.
using HingeJoints = JointSet<HingeJoint>;

/// The hinge of two bodies, by their ids, at a point [m] and about an axis, both world; its angle
/// is zero as they lie now. std::invalid_argument if the axis is zero or not finite.
template <class World>
HingeJoint hinge_at(
    const World& world, BodyId a, BodyId b, const Vector3<double>& point,
    const Vector3<double>& axis)
{
  const Quaternion<double> axes = axes_about(axis);
  return {
      static_cast<int>(world.index(a)), static_cast<int>(world.index(b)),
      frame_at(world.body(a), point, axes), frame_at(world.body(b), point, axes)};
}
// [hinge]

} // namespace cookbook
