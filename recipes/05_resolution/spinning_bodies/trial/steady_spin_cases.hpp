#pragma once

/// \file
/// \brief Steady spins, and where each way to turn an orientation ends.

#include "01_math/turning/trial/turning_pitfalls.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace cookbook
{

/// A number above zero with two digits.
inline std::string rough(double value)
{
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return number(std::round(value / unit) * unit);
}

/// A steady spin, and how far an orientation may be off in the end.
struct TurnCase
{
  std::string id;
  std::string what;
  Vector3<double> spin; ///< [rad/s], world
  double duration;      ///< [s]
  double rate;          ///< [Hz]
  double limit;         ///< [rad]
};

/// All cases.
inline std::vector<TurnCase> turn_cases()
{
  const double degree = std::numbers::pi / 180;
  return {
      {"A5", "(0, 50, 0) rad/s for 60 s at 60 Hz", {0, 50, 0}, 60, 60, 1e-3},
      {"A6", "(1, 1, 1) rad/s for 2 s at 60 Hz", {1, 1, 1}, 2, 60, 1e-4 * degree},
      {"X24", "the same in one step of 2 s", {1, 1, 1}, 2, 0.5, 1e-4 * degree}};
}

/// The angle [rad] between two orientations, neither of which need have length one.
inline double angle_between(const Quaternion<double>& a, const Quaternion<double>& b)
{
  const Quaternion<double> turn = a.normalized().conjugate() * b.normalized();
  return 2 * std::atan2(turn.vec().norm(), std::abs(turn.w()));
}

/// The orientation of each way to turn, after a steady spin: three angles, a quaternion added, the
/// same brought back to length one, and the exponential.
inline std::vector<Quaternion<double>> turned_in_four_ways(const TurnCase& one)
{
  Vector3<double> angles = Vector3<double>::Zero();
  Quaternion<double> added(1, 0, 0, 0), unit = added, exact = added;
  const int steps = static_cast<int>(std::lround(one.duration * one.rate));
  for (int i = 0; i < steps; ++i)
  {
    const double step = 1 / one.rate;
    angles = angles_added<double>(angles, one.spin, step);
    added = quaternion_added<double>(added, one.spin, step);
    unit = quaternion_added_and_normalised<double>(unit, one.spin, step);
    exact = rotation_by<double>(step * one.spin) * exact;
  }
  return {from_angles(angles), added, unit, exact};
}

/// The verdicts on steady spins: the orientation off by no more than the limit, its length by 1e-6.
inline std::vector<VerdictRow> turn_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const TurnCase& one : turn_cases())
  {
    rows.push_back({one.id, one.what, {}});
    const Quaternion<double> right = rotation_by<double>(one.duration * one.spin);
    for (const Quaternion<double>& orientation : turned_in_four_ways(one))
    {
      const double off = angle_between(orientation, right), length = orientation.norm();
      const bool unit = std::abs(length - 1) <= 1e-6, holds = unit && off <= one.limit;
      const std::string angle = number(off * 180 / std::numbers::pi) + "°";
      const std::string long_one = ", length " + rough(length);
      rows.back().verdicts.push_back(
          {holds, holds ? "right" : "off by " + angle + (unit ? "" : long_one)});
    }
  }
  return rows;
}

} // namespace cookbook
