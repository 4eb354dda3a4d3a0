#pragma once

/// \file
/// \brief Towers, and what statics says of them.

#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace cookbook
{

// [statics]
/// What statics says each body of a tower carries in a step [N s], from the ground up: its own
/// weight and that of all above it; R9. Body 0 is the ground.
inline std::vector<double> loads(const Scene& tower)
{
  std::vector<double> sums(tower.bodies.size(), 0.0);
  double above = 0;
  for (std::size_t i = tower.bodies.size(); i-- > 1;)
  {
    above += tower.bodies[i].mass * tower.gravity.norm() * tower.step;
    sums[i] = above;
  }
  return sums;
}

/// The largest error of what the bodies of a tower carry, as a fraction of the load.
inline double load_error(const Scene& tower, const std::vector<double>& warm_start_impulse)
{
  const std::vector<double> right = loads(tower);
  double worst = 0;
  for (std::size_t i = 1; i < right.size(); ++i)
  {
    worst = std::max(worst, std::abs(warm_start_impulse[i] / right[i] - 1));
  }
  return worst;
}

/// The same, of what a solver has them carry after so many steps.
inline double statics_error(const Scene& tower, const std::string& solver, int steps)
{
  return load_error(tower, warm_start_impulse(tower, solver, steps));
}
// [statics]

/// Scenes that shall stand.
inline const std::vector<std::string> standing_scenes{
    "tower",   "tower_20", "tower_40",           "tower_shifted_20",    "tower_turned_20",
    "pyramid", "plates",   "heavy_on_light_100", "heavy_on_light_1000", "heavy_on_light_10000"};

} // namespace cookbook
