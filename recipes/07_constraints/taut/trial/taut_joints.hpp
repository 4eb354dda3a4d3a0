#pragma once

/// \file
/// \brief Joints for scenes on trial, of a kind by its type.

#include "06_world/ball_joint/ball_joint.hpp"
#include "06_world/game_world/solvers.hpp"
#include "07_constraints/hinge/hinge.hpp"
#include "07_constraints/weld/weld.hpp"

#include <concepts>

namespace cookbook
{

// [trial_joints]
/// The joint of a kind between two bodies, by their ids, at a point [m], world; a hinge turns about
/// z.
template <class Kind>
Kind trial_joint(const GameWorld& world, BodyId a, BodyId b, const Vector3<double>& point)
{
  if constexpr (std::same_as<Kind, HingeJoint>)
  {
    return hinge_at(world, a, b, point, {0, 0, 1});
  }
  else if constexpr (std::same_as<Kind, WeldJoint>)
  {
    return weld_at(world, a, b, point);
  }
  else
  {
    return ball_joint_at(world, a, b, point);
  }
}
// [trial_joints]

} // namespace cookbook
