#pragma once

/// \file
/// \brief A weld and a hinge for scenes on trial: the rows of a ball joint, and some about axes.

#include "06_world/ball_joint/ball_joint.hpp"
#include "06_world/game_world/solvers.hpp"

namespace cookbook
{

// [trial_joints]
/// Holds B to A as they were; both were turned alike.
struct TrialWeld : BallJoint
{
  static constexpr const char* name = "trial welds";
};

/// A hinge about the z axes of A and B.
struct TrialHinge : BallJoint
{
  static constexpr const char* name = "trial hinges";
};

/// The six rows of a weld: about the axes of the world B is turned against A by small angles.
inline void
joint_rows(const TrialWeld& weld, const RigidBody& a, const RigidBody& b, double h, JointRows& rows)
{
  joint_rows(static_cast<const BallJoint&>(weld), a, b, h, rows);
  const Quaternion<double> turn = b.orientation * a.orientation.conjugate();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double angle = 2 * turn.vec()[axis] * (turn.w() < 0 ? -1 : 1);
    rows.add(angular_row(Vector3<double>::Unit(axis), angle));
  }
}

/// The five rows of a hinge: those of a ball joint, and two that keep the axes along each other.
inline void joint_rows(
    const TrialHinge& hinge, const RigidBody& a, const RigidBody& b, double h, JointRows& rows)
{
  joint_rows(static_cast<const BallJoint&>(hinge), a, b, h, rows);
  const Vector3<double> apart = a.axes.col(2).cross(b.axes.col(2));
  rows.add(angular_row(a.axes.col(0), apart.dot(a.axes.col(0))));
  rows.add(angular_row(a.axes.col(1), apart.dot(a.axes.col(1))));
}

/// The joint of a kind between two bodies at a point [m], world.
template <class Kind>
Kind trial_joint(const GameWorld& world, BodyId a, BodyId b, const Vector3<double>& point)
{
  return {ball_joint_at(world, a, b, point)};
}
// [trial_joints]

} // namespace cookbook
