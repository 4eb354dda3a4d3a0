#pragma once

/// \file
/// \brief Balls shot at a wall and past it, and the ways to move them on.

#include "05_resolution/tunnelling/trial/tunnelling_pitfalls.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to move a ball on by one step.
struct FlightMethod
{
  std::string name; ///< as on the page
  std::function<MovingSphere<double>(
      const MovingSphere<double>&, const Obb<double>& wall, double restitution, double step)>
      stepped; ///< the flight a step later
};

/// Speculative with a margin [m].
inline FlightMethod speculative_method(const std::string& name, double margin)
{
  return {
      name,
      [margin](const MovingSphere<double>& flight, const Obb<double>& wall, double e, double step)
      { return speculative_step(flight, wall, e, step, margin); }};
}

/// Discrete in a number of substeps.
inline FlightMethod substeps_method(const std::string& name, int count)
{
  return {
      name,
      [count](const MovingSphere<double>& flight, const Obb<double>& wall, double e, double step)
      { return substeps(flight, wall, e, step, count); }};
}

/// The one to take.
inline FlightMethod swept_method()
{
  return {
      "swept",
      [](const MovingSphere<double>& flight, const Obb<double>& wall, double e, double step) {
        return swept_step<double>(flight, {&wall, 1}, e, step);
      }};
}

/// The ways that compete; the last is the one to take.
inline std::vector<FlightMethod> flight_methods()
{
  return {
      substeps_method("discrete", 1),
      substeps_method("8 substeps", 8),
      speculative_method("speculative, 2 cm", 0.02),
      speculative_method("speculative", std::numeric_limits<double>::infinity()),
      {"speculative, full bounce",
       [](const MovingSphere<double>& flight, const Obb<double>& wall, double e, double step)
       { return speculative_bounce_step(flight, wall, e, step); }},
      swept_method()};
}

/// Balls on their way along x to a wall, or past it; they differ in how far they still have to go.
struct Shots
{
  Obb<double> wall;         ///< at the origin
  double radius;            ///< [m]
  Vector3<double> velocity; ///< [m/s], with x above zero
  double beside = 0;        ///< [m], of the ball from the wall's upper edge; 0: straight at it
  double restitution = 0;   ///< [1]
  double step = 1.0 / 60;   ///< [s]
  int count = 100;          ///< of balls

  /// The i-th ball: one step and a part of the next before its surface is level with the wall's.
  MovingSphere<double> start(int i) const
  {
    const double steps = 1 + (i + 0.5) / count;
    const double level = -wall.half_extents.x() - radius;
    const double height = beside > 0 ? wall.half_extents.y() + radius + beside : 0;
    const Vector3<double> aim(level, height, 0);
    return {{aim - steps * step * velocity, radius}, velocity};
  }
  /// The number of steps after which every ball is past the wall, or would be.
  int steps() const
  {
    const double depth = 2 * (wall.half_extents.x() + radius);
    return 3 + static_cast<int>(std::ceil(depth / (step * velocity.x())));
  }
};

/// A wall of a thickness [m] across x, 1 km wide and high.
inline Obb<double> wide_wall(double thickness)
{
  return {{0, 0, 0}, Matrix3<double>::Identity(), {thickness / 2, 500, 500}};
}

/// The i-th ball after all its steps.
inline MovingSphere<double> flown(const Shots& shots, const FlightMethod& method, int i)
{
  MovingSphere<double> flight = shots.start(i);
  for (int step = 0; step < shots.steps(); ++step)
  {
    flight = method.stepped(flight, shots.wall, shots.restitution, shots.step);
  }
  return flight;
}

/// The fraction of the balls, 0 to 1, of whose last flight something is true.
template <class Test>
double fraction(const Shots& shots, const FlightMethod& method, const Test& test)
{
  int found = 0;
  for (int i = 0; i < shots.count; ++i)
  {
    found += test(flown(shots, method, i)) ? 1 : 0;
  }
  return static_cast<double>(found) / shots.count;
}

/// The fraction of the balls that come out behind the wall.
inline double share_passed(const Shots& shots, const FlightMethod& method)
{
  return fraction(
      shots, method,
      [](const MovingSphere<double>& flight) { return flight.sphere.center.x() > 0; });
}

/// The most that any of the balls changes its velocity by, as a fraction of its speed.
inline double most_velocity_lost(const Shots& shots, const FlightMethod& method)
{
  double most = 0;
  for (int i = 0; i < shots.count; ++i)
  {
    const Vector3<double> change = flown(shots, method, i).velocity - shots.velocity;
    most = std::max(most, change.norm() / shots.velocity.norm());
  }
  return most;
}

/// The farthest that any of the balls is from coming back with its restitution, as a fraction of
/// that.
inline double most_bounce_lost(const Shots& shots, const FlightMethod& method)
{
  double most = 0;
  for (int i = 0; i < shots.count; ++i)
  {
    const double back = -flown(shots, method, i).velocity.x();
    const double right = shots.restitution * shots.velocity.x();
    most = std::max(most, std::abs(back - right) / right);
  }
  return most;
}

} // namespace cookbook
