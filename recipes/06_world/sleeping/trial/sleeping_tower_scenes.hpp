#pragma once

/// \file
/// \brief A tower of cubes asleep, whose lowest cube is taken away.

#include "06_world/sleeping/sleeping.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace cookbook
{

/// What is woken when a body is removed.
enum class Waking
{
  nothing,    ///< sleepers look after themselves
  neighbours, ///< what touched the body
  island      ///< its whole island
};

/// Cubes of 1 m on top of each other; body 0 is the ground, body 1 the lowest cube.
struct Tower
{
  std::vector<double> bottom;             ///< [m], of each body's lower face; the ground's is −1
  std::vector<double> velocity;           ///< [m/s], upwards
  std::vector<SleepState<double>> states; ///< of each body
};

/// A tower that has been asleep for long.
inline Tower sleeping_tower(int cubes)
{
  const std::size_t count = static_cast<std::size_t>(cubes) + 1;
  Tower tower{std::vector<double>(count), std::vector<double>(count), {}};
  SleepState<double> asleep;
  asleep.time_at_rest = 100;
  asleep.asleep = true;
  tower.states.assign(count, asleep);
  for (std::size_t i = 0; i < count; ++i)
  {
    tower.bottom[i] = static_cast<double>(i) - 1;
  }
  return tower;
}

/// The island of each body of a tower, from which cubes touch.
inline std::vector<int> tower_islands(const Tower& tower)
{
  std::vector<std::pair<int, int>> pairs;
  std::vector<bool> movable(tower.bottom.size(), true);
  movable[0] = false;
  for (std::size_t i = 1; i < tower.bottom.size(); ++i)
  {
    if (tower.bottom[i] <= tower.bottom[i - 1] + 1)
    {
      pairs.emplace_back(static_cast<int>(i) - 1, static_cast<int>(i));
    }
  }
  return islands(movable, pairs);
}

/// Takes away the lowest cube, and wakes what is to be woken.
inline void remove_lowest(Tower& tower, Waking waking)
{
  if (waking == Waking::neighbours)
  {
    tower.states[2] = {};
  }
  if (waking == Waking::island)
  {
    wake(tower.states, tower_islands(tower), 1);
  }
  tower.bottom.erase(tower.bottom.begin() + 1);
  tower.velocity.erase(tower.velocity.begin() + 1);
  tower.states.erase(tower.states.begin() + 1);
}

/// Lets awake cubes fall for a step [s], onto what is below them; all of them at one speed.
inline void fall(Tower& tower, double step)
{
  for (std::size_t i = 1; i < tower.bottom.size(); ++i)
  {
    if (!tower.states[i].asleep)
    {
      tower.velocity[i] -= 9.81 * step;
      tower.bottom[i] =
          std::max(tower.bottom[i] + step * tower.velocity[i], tower.bottom[i - 1] + 1);
    }
  }
}

/// After how many steps of 1/60 s every cube that is left has begun to fall; 0 if not within 60.
inline int steps_until_all_fall(int cubes, Waking waking)
{
  Tower tower = sleeping_tower(cubes);
  remove_lowest(tower, waking);
  const std::vector<double> before = tower.bottom;
  for (int step = 1; step <= 60; ++step)
  {
    fall(tower, 1.0 / 60);
    bool all = true;
    for (std::size_t i = 1; i < before.size(); ++i)
    {
      all = all && tower.bottom[i] < before[i];
    }
    if (all)
    {
      return step;
    }
  }
  return 0;
}

} // namespace cookbook
