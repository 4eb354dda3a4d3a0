#pragma once

/// \file
/// \brief Bounces at several points, and what each way to answer them makes of them.

#include "05_resolution/impulse/bounce.hpp"
#include "05_resolution/impulse/trial/impulse_pitfalls.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace cookbook
{

/// A body A that comes straight down at 1 m/s onto an immovable B; it is to come up at 1 m/s.
template <class Real>
struct BounceCase
{
  std::string id;          ///< in the book; empty for a neighbour of the case above
  std::string what;        ///< in a few words
  BodyPair<Real> bodies;   ///< before the bounce
  Manifold<Real> manifold; ///< its normal points down
};

/// A manifold below a body, with points at these places.
template <class Real>
Manifold<Real> landing_at(const std::vector<Vector3<Real>>& places)
{
  Manifold<Real> manifold{-Vector3<Real>::UnitY(), Real(0), {}};
  for (const Vector3<Real>& place : places)
  {
    manifold.points.push_back({place, Real(0), 0});
  }
  return manifold;
}

/// The unit cube of 1 kg on four points, ± a distance [m] from its middle in x and z.
template <class Real>
BounceCase<Real> cube_on_four(const std::string& id, const std::string& what, const Real& d)
{
  const Real half = Real(1) / Real(2);
  const Vector3<Real> zero = Vector3<Real>::Zero();
  const Motion<Real> falling{Vector3<Real>(0, half, 0), -Vector3<Real>::UnitY(), zero};
  const MassProperties<Real> cube = solid_box<Real>(1, Vector3<Real>::Constant(half));
  const Body<Real> body = dynamic_body<Real>(falling, cube, Matrix3<Real>::Identity());
  return {
      id,
      what,
      {body, static_body(zero)},
      landing_at<Real>({{-d, 0, -d}, {-d, 0, d}, {d, 0, -d}, {d, 0, d}})};
}

/// A ball of 1 kg and radius 1/2 m on `count` points, all of them straight below its centre.
template <class Real>
BounceCase<Real> ball_on_one_place(const std::string& id, const std::string& what, int count)
{
  const Real half = Real(1) / Real(2);
  const Vector3<Real> zero = Vector3<Real>::Zero();
  const Motion<Real> falling{Vector3<Real>(0, half, 0), -Vector3<Real>::UnitY(), zero};
  const MassProperties<Real> ball = solid_sphere<Real>(1, half);
  const Body<Real> body = dynamic_body<Real>(falling, ball, Matrix3<Real>::Identity());
  const std::vector<Vector3<Real>> places(static_cast<std::size_t>(count), zero);
  return {id, what, {body, static_body(zero)}, landing_at<Real>(places)};
}

/// All cases of bounces that lose nothing, e = 1.
template <class Real>
std::vector<BounceCase<Real>> bounce_cases()
{
  return {
      cube_on_four<Real>("S14", "unit cube, flat, points at ±0.5", Real(1) / Real(2)),
      cube_on_four<Real>("", "the same on a pedestal, points at ±0.375", Real(3) / Real(8)),
      ball_on_one_place<Real>("X18", "ball, four points in one place", 4),
      ball_on_one_place<Real>("", "ball, two points in one place", 2),
      ball_on_one_place<Real>("", "ball, one point", 1)};
}

/// A way to answer a bounce that loses nothing.
template <class Real>
struct BounceMethod
{
  std::string name;                                                ///< as on the page
  std::function<BodyPair<Real>(const BounceCase<Real>&)> answered; ///< the bodies afterwards
};

/// The ways that compete; the last is the one to take.
template <class Real>
std::vector<BounceMethod<Real>> bounce_methods()
{
  using Case = BounceCase<Real>;
  return {
      {"as published: divided, 5 passes",
       [](const Case& c) { return bounce_divided(c.bodies, c.manifold, Real(1), 5); }},
      {"each point in turn",
       [](const Case& c) { return bounce_in_turn(c.bodies, c.manifold, Real(1)); }},
      {"bounce, 1 pass", [](const Case& c) { return bounce(c.bodies, c.manifold, Real(1), 1); }},
      {"bounce, 4 passes", [](const Case& c) { return bounce(c.bodies, c.manifold, Real(1), 4); }}};
}

/// A number for a table: rounding errors below a millionth are none.
inline std::string tidy(double value)
{
  return number(std::round(value * 1e6) / 1e6);
}

/// The verdicts on bounces: up at 1 m/s to 1 %, spin at most 0.01 rad/s.
inline std::vector<VerdictRow> bounce_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const BounceCase<double>& one : bounce_cases<double>())
  {
    rows.push_back({one.id, one.what, {}});
    for (const BounceMethod<double>& method : bounce_methods<double>())
    {
      const Motion<double> after = method.answered(one).a.motion;
      const double up = after.velocity.y();
      const double spin = after.angular_velocity.norm();
      rows.back().verdicts.push_back(
          {std::abs(up - 1) <= 0.01 && spin <= 0.01, tidy(up) + " m/s, " + tidy(spin) + " rad/s"});
    }
  }
  return rows;
}

} // namespace cookbook
