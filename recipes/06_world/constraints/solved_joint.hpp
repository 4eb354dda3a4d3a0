#pragma once

/// \file
/// \brief What a set knows of one of its joints: rows, impulses, and whether it has broken.

#include "06_world/constraints/joint_rows.hpp"
#include "06_world/contacts/integrate_body.hpp"

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace cookbook
{

// [solved_joint]
/// A joint as its set solves it.
template <JointKind Kind>
struct SolvedJoint
{
  Kind of;
  JointRows rows{};                  ///< as the bodies were
  JointImpulses impulses{};          ///< [N s, N m s]
  Eigen::LDLT<RigidMatrix> factor{}; ///< of the rigid rows' K
  double substep = 0;                ///< [s]
  double elapsed = 0;                ///< [s], since the step began
  JointImpulses sum{};               ///< [N s, N m s], since the step of the world began
  double strength = std::numeric_limits<double>::infinity(); ///< [N]
  Vector3<double> force{0, 0, 0}; ///< [N], on B, the mean of the last step, if it has a strength
  bool broken = false;            ///< by such a force
  bool changed = false;           ///< by the game, since the last step of the world
};

/// Refuses a strength [N] that is none, std::invalid_argument.
inline void check_strength(double strength)
{
  if (!(strength >= 0))
  {
    throw std::invalid_argument(
        "joint: strength is " + std::to_string(strength) + "; it must be zero or more");
  }
}

/// A body as it is, or, if a game drives it, as it is after a time [s]: the world moves that only
/// when the step ends.
inline RigidBody driven_along(RigidBody body, double time)
{
  if (is_driven(body))
  {
    body.motion.center += time * body.motion.velocity;
    body.orientation = turned_by(body, time * body.motion.angular_velocity);
    update_axes(body);
  }
  return body;
}

/// Takes the bodies as they are before a substep [s].
template <JointKind Kind>
void take_rows(SolvedJoint<Kind>& one, const RigidBody& a, const RigidBody& b, double substep)
{
  one.substep = substep;
  one.rows.clear();
  joint_rows(one.of, driven_along(a, one.elapsed), driven_along(b, one.elapsed), substep, one.rows);
  one.factor.compute(rigid_inverse_mass(one.rows, a, b));
}

/// Turns impulses of a step into those of a substep, or back.
template <JointKind Kind>
void scale_impulses(SolvedJoint<Kind>& one, double by)
{
  for (double& impulse : one.impulses)
  {
    impulse *= by;
  }
}

/// Adds impulses to those of the step.
template <JointKind Kind>
void add_impulses(SolvedJoint<Kind>& one, const JointImpulses& impulses)
{
  for (std::size_t i = 0; i < impulses.size(); ++i)
  {
    one.sum[i] += impulses[i];
  }
}

/// Adds those of a substep that ends, if there was one.
template <JointKind Kind>
void add_substep(SolvedJoint<Kind>& one)
{
  if (one.elapsed > 0)
  {
    add_impulses(one, one.impulses);
  }
}

/// Ends a step of the world [s]: a kind that counts turns has a function for it; R62.
template <JointKind Kind>
void end_step(SolvedJoint<Kind>& one, const RigidBody& a, const RigidBody& b, double step)
{
  if constexpr (requires { follow_joint(one.of, a, b); })
  {
    follow_joint(one.of, a, b);
  }
  if (one.strength < std::numeric_limits<double>::infinity())
  {
    JointRows rows;
    joint_rows(one.of, a, b, step, rows);
    one.force.setZero();
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      one.force += one.sum[i] / step * rows[i].b.template head<3>();
    }
    one.broken = one.broken || one.force.norm() > one.strength;
  }
  one.sum.fill(0);
  one.changed = false;
}
// [solved_joint]

} // namespace cookbook
