#pragma once

/// \file
/// \brief The integrators side by side: each follows a motion for many steps.

#include "05_resolution/integrators/implicit_integrators.hpp"
#include "05_resolution/integrators/integrators.hpp"

#include <functional>
#include <string>
#include <vector>

namespace cookbook
{

/// An acceleration [m/s²] as a function of position and velocity.
template <class Place>
using AccelerationAt = std::function<Place(const Place&, const Place&)>;

/// All points of a motion, a step apart; the first is its start.
template <class Place>
using PhasePath = std::vector<PhasePoint<Place>>;

/// A way to follow a motion.
template <class Place>
struct Integrator
{
  std::string name; ///< as on the page
  /// From a start, with a step [s], for a number of steps.
  std::function<PhasePath<Place>(
      const PhasePoint<Place>&, double, int, const AccelerationAt<Place>&)>
      follow;
};

/// An integrator that takes one step after the other.
template <class Place, class Step>
Integrator<Place> step_by_step(const std::string& name, const Step& take)
{
  return {
      name, [take](
                const PhasePoint<Place>& start, double step, int steps,
                const AccelerationAt<Place>& acceleration)
      {
        PhasePath<Place> course{start};
        for (int i = 0; i < steps; ++i)
        {
          course.push_back(take(course.back(), step, acceleration));
        }
        return course;
      }};
}

/// Velocity Verlet, which hands the acceleration it has found on to the next step.
template <class Place>
PhasePath<Place> follow_verlet(
    const PhasePoint<Place>& start, double step, int steps,
    const AccelerationAt<Place>& acceleration)
{
  PhasePath<Place> course{start};
  VerletPoint<Place> now{start, acceleration(start.position, start.velocity)};
  for (int i = 0; i < steps; ++i)
  {
    now = velocity_verlet(now, step, acceleration);
    course.push_back(now.at);
  }
  return course;
}

/// The integrators that compete.
template <class Place>
std::vector<Integrator<Place>> integrators()
{
  using Point = PhasePoint<Place>;
  using Force = AccelerationAt<Place>;
  return {
      step_by_step<Place>(
          "explicit Euler",
          [](const Point& p, double h, const Force& a) { return explicit_euler(p, h, a); }),
      step_by_step<Place>(
          "implicit Euler",
          [](const Point& p, double h, const Force& a) { return implicit_euler(p, h, a); }),
      step_by_step<Place>(
          "symplectic Euler",
          [](const Point& p, double h, const Force& a) { return symplectic_euler(p, h, a); }),
      {"velocity Verlet", follow_verlet<Place>},
      step_by_step<Place>(
          "RK4", [](const Point& p, double h, const Force& a) { return rk4(p, h, a); }),
      step_by_step<Place>(
          "implicit midpoint",
          [](const Point& p, double h, const Force& a) { return implicit_midpoint(p, h, a); })};
}

} // namespace cookbook
