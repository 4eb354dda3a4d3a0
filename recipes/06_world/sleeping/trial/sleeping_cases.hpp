#pragma once

/// \file
/// \brief What each rule makes of motions that are not rest, and each way of waking of a tower.

#include "06_world/sleeping/trial/sleeping_scenes.hpp"
#include "06_world/sleeping/trial/sleeping_tower_scenes.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <string>
#include <vector>

namespace cookbook
{

/// A time for a table.
inline std::string seconds(double time)
{
  return number(time) + " s";
}

/// What became of a rule with a motion.
inline Verdict motion_verdict(const WatchedMotion& motion, const SleepRule& rule)
{
  const std::optional<double> asleep = falls_asleep(motion, rule);
  const bool holds = asleep.has_value() == motion.rests;
  return {holds, asleep ? "asleep after " + seconds(*asleep) : "awake"};
}

/// A ball that bounces out, with a threshold of two steps of gravity or with none.
struct BouncingCase
{
  std::string id;     ///< in the book; empty for a neighbour of the case above
  std::string what;   ///< in a few words
  double restitution; ///< [1]
  double threshold;   ///< [m/s]
};

/// All balls.
inline std::vector<BouncingCase> bouncing_cases()
{
  const double threshold = 2 * sleep_gravity * sleep_step;
  return {
      {"L4", "bounces out, e = 0.39, threshold", 0.39, threshold},
      {"", "bounces out, e = 0.8, threshold", 0.8, threshold},
      {"", "e = 0.39, every bounce answered", 0.39, 0},
      {"", "e = 0.8, every bounce answered", 0.8, 0}};
}

/// What became of a rule with a ball: it is to fall asleep on the ground within 6 s.
inline Verdict bouncing_verdict(const BouncingCase& sphere, const SleepRule& rule)
{
  const std::optional<Bedtime> asleep = bounces_out(sphere.restitution, sphere.threshold, rule);
  if (!asleep)
  {
    return {false, "never asleep"};
  }
  const std::string at = asleep->height > 0 ? ", in the air" : "";
  return {asleep->height == 0 && asleep->time <= 6, "asleep after " + seconds(asleep->time) + at};
}

/// The verdicts on all rules.
inline std::vector<VerdictRow> sleep_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const WatchedMotion& motion : watched_motions())
  {
    rows.push_back({motion.id, motion.what, {}});
    for (const SleepRule& rule : sleep_rules())
    {
      rows.back().verdicts.push_back(motion_verdict(motion, rule));
    }
  }
  for (const BouncingCase& sphere : bouncing_cases())
  {
    rows.push_back({sphere.id, sphere.what, {}});
    for (const SleepRule& rule : sleep_rules())
    {
      rows.back().verdicts.push_back(bouncing_verdict(sphere, rule));
    }
  }
  return rows;
}

/// The verdicts on ways of waking: all cubes are to fall within two steps.
inline std::vector<VerdictRow> waking_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const int cubes : {3, 10})
  {
    rows.push_back(
        {cubes == 3 ? "L2" : "",
         std::string("lowest of ").append(number(cubes)).append(" cubes removed"),
         {}});
    for (const Waking waking : {Waking::nothing, Waking::neighbours, Waking::island})
    {
      const int steps = steps_until_all_fall(cubes, waking);
      rows.back().verdicts.push_back(
          {steps >= 1 && steps <= 2,
           steps == 0 ? "asleep in the air" : "fall after step " + number(steps)});
    }
  }
  return rows;
}

} // namespace cookbook
