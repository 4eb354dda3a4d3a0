#pragma once

/// \file
/// \brief One equation of a joint or another constraint, as every solver takes it.

#include "06_world/contacts/rigid_body.hpp"

#include <limits>

namespace cookbook
{

// [constraint_row]
/// Linear and angular part of what belongs to one body.
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// One equation of a constraint between two bodies: J_A v_A + J_B v_B is how fast its error
/// changes, and a push along J takes that away; R36. The two bounds make a limit, which only
/// pushes, or a motor, which is only so strong.
///
/// With the last two it is a spring, in place of a rigid row: in a step of its own it has a speed v
/// become `keeps` v − `pulls` C; `pulls` is −b of (R39).
struct ConstraintRow
{
  Vector6 a;          ///< [1, m], J_A; angular rows [1/m, 1]
  Vector6 b;          ///< [1, m], J_B
  double error = 0;   ///< [m, rad], C: zero where it holds, or above zero where it only pushes
  double turning = 0; ///< [m/s², rad/s²], by which C bends as the bodies turn, however they move
  double speed = 0;   ///< [m/s, rad/s], at which a motor has C change
  bool motor = false; ///< whether it asks for that speed alone, and C is not read
  double lower = -std::numeric_limits<double>::infinity(); ///< [N, N m], least push
  double upper = std::numeric_limits<double>::infinity();  ///< [N, N m], largest push
  double keeps = 0; ///< [1], of the speed; 0 also where it is rigid
  double pulls = 0; ///< [1/s]; 0: no spring
};

/// Whether a row is a spring, with give.
inline bool is_spring(const ConstraintRow& row)
{
  return row.pulls > 0 || row.keeps > 0;
}

/// Whether a row holds whatever it takes, both ways.
inline bool is_rigid(const ConstraintRow& row)
{
  return !is_spring(row) && row.lower == -std::numeric_limits<double>::infinity() &&
         row.upper == std::numeric_limits<double>::infinity();
}

/// Whether a row only pushes, and its error is above zero where it need not.
inline bool is_limit(const ConstraintRow& row)
{
  return row.lower == 0;
}

/// Whether a row is a limit that is not reached.
inline bool is_open(const ConstraintRow& row)
{
  return is_limit(row) && row.error > 0;
}

/// The velocities of a body as six numbers [m/s, rad/s].
inline Vector6 velocities_of(const Motion<double>& motion)
{
  return (Vector6() << motion.velocity, motion.angular_velocity).finished();
}

/// How fast [m/s, rad/s] the error of a row changes as its two bodies move.
inline double row_speed(const ConstraintRow& row, const Motion<double>& a, const Motion<double>& b)
{
  return row.a.head<3>().dot(a.velocity) + row.a.tail<3>().dot(a.angular_velocity) +
         row.b.head<3>().dot(b.velocity) + row.b.tail<3>().dot(b.angular_velocity);
}

/// How much [1/kg, 1/(kg m²)] a body gives way to a push along a row of one body.
inline double inverse_mass_of(const Body<double>& body, const Vector6& row)
{
  const Vector3<double> linear = row.head<3>(), angular = row.tail<3>();
  return body.inverse_mass * linear.squaredNorm() + angular.dot(body.inverse_inertia * angular);
}

/// The velocities [m/s, rad/s] that a push of 1 along a row of a body gives it: M⁻¹ Jᵀ.
inline Vector6 given_by(const Body<double>& body, const Vector6& row)
{
  const Vector3<double> linear = body.inverse_mass * row.head<3>();
  const Vector3<double> angular = body.inverse_inertia * row.tail<3>();
  return (Vector6() << linear, angular).finished();
}

/// Pushes a body by an impulse [N s, N m s] along a row of it.
inline void push_along(Body<double>& body, const Vector6& row, double impulse)
{
  body.motion.velocity += body.inverse_mass * impulse * row.head<3>();
  body.motion.angular_velocity += impulse * (body.inverse_inertia * row.tail<3>());
}
// [constraint_row]

} // namespace cookbook
