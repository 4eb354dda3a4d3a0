#pragma once

/// \file
/// \brief A mouse joint: a spring that drags a point of a body to a target, with a force of its own
/// at most.

#include "06_world/constraints/joint_set.hpp"
#include "07_constraints/joint_frames/frame_rows.hpp"
#include "07_constraints/springs/spring_coefficients.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace cookbook
{

// [mouse]
/// Drags an anchor of B to a target that stands in A, such as the ground; R61.
struct MouseJoint
{
  static constexpr const char* name = "mouse joints";

  int a, b;                 ///< what the target stands in, and what is dragged
  Vector3<double> target;   ///< [m], in A's frame
  Vector3<double> anchor_b; ///< [m], in B's frame
  double max_force = 1000;  ///< [N], along each of A's axes
  double frequency = 5;     ///< [Hz], of the spring with what it drags
  double damping_ratio = 1; ///< [1]
  bool collides = true;     ///< whether the two may touch
};

/// Refuses what makes no sense, std::invalid_argument.
inline void check_joint(const MouseJoint& joint)
{
  check_finite(joint.target, "target");
  check_finite(joint.anchor_b, "anchor_b");
  spring_angle(joint.frequency, joint.damping_ratio, 1.0);
  if (!(joint.max_force >= 0 && std::isfinite(joint.max_force)))
  {
    throw std::invalid_argument(
        "joint: max_force is " + std::to_string(joint.max_force) +
        "; it must be finite and zero or more");
  }
}

/// The three rows of a mouse joint: a spring along each of A's axes.
inline void joint_rows(
    const MouseJoint& joint, const RigidBody& a, const RigidBody& b, double step, JointRows& rows)
{
  const FramePose pose = frame_pose(a, b, {joint.target}, {joint.anchor_b});
  const SpringCoefficients<double> spring =
      spring_coefficients(joint.frequency, joint.damping_ratio, step);
  for (int axis = 0; axis < 3; ++axis)
  {
    ConstraintRow row = axis_row(pose, a, axis);
    row.keeps = spring.keeps;
    row.pulls = -spring.pulls;
    row.lower = -joint.max_force;
    row.upper = joint.max_force;
    rows.add(row);
  }
}

/// Mouse joints of a world; the impulses of each are those on B along A's axes.
using MouseJoints = JointSet<MouseJoint>;

/// The mouse joint that holds a body, by its id, at a point [m], world, as it is now; `ground` is
/// what the target stands in.
template <class World>
MouseJoint mouse_at(const World& world, BodyId ground, BodyId body, const Vector3<double>& point)
{
  return {
      static_cast<int>(world.index(ground)), static_cast<int>(world.index(body)),
      anchor_at(world.body(ground), point), anchor_at(world.body(body), point)};
}
// [mouse]

} // namespace cookbook
