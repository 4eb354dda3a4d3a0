#pragma once

/// \file
/// \brief A damped spring as a joint of the small world, in its substeps.

#include "07_constraints/first_joint/joined_step.hpp"
#include "07_constraints/springs/springs.hpp"

#include <cstddef>

namespace cookbook::small_world
{

// [small_spring]
/// A spring from an anchor of body A to an anchor of body B.
struct SpringJoint
{
  std::size_t a, b;         ///< the bodies' places in the world
  Vector3<double> anchor_a; ///< [m], in A's frame
  Vector3<double> anchor_b; ///< [m], in B's frame
  double rest_length;       ///< [m], zero or more
  double frequency;         ///< [Hz], 0 to 1e9
  double damping_ratio;     ///< [1], 0 to 1e9
};

/// Gives two bodies the impulse of their spring for a substep [s], after gravity; R39.
inline void prepare_joint(World& world, SpringJoint& joint, double substep)
{
  RigidBody &a = world.bodies[joint.a], &b = world.bodies[joint.b];
  const SpringEnds<double> ends{
      a.motion.center + a.orientation * joint.anchor_a,
      b.motion.center + b.orientation * joint.anchor_b};
  const auto spring = spring_coefficients(joint.frequency, joint.damping_ratio, substep);
  const double falls = (b.inverse_mass > 0 ? 1 : 0) - (a.inverse_mass > 0 ? 1 : 0);
  const double stretches = falls * world.gravity.dot(spring_pose<double>(a, b, ends).along);
  const double load = load_speed(spring, joint.frequency, substep, stretches) +
                      (1 - spring.keeps) * substep * stretches; // gravity has acted before
  apply_spring<double>(a, b, ends, joint.rest_length, spring, load);
}

/// Does nothing more: a spring is done after its one impulse.
inline void solve_joint(World&, SpringJoint&, const Softness<double>&) {}
// [small_spring]

} // namespace cookbook::small_world
