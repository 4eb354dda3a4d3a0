#pragma once

/// \file
/// \brief A slider: a body that moves along a line of another and does not turn, with limits, motor
/// and spring.

#include "06_world/constraints/joint_set.hpp"
#include "07_constraints/joint_frames/frame_rows.hpp"
#include "07_constraints/joint_frames/joint_drive.hpp"

namespace cookbook
{

// [slider]
/// Holds B's anchor on the x axis of A's frame, and B's axes on A's; R54, R55. Its coordinate is
/// how far B's anchor is along that axis.
struct SliderJoint
{
  static constexpr const char* name = "sliders";

  int a, b;              ///< the two bodies by their places in the world; one may be fixed
  JointFrame frame_a;    ///< in A; x is the line
  JointFrame frame_b;    ///< in B
  JointDrive drive{};    ///< along the line
  bool collides = false; ///< whether the two may touch
};

/// Refuses what makes no sense, std::invalid_argument.
inline void check_joint(const SliderJoint& joint)
{
  check_frame(joint.frame_a, "frame_a");
  check_frame(joint.frame_b, "frame_b");
  check_drive(joint.drive, "drive");
}

/// How far [m] B's anchor is from A's along the line.
inline double slider_position(const SliderJoint& joint, const RigidBody& a, const RigidBody& b)
{
  return axis_row(frame_pose(a, b, joint.frame_a, joint.frame_b), a, 0).error;
}

/// The rows of a slider: two across the line, three against turns, then those of its drive.
inline void joint_rows(
    const SliderJoint& joint, const RigidBody& a, const RigidBody& b, double step, JointRows& rows)
{
  const FramePose pose = parting_along(frame_pose(a, b, joint.frame_a, joint.frame_b), 0);
  rows.add(axis_row(pose, a, 1));
  rows.add(axis_row(pose, a, 2));
  add_turn_rows(pose, rows);
  add_drive_rows(joint.drive, axis_row(pose, a, 0), a, b, step, rows);
}

/// Sliders of a world; the impulses of each are those on B: two along A's y and z, three about its
/// axes.
using SliderJoints = JointSet<SliderJoint>;

/// The slider of two bodies, by their ids, at a point [m] and along an axis, both world; its
/// coordinate is zero as they lie now. std::invalid_argument if the axis is zero or not finite.
template <class World>
SliderJoint slider_at(
    const World& world, BodyId a, BodyId b, const Vector3<double>& point,
    const Vector3<double>& axis)
{
  const Quaternion<double> axes = axes_about(axis);
  return {
      static_cast<int>(world.index(a)), static_cast<int>(world.index(b)),
      frame_at(world.body(a), point, axes), frame_at(world.body(b), point, axes)};
}
// [slider]

} // namespace cookbook
