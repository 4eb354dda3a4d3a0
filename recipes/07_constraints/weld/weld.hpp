#pragma once

/// \file
/// \brief A weld: two bodies that keep their places to each other.

#include "06_world/constraints/joint_set.hpp"
#include "07_constraints/joint_frames/frame_rows.hpp"

namespace cookbook
{

// [weld]
/// Holds a frame of B on a frame of A; R55.
struct WeldJoint
{
  static constexpr const char* name = "welds";

  int a, b;              ///< the two bodies by their places in the world; one may be fixed
  JointFrame frame_a;    ///< in A
  JointFrame frame_b;    ///< in B
  bool collides = false; ///< whether the two may touch
};

/// Refuses frames that are none, std::invalid_argument.
inline void check_joint(const WeldJoint& joint)
{
  check_frame(joint.frame_a, "frame_a");
  check_frame(joint.frame_b, "frame_b");
}

/// The six rows of a weld: B's anchor along A's axes, and the rotation vector along them.
inline void
joint_rows(const WeldJoint& joint, const RigidBody& a, const RigidBody& b, double, JointRows& rows)
{
  const FramePose pose = frame_pose(a, b, joint.frame_a, joint.frame_b);
  add_point_rows(pose, a, rows);
  add_turn_rows(pose, rows);
}

/// Welds of a world; the impulses of each are those on B along A's axes: three forces, three
/// torques.
using WeldJoints = JointSet<WeldJoint>;

/// The weld of two bodies, by their ids, as they lie now, at a point [m], world.
template <class World>
WeldJoint weld_at(const World& world, BodyId a, BodyId b, const Vector3<double>& point)
{
  return {
      static_cast<int>(world.index(a)), static_cast<int>(world.index(b)),
      frame_at(world.body(a), point, {1, 0, 0, 0}), frame_at(world.body(b), point, {1, 0, 0, 0})};
}
// [weld]

} // namespace cookbook
