#pragma once

/// \file
/// \brief What corrected positions do at one contact point: they take back an overlap and a slip.

#include "06_world/islands/body_shift.hpp"

#include <algorithm>

namespace cookbook
{

// [compliant_change]
/// What a correction adds [kg m] to its sum so far, for a constraint that is off by `error` [m];
/// R15.
///
/// `inverse_mass` [1/kg] is the constraint's, `compliance` [1/kg] the material's over the square of
/// the small step: α̃. Zero where nothing can move.
template <class Real>
Real compliant_change(
    const Real& error, const Real& inverse_mass, const Real& compliance, const Real& accumulated)
{
  const Real felt = inverse_mass + compliance;
  return felt == Real(0) ? Real(0) : Real((-error - compliance * accumulated) / felt);
}
// [compliant_change]

// [position_point]
/// A contact point during a small step.
///
/// What touches and what sticks are two things on a ball: it rolls away over the place where it
/// touched.
struct PositionPoint
{
  IslandPoint point;
  Vector3<double> owed; ///< [m], slip that friction has still to take back
  Vector3<double> own_a =
      Vector3<double>::Zero(); ///< [m], in A's own frame: what met as the step began
  Vector3<double> own_b = Vector3<double>::Zero(); ///< [m], the same in B's
  Vector3<double> held =
      Vector3<double>::Zero(); ///< [m], from the one to the other, while they stick
  double parted = 0;           ///< [m/s], parting speed before the small step
  double pressed = 0;          ///< [kg m], along the normal, zero or more
  Vector3<double> rubbed = Vector3<double>::Zero(); ///< [kg m], on B, across the normal
};

/// Where that which met on B is now [m], as seen from that on A.
inline Vector3<double> between(const PositionPoint& one)
{
  const RigidBody &a = *one.point.a, &b = *one.point.b;
  return b.motion.center + b.orientation * one.own_b - a.motion.center - a.orientation * one.own_a;
}

/// Has a point stick with what meets there now, but for the slip that it owes.
inline void hold(PositionPoint& one)
{
  const RigidBody &a = *one.point.a, &b = *one.point.b;
  const Arms<double> arms = arms_now(one.point);
  one.own_a = a.orientation.conjugate() * arms.a;
  one.own_b = b.orientation.conjugate() * arms.b;
  one.held = between(one) - one.owed;
}

/// Takes an overlap away, or as much of it as the compliance asks; R15.
inline void correct_gap(PositionPoint& one, double compliance, double most)
{
  const Vector3<double>& normal = one.point.normal;
  const double inverse_mass = shift_inverse_mass(one.point, normal);
  const double error = std::max(gap(one.point), -most);
  const double change = compliant_change(error, inverse_mass, compliance, one.pressed);
  const double sum = accumulated_impulse(one.pressed, change);
  shift_apart(one.point, (sum - one.pressed) * normal);
  one.pressed = sum;
}

/// How far [m] B's surface has slipped at a point since it began to stick.
inline Vector3<double> slip(const PositionPoint& one)
{
  return along_surface<double>(between(one) - one.held, one.point.normal);
}

/// Takes a slip back with a friction within the cone; R6.
///
/// Where the cone does not allow that the point slides, and sticks anew where it has come to.
inline void correct_slip(PositionPoint& one)
{
  const Vector3<double> way = slip(one);
  const double length = way.norm();
  if (one.pressed == 0 || length == 0)
  {
    return;
  }
  const double mass = effective_mass(shift_inverse_mass(one.point, way / length));
  const Vector3<double> wanted = one.rubbed - mass * way;
  const Vector3<double> sum = within_cone<double, 3>(wanted, one.point.coefficient * one.pressed);
  shift_apart(one.point, sum - one.rubbed);
  one.rubbed = sum;
  if (sum != wanted)
  {
    one.held = between(one);
  }
}
// [position_point]

} // namespace cookbook
