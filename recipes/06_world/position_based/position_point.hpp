#pragma once

/// \file
/// \brief What corrected positions do at one contact point: they take back an overlap and a slip.

#include "06_world/islands/position_impulse.hpp"

#include <algorithm>

namespace cookbook
{

// [xpbd_change]
/// What a correction adds [kg m] to its sum so far, for a constraint that is off by `error` [m];
/// R15.
///
/// `inverse_mass` [1/kg] is the constraint's, `compliance` [1/kg] the material's over the square of
/// the small step: α̃. Zero where nothing can move.
template <class Real>
Real xpbd_change(
    const Real& error, const Real& inverse_mass, const Real& compliance, const Real& accumulated)
{
  const Real felt = inverse_mass + compliance;
  return felt == Real(0) ? Real(0) : Real((-error - compliance * accumulated) / felt);
}
// [xpbd_change]

// [position_point]
/// A contact point during a small step.
///
/// What touches and what sticks are two things on a ball: it rolls away over the place where it
/// touched.
struct PositionPoint
{
  IslandPoint point;
  Vector3<double> stored_slip; ///< [m], slip that friction has still to take back
  Vector3<double> anchor_a =
      Vector3<double>::Zero(); ///< [m], in A's own frame: what met as the step began
  Vector3<double> anchor_b = Vector3<double>::Zero(); ///< [m], the same in B's
  Vector3<double> stick_offset =
      Vector3<double>::Zero();  ///< [m], from the one to the other, while they stick
  double separating_before = 0; ///< [m/s], separating velocity before the small step
  double normal_lambda = 0;     ///< [kg m], along the normal, zero or more
  Vector3<double> friction_lambda = Vector3<double>::Zero(); ///< [kg m], on B, across the normal
};

/// Where that which met on B is now [m], as seen from that on A.
inline Vector3<double> anchor_offset(const PositionPoint& one)
{
  const RigidBody &a = *one.point.a, &b = *one.point.b;
  return b.motion.center + b.orientation * one.anchor_b - a.motion.center -
         a.orientation * one.anchor_a;
}

/// Has a point stick with what meets there now, but for the slip that it owes.
inline void stick(PositionPoint& one)
{
  const RigidBody &a = *one.point.a, &b = *one.point.b;
  const Arms<double> arms = current_arms(one.point);
  one.anchor_a = a.orientation.conjugate() * arms.a;
  one.anchor_b = b.orientation.conjugate() * arms.b;
  one.stick_offset = anchor_offset(one) - one.stored_slip;
}

/// Takes an overlap away, or as much of it as the compliance asks; R15.
inline void solve_normal(PositionPoint& one, double compliance, double most)
{
  const Vector3<double>& normal = one.point.normal;
  const double inverse_mass = current_inverse_mass(one.point, normal);
  const double error = std::max(separation_of(one.point), -most);
  const double change = xpbd_change(error, inverse_mass, compliance, one.normal_lambda);
  const double sum = accumulated_impulse(one.normal_lambda, change);
  apply_position_impulse(one.point, (sum - one.normal_lambda) * normal);
  one.normal_lambda = sum;
}

/// How far [m] B's surface has slipped at a point since it began to stick.
inline Vector3<double> slip(const PositionPoint& one)
{
  return along_surface<double>(anchor_offset(one) - one.stick_offset, one.point.normal);
}

/// Takes a slip back with a friction within the cone; R6.
///
/// Where the cone does not allow that the point slides, and sticks anew where it has come to.
inline void solve_friction(PositionPoint& one)
{
  const Vector3<double> slipped = slip(one);
  const double length = slipped.norm();
  if (one.normal_lambda == 0 || length == 0)
  {
    return;
  }
  const double mass = effective_mass(current_inverse_mass(one.point, slipped / length));
  const Vector3<double> unbounded = one.friction_lambda - mass * slipped;
  const Vector3<double> sum =
      within_cone<double, 3>(unbounded, one.point.coefficient * one.normal_lambda);
  apply_position_impulse(one.point, sum - one.friction_lambda);
  one.friction_lambda = sum;
  if (sum != unbounded)
  {
    one.stick_offset = anchor_offset(one);
  }
}
// [position_point]

} // namespace cookbook
