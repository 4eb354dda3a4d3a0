#pragma once

/// \file
/// \brief What a push does to a body, where a wrong way to compute it fails.

#include "05_resolution/impulse/impulse.hpp"
#include "05_resolution/impulse/trial/impulse_pitfalls.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// What a push does to a body: as published, as here, and by hand.
struct ResponseCase
{
  std::string id;   ///< in the book; empty for a neighbour of the case above
  std::string what; ///< in a few words, with the unit
  double published; ///< the answer as published
  double ours;      ///< the answer of impulse.hpp
  double right;     ///< by hand
};

/// A solid's answer to a turn of 1 N m s about x, as published and as here.
inline ResponseCase turned_solid(
    const std::string& id, const std::string& what, const MassProperties<double>& solid,
    double right)
{
  const Matrix3<double> upright = Matrix3<double>::Identity();
  const Matrix3<double> inertia = solid.moments.asDiagonal();
  return {
      id, what, threshold_inverse(inertia, 0.005)(0, 0),
      world_inverse_inertia(solid.moments, upright)(0, 0), right};
}

/// A rod, 2 m by 0.2 m by 0.2 m, 1 kg, stood upright and turned by 1 N m s about its own length.
inline ResponseCase upright_rod()
{
  const MassProperties<double> rod = solid_box<double>(1, {1, 0.1, 0.1});
  Matrix3<double> upright;
  upright << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  return {
      "X19", "upright rod, 2 m × 0.2 m × 0.2 m, turned about y [rad/s]",
      unturned_inverse_inertia(rod.moments, upright)(1, 1),
      world_inverse_inertia(rod.moments, upright)(1, 1), 150};
}

/// A ball of 2 kg that is given 6 N s.
inline ResponseCase pushed_ball()
{
  const Vector3<double> zero = Vector3<double>::Zero();
  const Vector3<double> impulse(6, 0, 0);
  Body<double> ball =
      dynamic_body<double>({zero, zero, zero}, solid_sphere(2.0, 0.5), Matrix3<double>::Identity());
  const double regardless = pushed_regardless(ball, impulse).motion.velocity.x();
  apply_impulse(ball, zero, impulse);
  return {"X26", "ball of 2 kg, pushed by 6 N s [m/s]", regardless, ball.motion.velocity.x(), 3};
}

/// All cases of what a push does.
inline std::vector<ResponseCase> response_cases()
{
  const auto cube = [](double side)
  { return solid_box<double>(1, Vector3<double>::Constant(side / 2)); };
  return {
      upright_rod(),
      turned_solid("X20", "cube of 1 kg, side 1 m, turned [rad/s]", cube(1), 6),
      turned_solid("", "cube of 1 kg, side 0.2 m, turned [rad/s]", cube(0.2), 150),
      turned_solid("", "ball of 1 kg, radius 0.5 m, turned [rad/s]", solid_sphere(1.0, 0.5), 10),
      turned_solid("", "cube of 1 kg, side 2 m, turned [rad/s]", cube(2), 1.5),
      pushed_ball()};
}

/// The verdicts on what a push does: right to a millionth.
inline std::vector<VerdictRow> response_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const ResponseCase& one : response_cases())
  {
    const auto verdict = [&](double answer) -> Verdict {
      return {std::abs(answer - one.right) <= 1e-6 * one.right, number(answer)};
    };
    rows.push_back({one.id, one.what, {verdict(one.published), verdict(one.ours)}});
  }
  return rows;
}

} // namespace cookbook
