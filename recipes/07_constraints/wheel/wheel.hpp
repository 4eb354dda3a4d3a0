#pragma once

/// \file
/// \brief A wheel on a car: a suspension along one axis, free spin about another, steered.

#include "06_world/constraints/joint_set.hpp"
#include "07_constraints/joint_frames/frame_rows.hpp"
#include "07_constraints/joint_frames/joint_drive.hpp"

namespace cookbook
{

// [wheel]
/// Holds B, the wheel, on the y axis of A's frame, and its axle, the x axis of its frame, on A's x
/// axis as steered about y; R60.
struct WheelJoint
{
  static constexpr const char* name = "wheels";

  int a, b;                ///< car and wheel by their places in the world
  JointFrame frame_a;      ///< in A; x is the axle, y goes up along the suspension
  JointFrame frame_b;      ///< in B; x is the axle
  JointDrive suspension{}; ///< along y; above zero where it is pressed together
  JointDrive spin{};       ///< about the axle, such as an engine or a brake
  double steering = 0;     ///< [rad], of the axle about y, right-handed
  bool collides = false;   ///< whether the two may touch
  double angle = 0;        ///< [rad], of the spin, as the last step ended
};

/// Refuses what makes no sense, std::invalid_argument.
inline void check_joint(const WheelJoint& joint)
{
  check_frame(joint.frame_a, "frame_a");
  check_frame(joint.frame_b, "frame_b");
  check_drive(joint.suspension, "suspension");
  check_drive(joint.spin, "spin");
  check_finite({joint.steering, joint.angle, 0}, "steering or angle");
}

/// How the frames lie with A's turned as the wheel is steered.
inline FramePose steered_pose(const WheelJoint& joint, const RigidBody& a, const RigidBody& b)
{
  const SineCosine<double> half = sine_cosine(joint.steering / 2);
  const Quaternion<double> turn(half.cosine, 0, half.sine, 0);
  return frame_pose(a, b, {joint.frame_a.anchor, joint.frame_a.axes * turn}, joint.frame_b);
}

/// Takes down the spin when a step has ended.
inline void follow_joint(WheelJoint& joint, const RigidBody& a, const RigidBody& b)
{
  joint.angle = with_turns(twist_of(steered_pose(joint, a, b)), joint.angle);
}

/// The rows of a wheel: two across the suspension, two of the axle, then those of both drives.
inline void joint_rows(
    const WheelJoint& joint, const RigidBody& a, const RigidBody& b, double step, JointRows& rows)
{
  const FramePose pose = parting_along(steered_pose(joint, a, b), 1);
  rows.add(axis_row(pose, a, 0));
  rows.add(axis_row(pose, a, 2));
  add_swing_rows(pose, rows);
  add_drive_rows(joint.suspension, axis_row(pose, a, 1), a, b, step, rows);
  const double angle = with_turns(twist_of(pose), joint.angle);
  add_drive_rows(joint.spin, twist_row(pose, angle), a, b, step, rows);
}

/// Wheels of a world; the impulses of each are those on B: two along A's x and z, two about the
/// axes across the axle, then of the suspension and of the spin.
using WheelJoints = JointSet<WheelJoint>;

/// The wheel of a car, by their ids, at the wheel's centre, with an axle and the way up of the
/// suspension, world; its spring is at rest as they lie now. std::invalid_argument if either is
/// zero or not finite, or both lie along one line.
template <class World>
WheelJoint wheel_at(
    const World& world, BodyId car, BodyId wheel, const Vector3<double>& axle,
    const Vector3<double>& up)
{
  const Quaternion<double> axes = axes_about(axle, up);
  const Vector3<double>& center = world.body(wheel).motion.center;
  return {
      static_cast<int>(world.index(car)), static_cast<int>(world.index(wheel)),
      frame_at(world.body(car), center, axes), frame_at(world.body(wheel), center, axes)};
}
// [wheel]

} // namespace cookbook
