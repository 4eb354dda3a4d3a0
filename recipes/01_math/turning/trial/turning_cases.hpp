#pragma once

/// \file
/// \brief Steady spins, the ways to follow them, and how far each is off in the end.

#include "01_math/rotations/quaternion_of.hpp"
#include "01_math/turning/trial/turning_pitfalls.hpp"
#include "01_math/turning/turning.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace cookbook
{

// [turning_cases]
/// A steady spin, and how far an orientation may be off in the end.
struct TurningCase
{
  std::string id;       ///< in the book; empty for one of our own
  std::string what;     ///< spin, time, rate and number type
  Vector3<double> spin; ///< [rad/s], world
  int steps;            ///< how many
  double rate;          ///< [Hz]
  double limit;         ///< [rad]
  bool in_float;        ///< in float, or in double
};

/// All cases.
inline std::vector<TurningCase> turning_cases()
{
  const double degree = std::numbers::pi / 180;
  return {
      {"A5", "(0, 50, 0) rad/s for 60 s at 60 Hz", {0, 50, 0}, 3600, 60, 1e-3, false},
      {"A6", "(1, 1, 1) rad/s for 2 s at 60 Hz", {1, 1, 1}, 120, 60, 1e-4 * degree, false},
      {"", "no spin for 1 s", {0, 0, 0}, 60, 60, 1e-6, true},
      {"", "1e-25 rad/s about y, float", {0, 1e-25, 0}, 60, 60, 1e-6, true},
      {"", "1e25 rad/s about y, float", {0, 1e25, 0}, 60, 60, 7, true},
      {"", "1 rad/s for a million steps, float", {0.6, 0, 0.8}, 1000000, 60, 0.01, true}};
}
// [turning_cases]

/// Where a way to turn ends: its orientation, and the length of its quaternion or of its axes.
struct SpinEnd
{
  Quaternion<double> orientation; ///< of length one, if it is a number at all
  double length;                  ///< [1]
};

/// The end as a quaternion of any length.
template <class Real>
SpinEnd spin_end(const Quaternion<Real>& q)
{
  const Quaternion<double> wide = q.template cast<double>();
  const double length = wide.norm();
  return {Quaternion<double>(wide.coeffs() / length), length};
}

/// A way to turn, by name: from no turn, so many steps of a spin.
template <class Real>
struct SpinWay
{
  std::string name;                                             ///< as on the page
  std::function<SpinEnd(const Vector3<Real>&, Real, int)> turn; ///< spin, step, how many
};

/// A way that goes from quaternion to quaternion, as so many steps.
template <class Real, class Step>
auto by_quaternions(Step one)
{
  return [one](const Vector3<Real>& spin, Real step, int steps)
  {
    Quaternion<Real> q = Quaternion<Real>::Identity();
    for (int i = 0; i < steps; ++i)
    {
      q = one(q, spin, step);
    }
    return spin_end(q);
  };
}

/// The ways that compete, the recommended one last.
template <class Real>
std::vector<SpinWay<Real>> spin_ways()
{
  const auto angles = [](const Vector3<Real>& spin, Real step, int steps)
  {
    Vector3<Real> sum = Vector3<Real>::Zero();
    for (int i = 0; i < steps; ++i)
    {
      sum = angles_added<Real>(sum, spin, step);
    }
    return spin_end(from_angles(sum));
  };
  const auto matrix = [](const Vector3<Real>& spin, Real step, int steps)
  {
    Matrix3<Real> axes = Matrix3<Real>::Identity();
    for (int i = 0; i < steps; ++i)
    {
      axes = matrix_added<Real>(axes, spin, step);
    }
    return SpinEnd{spin_end(quaternion_of(axes)).orientation, axes.col(2).norm()};
  };
  return {
      {"angles added, as published", angles},
      {"quaternion added", by_quaternions<Real>(quaternion_added<Real>)},
      {"added, length one", by_quaternions<Real>(quaternion_added_and_normalised<Real>)},
      {"half-angle fraction", by_quaternions<Real>(turned_by_fraction<Real>)},
      {"matrix added, orthonormal", matrix},
      {"divided by |ω|", by_quaternions<Real>(turned_by_division<Real>)},
      {"turned_by", by_quaternions<Real>(turned_by<Real>)}};
}

/// The angle [rad] from where a spin ends in truth, by its closed form in long double; 0 where the
/// case allows any orientation.
inline double spin_error(const TurningCase& one, const SpinEnd& end)
{
  const Vector3<long double> spin = one.spin.cast<long double>();
  const long double speed = spin.norm(), half = speed * one.steps / one.rate / 2;
  const Vector3<long double> v =
      speed > 0 ? Vector3<long double>(spin / speed * std::sin(half)) : Vector3<long double>(spin);
  const Quaternion<double> right(
      double(std::cos(half)), double(v.x()), double(v.y()), double(v.z()));
  const Quaternion<double> turn = right.conjugate() * end.orientation;
  return 2 * std::atan2(turn.vec().norm(), std::abs(turn.w()));
}

/// Whether a way held: the orientation off by no more than the limit, its length by 1/1000.
inline Verdict spin_verdict(const TurningCase& one, const SpinEnd& end)
{
  const bool finite = std::isfinite(end.length) && end.orientation.coeffs().allFinite();
  if (!finite)
  {
    return {false, "not a number"};
  }
  const double degrees = spin_error(one, end) * 180 / std::numbers::pi;
  const bool right = degrees <= one.limit * 180 / std::numbers::pi;
  const bool unit = std::abs(end.length - 1) <= 1e-3;
  const std::string angle = one.in_float ? rounded(degrees) : number(degrees);
  const std::string off = right ? "" : "off by " + angle + "°";
  // Two digits do not tell a length close to one from one.
  const bool close = rounded(end.length) == rounded(1);
  const std::string size = close ? number(end.length) : rounded(end.length);
  const std::string length = unit ? "" : "length " + size;
  return {right && unit, right && unit ? "right" : off + (right || unit ? "" : ", ") + length};
}

/// The verdicts on all ways, case by case.
inline std::vector<VerdictRow> turning_verdicts()
{
  std::vector<VerdictRow> rows;
  const auto add = [&](const TurningCase& one, auto zero)
  {
    using Real = decltype(zero);
    const Vector3<Real> spin = one.spin.cast<Real>();
    for (const SpinWay<Real>& way : spin_ways<Real>())
    {
      const SpinEnd end = way.turn(spin, static_cast<Real>(1 / one.rate), one.steps);
      rows.back().verdicts.push_back(spin_verdict(one, end));
    }
  };
  for (const TurningCase& one : turning_cases())
  {
    rows.push_back({one.id, one.what, {}});
    one.in_float ? add(one, 0.0f) : add(one, 0.0);
  }
  return rows;
}

} // namespace cookbook
