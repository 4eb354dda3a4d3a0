#pragma once

/// \file
/// \brief What a step of a world costs, several worlds in one run.

#include "tools/measure/timing.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
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

/// The processor's time [s] for something.
inline double seconds_of(const std::function<void()>& run)
{
  const double start = measure::processor_seconds();
  run();
  return measure::processor_seconds() - start;
}

/// The time [s] of each step of each world, from the start on: a list of steps for each world.
///
/// The worlds take turns at every step, and all of it is repeated: a step is the same work each
/// time, so the least of its times counts, and whatever else the machine does is left out. Before
/// each start every world is built once more, and takes a step that does not count, so that the
/// code of first steps has been read lately.
inline std::vector<std::vector<double>>
each_step_seconds(const std::vector<TimedWorld>& worlds, int steps, int repetitions = 3)
{
  const std::size_t count = static_cast<std::size_t>(steps);
  const double never = std::numeric_limits<double>::max();
  std::vector<std::vector<double>> least(worlds.size(), std::vector<double>(count, never));
  for (int repetition = 0; repetition < repetitions; ++repetition)
  {
    for (const TimedWorld& world : worlds)
    {
      world.build()();
    }
    std::vector<std::function<void()>> built;
    for (const TimedWorld& world : worlds)
    {
      built.push_back(world.build());
    }
    for (std::size_t step = 0; step < count; ++step)
    {
      for (std::size_t world = 0; world < worlds.size(); ++world)
      {
        least[world][step] = std::min(least[world][step], seconds_of(built[world]));
      }
    }
  }
  return least;
}

/// The mean of some times [s].
inline double mean_of(std::span<const double> times)
{
  return std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
}

/// The time [s] a step of each world, on average over all steps from the start on.
inline std::vector<double>
step_seconds(const std::vector<TimedWorld>& worlds, int steps, int repetitions = 3)
{
  std::vector<double> average;
  for (const std::vector<double>& times : each_step_seconds(worlds, steps, repetitions))
  {
    average.push_back(mean_of(times));
  }
  return average;
}

} // namespace cookbook
