#pragma once

/// \file
/// \brief A ragdoll: ten limbs on ball joints with limits and on hinges.

#include "06_world/scenes/trial/scene_bodies.hpp"
#include "07_constraints/ball_limits/ball_limits.hpp"
#include "07_constraints/hinge/hinge.hpp"

#include <string>
#include <vector>

namespace cookbook
{

// [ragdoll]
/// Limbs of a ragdoll of 73 kg, upright above a point [m], in the order of its joints.
inline std::vector<SceneBody> ragdoll_limbs(const Vector3<double>& feet)
{
  std::vector<SceneBody> limbs{
      box_body("torso", {0.18, 0.3, 0.11}, {0, 1.25, 0}, 32),
      ball_body("head", 0.13, {0, 1.72, 0}, 5)};
  for (const double side : {-1.0, 1.0})
  {
    limbs.push_back(box_body("upper arm", {0.05, 0.15, 0.05}, {0.27 * side, 1.35, 0}, 2.5));
    limbs.push_back(box_body("forearm", {0.045, 0.15, 0.045}, {0.27 * side, 1.05, 0}, 2));
    limbs.push_back(box_body("thigh", {0.08, 0.2, 0.08}, {0.1 * side, 0.74, 0}, 8));
    limbs.push_back(box_body("shin", {0.06, 0.2, 0.06}, {0.1 * side, 0.33, 0}, 5.5));
  }
  for (SceneBody& limb : limbs)
  {
    limb.position += feet;
  }
  return limbs;
}

/// Its joints: neck, shoulders and hips with a cone and a twist, elbows and knees by one angle.
struct RagdollJoints
{
  ConeTwistJoints cones;
  HingeJoints hinges;
};

/// Those of the limbs that follow each other from a torso on, as they are now.
inline RagdollJoints ragdoll_joints(const GameWorld& world, BodyId torso)
{
  RagdollJoints joints;
  const Vector3<double> feet = world.body(torso).motion.center - Vector3<double>(0, 1.25, 0);
  const auto cone = [&](BodyId limb, const Vector3<double>& at, double along, double most)
  {
    ConeTwistJoint joint = cone_twist_at(world, torso, limb, feet + at, {0, along, 0});
    joint.cone = most;
    joint.twist = {.lower = -0.6, .upper = 0.6, .damping = 0.5};
    joints.cones.add(joint);
  };
  const auto hinge = [&](BodyId above, const Vector3<double>& at, double axis)
  {
    HingeJoint joint = hinge_at(world, above, above + 1, feet + at, {axis, 0, 0});
    joint.drive = {.lower = 0, .upper = 2.4, .damping = 0.5};
    joints.hinges.add(joint);
  };
  cone(torso + 1, {0, 1.57, 0}, 1, 0.5);
  for (const int side : {0, 1})
  {
    const BodyId arm = torso + 2 + 4 * static_cast<BodyId>(side), thigh = arm + 2;
    const double out = 2.0 * side - 1;
    cone(arm, {0.25 * out, 1.48, 0}, -1, 1.6);
    hinge(arm, {0.27 * out, 1.2, 0}, -1); // forearms bend forwards
    cone(thigh, {0.1 * out, 0.94, 0}, -1, 1.1);
    hinge(thigh, {0.1 * out, 0.535, 0}, 1); // shins backwards
  }
  return joints;
}
// [ragdoll]

} // namespace cookbook
