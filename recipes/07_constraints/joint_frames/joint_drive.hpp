#pragma once

/// \file
/// \brief Limits, a motor and a spring along one coordinate of a joint.

#include "06_world/constraints/joint_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace cookbook
{

// [joint_drive]
/// What acts along the coordinate of a joint, an angle [rad] or a length [m]; by itself nothing.
struct JointDrive
{
  double lower = -std::numeric_limits<double>::infinity(); ///< [rad, m], least coordinate
  double upper = std::numeric_limits<double>::infinity();  ///< [rad, m], largest coordinate
  double motor_speed = 0;                                  ///< [rad/s, m/s], that a motor asks for
  double motor_force = 0; ///< [N m, N], of a motor at most; 0: there is none
  double stiffness = 0;   ///< [N m/rad, N/m], of a spring
  double damping = 0;     ///< [N m s/rad, N s/m], of a damper
  double rest = 0;        ///< [rad, m], where the spring does not pull
};

/// Makes a row that of a spring with a damper, in a step [s], for bodies that give way to it as a
/// mass [kg, kg m²] does: the pull of now, then the damper; R57. At rest the pull is stiffness
/// times stretch at any step; a spring that would swing by more than a radian in the step is
/// damped.
inline void
make_spring(ConstraintRow& row, double stiffness, double damping, double mass, double step)
{
  const double push = mass > 0 ? step * stiffness / mass : 0; // [1/s]
  const double slows = mass > 0 ? step * damping / mass : 0;
  const double divided = 1 + slows + slows * slows / 2 + std::max(0.0, step * push - 1);
  row.keeps = std::max(1 / divided, 1e-12); // above zero: a spring, however stiff
  row.pulls = push / divided;
}

/// Adds the rows of a drive, with the coordinate as the `error` of a row along it: the spring, the
/// motor, and last the limits, which have the last word; R57.
inline void add_drive_rows(
    const JointDrive& drive, const ConstraintRow& along, const RigidBody& a, const RigidBody& b,
    double step, JointRows& rows)
{
  if (drive.stiffness > 0 || drive.damping > 0)
  {
    ConstraintRow row = along;
    row.error -= drive.rest;
    make_spring(row, drive.stiffness, drive.damping, row_mass(row, a, b), step);
    rows.add(row);
  }
  if (drive.motor_force > 0)
  {
    ConstraintRow row = along;
    row.error = row.turning = 0; // it asks for a speed alone
    row.motor = true;
    row.speed = drive.motor_speed;
    row.lower = -drive.motor_force;
    row.upper = drive.motor_force;
    rows.add(row);
  }
  for (const auto& [limit, sign] : {std::pair{drive.lower, 1.0}, std::pair{drive.upper, -1.0}})
  {
    if (std::isfinite(limit))
    {
      ConstraintRow row = along;
      row.a *= sign;
      row.b *= sign;
      row.error = sign * (along.error - limit); // above zero: not reached
      row.turning *= sign;
      row.lower = 0;
      rows.add(row);
    }
  }
}
// [joint_drive]

// [check_drive]
/// Refuses a drive that makes no sense, std::invalid_argument by member and value.
inline void check_drive(const JointDrive& drive, const std::string& member)
{
  const auto refuse = [&](const std::string& name, double value, const char* must)
  {
    throw std::invalid_argument(
        "joint: " + member + "." + name + " is " + std::to_string(value) + "; it must be " + must);
  };
  const auto check = [&](const char* name, double value, bool from_zero)
  {
    if (!std::isfinite(value) || (from_zero && value < 0))
    {
      refuse(name, value, from_zero ? "finite and zero or more" : "finite");
    }
  };
  if (!(drive.lower <= drive.upper))
  {
    refuse("lower", drive.lower, "no more than upper");
  }
  check("motor_speed", drive.motor_speed, false);
  check("motor_force", drive.motor_force, true);
  check("stiffness", drive.stiffness, true);
  check("damping", drive.damping, true);
  check("rest", drive.rest, false);
}
// [check_drive]

} // namespace cookbook
