#pragma once

/// \file
/// \brief Fast balls and boxes, and what each way to move them on makes of them.

#include "05_resolution/tunnelling/trial/tunnelling_box_scenes.hpp"
#include "05_resolution/tunnelling/trial/tunnelling_scenes.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// What is asked of the balls of a case.
enum class Asked
{
  stay,   ///< none comes out behind the wall
  fly_by, ///< none changes its velocity by more than 1 mm/s
  bounce  ///< all come back with their restitution, to 1 %
};

/// Balls of some speeds and directions, and what is asked of them.
struct FlightCase
{
  std::string id;           ///< in the book; empty for a neighbour of the case above it
  std::string what;         ///< in a few words
  Asked asked;              ///< of all balls
  std::vector<Shots> shots; ///< all of them
};

/// Balls of 5 cm at a wall [m] straight ahead.
inline Shots straight_at(double thickness, double speed, double restitution)
{
  return {wide_wall(thickness), 0.05, {speed, 0, 0}, 0, restitution};
}

/// Balls of 5 cm that pass the edge of a block of half extents 1, or of a thin wall, by a gap [m].
inline Shots beside(double half_thickness, double gap, double speed)
{
  const Obb<double> wall{{0, 0, 0}, Matrix3<double>::Identity(), {half_thickness, 1, 1}};
  return {wall, 0.05, {speed, 0, 0}, gap};
}

/// Balls at 1 to 1,000 m/s, head-on and up to 80° askew, at a 2 cm wall.
inline std::vector<Shots> all_speeds(double restitution)
{
  std::vector<Shots> all;
  for (int i = 0; i <= 60; ++i)
  {
    const double speed = std::pow(10, i / 20.0);
    for (const double angle : {0.0, 0.7, 1.4})
    {
      Shots shots = straight_at(0.02, speed, restitution);
      shots.velocity = speed * Vector3<double>(std::cos(angle), 0, std::sin(angle));
      all.push_back(shots);
    }
  }
  return all;
}

/// Balls of radius 1/16 at a wall of 1/4, by a number of units a step.
inline Shots sixteenth(double speed)
{
  return {wide_wall(0.25), 0.0625, {speed, 0, 0}, 0, 0, 1};
}

/// All cases of balls.
inline std::vector<FlightCase> flight_cases()
{
  return {
      {"J1", "5 cm at a 10 cm wall, 12.1 m/s", Asked::stay, {straight_at(0.1, 12.1, 0)}},
      {"", "the same at 100 m/s", Asked::stay, {straight_at(0.1, 100, 0)}},
      {"", "the same at 1,000 m/s", Asked::stay, {straight_at(0.1, 1000, 0)}},
      {"", "a 2 cm wall, 1 to 1,000 m/s, to 80° askew", Asked::stay, all_speeds(0.5)},
      {"J2", "1/16 at a wall of 1/4, 50 units a step", Asked::stay, {sixteenth(50)}},
      {"", "the same, 5,000 units a step", Asked::stay, {sixteenth(5000)}},
      {"J4", "past a corner, 1 mm beside, 10 m/s", Asked::fly_by, {beside(1, 0.001, 10)}},
      {"", "past a 2 cm wall, 3 cm beside, 1,000 m/s", Asked::fly_by, {beside(0.01, 0.03, 1000)}},
      {"J8", "e = 1 on a block 1 m thick, 10 m/s", Asked::bounce, {straight_at(1, 10, 1)}},
      {"", "e = 0.8 on a 2 cm wall, 1,000 m/s", Asked::bounce, {straight_at(0.02, 1000, 0.8)}}};
}

/// A share as whole per cent; none only if it is none.
inline std::string percent(double fraction)
{
  return fraction > 0 && fraction < 0.005 ? "under 1 %" : number(std::round(100 * fraction)) + " %";
}

/// What became of a method with all balls of a case.
inline Verdict flight_verdict(const FlightCase& one, const FlightMethod& method)
{
  double worst = 0, mean = 0, passed = 0;
  for (const Shots& shots : one.shots)
  {
    const double now = one.asked == Asked::stay     ? share_passed(shots, method)
                       : one.asked == Asked::fly_by ? most_velocity_lost(shots, method)
                                                    : most_bounce_lost(shots, method);
    worst = std::max(worst, now);
    mean += now / static_cast<double>(one.shots.size());
    passed = std::max(passed, one.asked == Asked::bounce ? share_passed(shots, method) : 0);
  }
  switch (one.asked)
  {
  case Asked::stay:
    return {worst == 0, worst == 0 ? "none passes" : percent(mean) + " pass"};
  case Asked::fly_by:
    return {
        worst * one.shots[0].velocity.norm() <= 1e-3,
        worst == 0 ? "velocity kept" : "changed by " + percent(worst)};
  default:
    return {
        worst <= 0.01, passed > 0      ? percent(passed) + " pass"
                       : worst <= 0.01 ? "bounce kept"
                                       : "off by " + percent(worst)};
  }
}

/// The verdicts on all balls.
inline std::vector<VerdictRow> flight_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const FlightCase& one : flight_cases())
  {
    rows.push_back({one.id, one.what, {}});
    for (const FlightMethod& method : flight_methods())
    {
      rows.back().verdicts.push_back(flight_verdict(one, method));
    }
  }
  return rows;
}

} // namespace cookbook
