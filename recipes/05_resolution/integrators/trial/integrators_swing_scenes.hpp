#pragma once

/// \file
/// \brief Things that go to and fro, and where they then are: oscillator, pendulum, bouncing ball.

#include "05_resolution/integrators/trial/integrators_methods.hpp"
#include "05_resolution/integrators/trial/pendulum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cookbook
{

/// The steps a second that games take unless they say otherwise.
inline constexpr double game_rate = 60;

/// The gravity [m/s²] of these motions.
inline constexpr double falling = 9.81;

/// Something that goes to and fro in one dimension, let go at rest.
struct Swing
{
  AccelerationAt<double> acceleration;
  PhasePoint<double> start;
  double period;              ///< [s], exact
  PhasePoint<double> quarter; ///< where it is after a quarter of its period, exact
  double pace; ///< [1/s], by which its velocities are divided to compare them with its places
};

/// The oscillator: 1 Hz, let go at 1.
inline Swing oscillator()
{
  const double omega = 2 * std::numbers::pi;
  return {[omega](double x, double) { return -omega * omega * x; }, {1, 0}, 1, {0, -omega}, omega};
}

/// The pendulum of 1 m, let go at 90°; the energy of its height is that of its speed below.
inline Swing pendulum()
{
  const Pendulum<double> shape{falling, 1};
  const double level = std::numbers::pi / 2;
  return {
      [shape](double angle, double) { return pendulum_acceleration(shape, angle); },
      {level, 0},
      pendulum_period(shape, level),
      {0, -std::sqrt(2 * falling)},
      std::sqrt(falling)};
}

/// A ball that falls 1 m onto a springy floor and comes back; each second of pushing back, 1 m
/// deep, gives 400 m/s. Where it meets the floor the force has a kink.
inline Swing springy_floor()
{
  const double stiff = 400, omega = 20, impact = std::sqrt(2 * falling);
  const double turning = (std::numbers::pi - std::atan(impact * omega / falling)) / omega;
  const double period = 2 * (impact / falling + turning), quarter = period / 4;
  return {
      [stiff](double y, double) { return -falling - stiff * std::min(y, 0.0); },
      {1, 0},
      period,
      {1 - falling / 2 * quarter * quarter, -falling * quarter},
      std::sqrt(falling)};
}

} // namespace cookbook
