#pragma once

/// \file
/// \brief Motions that a sleeper must tell from rest, a ball that bounces out, and a tower that
/// loses its lowest cube.

#include "06_world/sleeping/sleeping.hpp"
#include "common/math/trigonometry.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace cookbook
{

inline constexpr double sleep_step = 1.0 / 60; ///< [s]
inline constexpr double sleep_gravity = 9.81;  ///< [m/s²]
inline constexpr double sleeper_radius = 0.05; ///< [m], of every ball here

/// A rule when a body may sleep.
struct SleepRule
{
  std::string name;           ///< as on the page
  SleepLimits<double> limits; ///< infinite where the rule does not look
  double radius;              ///< [m], of the ball; 0: the rule looks at its centre only
};

/// The rules that compete; the last is the one to take.
inline std::vector<SleepRule> sleep_rules()
{
  const double any = std::numeric_limits<double>::infinity();
  return {
      {"slow", {0.05, any, any, 0}, 0},
      {"slow for 0.5 s", {0.05, any, any, 0.5}, 0},
      {"slow, still, steady", {}, sleeper_radius}};
}

/// How a ball moves at a time.
struct Movement
{
  double velocity;         ///< [m/s], along one direction
  double angular_velocity; ///< [rad/s], about one axis
};

/// A motion that is known at every time.
struct WatchedMotion
{
  std::string id;                          ///< in the book; empty for a neighbour of the one above
  std::string what;                        ///< in a few words
  bool rests;                              ///< whether it is to fall asleep, or must not
  double duration;                         ///< [s]
  std::function<Movement(double time)> at; ///< the motion [s]
};

/// What a ball that rolls without slipping loses of its speed in a second, up a slope [°].
inline double rolling_deceleration(double slope)
{
  return 5.0 / 7 * sleep_gravity * sine(slope * std::numbers::pi / 180);
}

/// A ball that rolls up a slope [°] and back to where it came from, with a speed [m/s].
inline WatchedMotion
rolling_up(const std::string& id, const std::string& what, double slope, double speed)
{
  const double a = rolling_deceleration(slope);
  return {id, what, false, 2 * speed / a, [=](double time) {
            return Movement{speed - a * time, (speed - a * time) / sleeper_radius};
          }};
}

/// A motion that never ends, watched for 20 s.
inline WatchedMotion
unbounded(const std::string& what, bool rests, const std::function<Movement(double)>& at)
{
  return {"", what, rests, 20, at};
}

/// All motions.
inline std::vector<WatchedMotion> watched_motions()
{
  const double up = 0.3 * sleep_gravity, swing = std::sqrt(sleep_gravity);
  return {
      {"L1", "thrown up, 0.6 s in the air", false, 0.6,
       [=](double time) {
         return Movement{up - sleep_gravity * time, 0};
       }},
      rolling_up("", "rolls up 1°, and back", 1, 0.3),
      rolling_up("", "rolls up 0.1°, and back", 0.1, 0.1),
      rolling_up("", "rolls up 0.03°, and back", 0.03, 0.1),
      unbounded(
          "swings by 1 cm on 1 m", false,
          [=](double time) {
            return Movement{0.01 * swing * cosine(swing * time), 0};
          }),
      unbounded(
          "crawls at 4 cm/s", false,
          [](double) {
            return Movement{0.04, 0};
          }),
      unbounded(
          "turns at 0.5 rad/s", false,
          [](double) {
            return Movement{0, 0.5};
          }),
      unbounded(
          "rests, and trembles by 1 mm/s", true,
          [](double time) {
            return Movement{std::lround(time / sleep_step) % 2 == 0 ? 1e-3 : -1e-3, 0};
          })};
}

/// When [s] a motion falls asleep under a rule, if ever.
inline std::optional<double> falls_asleep(const WatchedMotion& motion, const SleepRule& rule)
{
  SleepState<double> state;
  const int steps = static_cast<int>(std::lround(motion.duration / sleep_step));
  for (int i = 0; i <= steps; ++i)
  {
    const double time = i * sleep_step;
    const Movement now = motion.at(time);
    state = update_sleep_state<double>(
        state, {now.velocity, 0, 0}, {0, 0, now.angular_velocity}, rule.radius, sleep_step,
        rule.limits);
    if (state.time_at_rest > 0 && may_sleep(state, rule.limits))
    {
      return time;
    }
  }
  return std::nullopt;
}

/// Where and when a ball falls asleep.
struct Bedtime
{
  double time;   ///< [s]
  double height; ///< [m], above where it rests
};

/// When a ball that is dropped from 1 m falls asleep, within 20 s, if ever; bounces of an approach
/// up to `threshold` [m/s] give nothing back.
inline std::optional<Bedtime>
bounces_out(double restitution, double threshold, const SleepRule& rule)
{
  SleepState<double> state;
  double height = 1, velocity = 0;
  for (int i = 1; i <= 1200; ++i)
  {
    velocity -= sleep_gravity * sleep_step;
    height += velocity * sleep_step;
    if (height <= 0)
    {
      height = 0;
      velocity = -velocity > threshold ? -restitution * velocity : 0;
    }
    state = update_sleep_state<double>(
        state, {0, velocity, 0}, {0, 0, 0}, rule.radius, sleep_step, rule.limits);
    if (state.time_at_rest > 0 && may_sleep(state, rule.limits))
    {
      return Bedtime{i * sleep_step, height};
    }
  }
  return std::nullopt;
}

} // namespace cookbook
