#pragma once

/// \file
/// \brief Free spins and the ways to step them, and what is measured on the way.

#include "05_resolution/spinning_bodies/spin_steps.hpp"
#include "05_resolution/spinning_bodies/spin_with_energy.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to step a free spin.
struct SpinMethod
{
  std::string name; ///< as on the page
  std::function<Spinning<double>(const Spinning<double>&, const Vector3<double>&, double)> step;
};

/// All that compete; of the last three the first is the cheapest, the second the one to take for a
/// world, the third the finest.
inline std::vector<SpinMethod> spin_methods()
{
  return {
      {"no term", without_term<double>},
      {"explicit", explicit_term<double>},
      {"explicit, clamped", clamped_term<double>},
      {"implicit, 1 Newton step", implicit_term<double>},
      {"implicit midpoint", implicit_midpoint<double>},
      {"Runge–Kutta", runge_kutta_spin<double>},
      {"axes in turn", axes_in_turn<double>},
      {"turned", turned<double>},
      {"turned_with_energy", turned_with_energy<double>},
      {"turned_finely", turned_finely<double>}};
}

/// A body that spins freely.
struct FreeSpin
{
  std::string what;
  Vector3<double> moments; ///< [kg m²]
  Vector3<double> spin;    ///< [rad/s], along the body's axes, which begin as the world's
};

/// The body of case I4: set spinning about its middle axis, a thousandth askew.
inline FreeSpin tennis_racket()
{
  return {"moments 1, 2, 3, spin (0.01, 10, 0.01)", {1, 2, 3}, {0.01, 10, 0.01}};
}

/// Twice the energy [J] of a free spin.
inline double doubled_energy(const Spinning<double>& body, const Vector3<double>& moments)
{
  const Vector3<double> spin = own_spin(body);
  return moments.cwiseProduct(spin).dot(spin);
}

/// The angular momentum [kg m²/s], world.
inline Vector3<double>
angular_momentum(const Spinning<double>& body, const Vector3<double>& moments)
{
  return body.orientation * moments.cwiseProduct(own_spin(body));
}

/// What became of a free spin.
struct SpinRun
{
  Spinning<double> end;
  std::vector<double> flips; ///< [s], when the spin about y changed its sign
  double energy_ratio;       ///< at the end, of that at the start
  double energy_drift;       ///< the largest |E/E₀ − 1| on the way
  double momentum_drift;     ///< the largest ||L|/|L₀| − 1| on the way
  double momentum_turn;      ///< [rad], the largest angle between L and L₀ on the way
};

/// Calls `visit(time, body)` after each step.
template <class Visit>
Spinning<double> stepped(
    const FreeSpin& scene, const SpinMethod& method, double duration, double rate,
    const Visit& visit)
{
  Spinning<double> body{Quaternion<double>::Identity(), scene.spin};
  const int steps = static_cast<int>(std::lround(duration * rate));
  for (int i = 1; i <= steps; ++i)
  {
    body = method.step(body, scene.moments, 1 / rate);
    visit(i / rate, body);
  }
  return body;
}

/// The larger one, and infinity where there is no number.
inline double worse(double a, double b)
{
  return std::isnan(b) ? std::numeric_limits<double>::infinity() : std::max(a, b);
}

/// A free spin for a duration [s] at a rate [Hz].
inline SpinRun
spin_run(const FreeSpin& scene, const SpinMethod& method, double duration, double rate)
{
  const Spinning<double> start{Quaternion<double>::Identity(), scene.spin};
  const double energy = doubled_energy(start, scene.moments);
  const Vector3<double> momentum = angular_momentum(start, scene.moments);
  SpinRun run{start, {}, 1, 0, 0, 0};
  double last = scene.spin.y();
  const auto visit = [&](double time, const Spinning<double>& body)
  {
    const Vector3<double> now = angular_momentum(body, scene.moments);
    run.energy_ratio = doubled_energy(body, scene.moments) / energy;
    run.energy_drift = worse(run.energy_drift, std::abs(run.energy_ratio - 1));
    run.momentum_drift = worse(run.momentum_drift, std::abs(now.norm() / momentum.norm() - 1));
    const double turn = std::atan2(now.cross(momentum).norm(), now.dot(momentum));
    run.momentum_turn = worse(run.momentum_turn, turn);
    const double spin = own_spin(body).y();
    if (spin * last < 0)
    {
      run.flips.push_back(time - spin / (spin - last) / rate);
    }
    last = spin;
  };
  run.end = stepped(scene, method, duration, rate, visit);
  return run;
}

/// The orientation of a free spin after a duration [s]: fourth order, 3,840 steps a second, in long
/// double.
inline Quaternion<double> true_orientation(const FreeSpin& scene, double duration)
{
  using Long = long double;
  Spinning<Long> body{Quaternion<Long>::Identity(), scene.spin.cast<Long>()};
  const int steps = static_cast<int>(std::lround(duration * 3840));
  for (int i = 0; i < steps; ++i)
  {
    body = turned_finely<Long>(body, scene.moments.cast<Long>(), Long(1) / 3840);
  }
  return body.orientation.cast<double>();
}

} // namespace cookbook
