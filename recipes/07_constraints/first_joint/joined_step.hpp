#pragma once

/// \file
/// \brief A step of the small world with joints of any kind in it.

#include "05_resolution/small_world/small_world.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cookbook::small_world
{

// [joined_step]
/// Whether one of the joints joins two bodies.
template <class Joint>
bool are_joined(const std::vector<Joint>& joints, std::size_t a, std::size_t b)
{
  return std::any_of(
      joints.begin(), joints.end(),
      [&](const Joint& joint)
      { return std::min(joint.a, joint.b) == a && std::max(joint.a, joint.b) == b; });
}

/// The spring of a joint for a substep [s]: a quarter of the substeps' rate, critically damped.
inline Softness<double> joint_softness(double substep)
{
  return softness(0.25 / substep, 1.0, substep);
}

/// The joint that is no spring for a substep [s]: the whole error is gone after it; R42.
inline Softness<double> rigid_joint(double substep)
{
  return {1 / substep, 1, 0};
}

/// Moves a world on by a time [s], in substeps, with joints; bodies that are joined to each other
/// do not touch, and do not sleep.
///
/// A joint has the places `a` and `b` of its bodies, and is solved by
/// `prepare_joint(world, joint, substep)` and `solve_joint(world, joint, softness)`.
template <class Joint>
void step_joined(
    World& world, std::vector<Joint>& joints, double time,
    Softness<double> (*joint_softness_of)(double) = joint_softness)
{
  check("time", time, 1e-6, 0.1);
  check("gravity.norm()", world.gravity.norm(), 0, 1e4);
  for (const Joint& joint : joints)
  {
    wake(world, joint.a);
    wake(world, joint.b);
  }
  find_contacts(world);
  std::erase_if(
      world.contacts, [&](const Contact& one) { return are_joined(joints, one.a, one.b); });
  std::vector<Vector3<double>> starts;
  for (const RigidBody& body : world.bodies)
  {
    starts.push_back(body.motion.center);
  }
  const double substep = time / substeps;
  find_impacts(world, time, substep);
  const Softness<double> spring = softness(spring_rate / substep, damping_ratio, substep);
  for (int i = 0; i < substeps; ++i)
  {
    apply_gravity(world, substep);
    apply_warm_start(world);
    for (Joint& joint : joints)
    {
      prepare_joint(world, joint, substep);
    }
    for (Joint& joint : joints)
    {
      solve_joint(world, joint, joint_softness_of(substep));
    }
    solve(world, spring, substep);
    integrate_positions(world, substep);
    solve(world, rigid<double>(), substep);
  }
  apply_restitution(world);
  sweep_spheres(world, starts, time);
  put_to_sleep(world, time);
}
// [joined_step]

} // namespace cookbook::small_world
