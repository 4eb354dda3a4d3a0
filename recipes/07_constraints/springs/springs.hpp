#pragma once

/// \file
/// \brief A damped spring between two points of two bodies, as an impulse before each step.

#include "05_resolution/impulse/contact_impulse.hpp"
#include "07_constraints/springs/spring_coefficients.hpp"
#include "common/math/norm.hpp"

#include <cmath>
#include <numbers>

namespace cookbook
{

// [spring_numbers]
/// A spring as a designer asks for it.
template <class Real>
struct SpringNumbers
{
  Real frequency;     ///< [Hz], of the undamped spring
  Real damping_ratio; ///< [1], 0 swings for ever, 1 comes back as fast as it can without swinging
};

/// The same of a stiffness k [N/m], a damping c [N s/m] and a mass [kg], all above zero but c; R37.
template <class Real>
SpringNumbers<Real> spring_numbers(const Real& stiffness, const Real& damping, const Real& mass)
{
  using std::sqrt;
  const Real w = sqrt(stiffness / mass);
  return {w / (Real(2) * std::numbers::pi_v<Real>), damping / (Real(2) * mass * w)};
}
// [spring_numbers]

// [apply_spring]
/// The two ends of a spring [m], world.
template <class Real>
struct SpringEnds
{
  Vector3<Real> a; ///< on A
  Vector3<Real> b; ///< on B
};

/// What a spring between two bodies finds.
template <class Real>
struct SpringPose
{
  Vector3<Real> along; ///< [1], unit, from A's end to B's; +y where they are at one point
  Arms<Real> arms;     ///< [m], world, from the centres to the ends
  Real length;         ///< [m]
  Real speed;          ///< [m/s], at which it gets longer
  Real mass;           ///< [kg], effective mass; zero where nothing can move
};

/// That of two bodies as they are.
template <class Real>
SpringPose<Real> spring_pose(const Body<Real>& a, const Body<Real>& b, const SpringEnds<Real>& ends)
{
  const Direction<Real> line = normalize<Real>(ends.b - ends.a);
  const Arms<Real> arms{ends.a - a.motion.center, ends.b - b.motion.center};
  const Real mass = effective_mass(inverse_mass_at(a, b, line.unit, arms));
  const Real speed = separating_velocity(a, b, line.unit, arms);
  return {line.unit, arms, line.length, speed, mass};
}

/// Gives two bodies the impulse of a spring of a rest length [m] for the step that follows; R39.
///
/// `load` [m/s] is what load_speed() gives where a steady force stretches it. Returns the impulse
/// [N s] on B along the spring, which is negative where it pulls.
template <class Real>
Real apply_spring(
    Body<Real>& a, Body<Real>& b, const SpringEnds<Real>& ends, const Real& rest_length,
    const SpringCoefficients<Real>& spring, const Real& load = Real(0))
{
  const SpringPose<Real> pose = spring_pose(a, b, ends);
  const Real stretch = pose.length - rest_length;
  const Real impulse = spring_impulse(spring, pose.mass, stretch, pose.speed) + pose.mass * load;
  apply_impulse<Real>(a, b, pose.arms, impulse * pose.along);
  return impulse;
}
// [apply_spring]

// [load_speed]
/// What a spring adds [m/s] to its speed before a steady force does so in the step, which stretches
/// it with an acceleration [m/s²]: with it, the stretch at rest is acceleration/ω², at any step
/// [s].
template <class Real>
Real load_speed(
    const SpringCoefficients<Real>& spring, const Real& frequency, const Real& step,
    const Real& acceleration)
{
  const Real w = Real(2) * std::numbers::pi_v<Real> * frequency;
  const Real felt = frequency == Real(0) ? Real(1) : Real(-spring.pulls / (w * w * step));
  return (felt - Real(1)) * step * acceleration;
}
// [load_speed]

} // namespace cookbook
