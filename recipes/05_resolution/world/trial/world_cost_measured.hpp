#pragma once

/// \file
/// \brief What a step of a world costs, several worlds in one run.

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace cookbook
{

/// A world to be timed.
struct TimedWorld
{
  std::string name;                             ///< of the solver or the engine
  std::function<std::function<void()>()> build; ///< gives what takes a step; not timed
};

/// The time [s] that something takes.
inline double seconds_of(const std::function<void()>& run)
{
  const auto start = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// [step_seconds]
/// The time [s] a step of each world, on average over all steps from the start on.
///
/// The worlds take turns at every step, and all of it is repeated: a step is the same work each
/// time, so the least of its times counts, and whatever else the machine does is left out.
inline std::vector<double>
step_seconds(const std::vector<TimedWorld>& worlds, int steps, int repetitions = 3)
{
  const std::size_t count = worlds.size() * static_cast<std::size_t>(steps);
  std::vector<double> least(count, std::numeric_limits<double>::max());
  for (int repetition = 0; repetition < repetitions; ++repetition)
  {
    std::vector<std::function<void()>> built;
    for (const TimedWorld& world : worlds)
    {
      built.push_back(world.build());
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      least[i] = std::min(least[i], seconds_of(built[i % worlds.size()]));
    }
  }
  std::vector<double> average(worlds.size(), 0.0);
  for (std::size_t i = 0; i < count; ++i)
  {
    average[i % worlds.size()] += least[i] / steps;
  }
  return average;
}
// [step_seconds]

} // namespace cookbook
