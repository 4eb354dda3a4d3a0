#pragma once

/// \file
/// \brief A ball joint: a point of one body stays at a point of another, around which both turn.

#include "06_world/constraints/anchors.hpp"
#include "06_world/constraints/joint_set.hpp"

namespace cookbook
{

// [ball_joint]
/// Holds an anchor of A and an anchor of B together; R36.
struct BallJoint
{
  static constexpr const char* name = "ball joints";

  int a, b;                 ///< the two bodies by their places in the world; one may be fixed
  Vector3<double> anchor_a; ///< [m], in A's frame
  Vector3<double> anchor_b; ///< [m], in B's frame
  bool collides = false;    ///< whether the two may touch
};

/// Refuses anchors that are not finite, std::invalid_argument.
inline void check_joint(const BallJoint& joint)
{
  check_finite(joint.anchor_a, "anchor_a");
  check_finite(joint.anchor_b, "anchor_b");
}

/// The three rows of a ball joint: B's anchor from A's, along the axes of the world.
inline void
joint_rows(const BallJoint& joint, const RigidBody& a, const RigidBody& b, double, JointRows& rows)
{
  const Anchors anchors = anchors_of(a, b, joint.anchor_a, joint.anchor_b);
  for (int axis = 0; axis < 3; ++axis)
  {
    rows.add(linear_row(anchors, Vector3<double>::Unit(axis)));
  }
}

/// Ball joints of a world; the impulses of each are those on B, world.
using BallJoints = JointSet<BallJoint>;

/// The joint of two bodies, by their ids, that turn about a point [m], world, as they are now.
template <class World>
BallJoint ball_joint_at(const World& world, BodyId a, BodyId b, const Vector3<double>& point)
{
  return {
      static_cast<int>(world.index(a)), static_cast<int>(world.index(b)),
      anchor_at(world.body(a), point), anchor_at(world.body(b), point)};
}
// [ball_joint]

} // namespace cookbook
