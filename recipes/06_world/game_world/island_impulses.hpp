#pragma once

/// \file
/// \brief What an island remembers of its impulses when one solver takes over from another.

#include "06_world/islands/island_constraints.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cookbook
{

/// Forgets what the points of an island were given in the frame before if any is over-constrained:
/// what held it in balance may be gone. Stiff contacts do without it, small steps would begin with
/// it.
inline void forget_over_constrained(IslandView world, const Island& island)
{
  const auto any_over_constrained = [&](int i)
  {
    const auto& points = world.contacts[index_of(i)].points;
    return std::any_of(
        points.begin(), points.end(),
        [](const WorldPoint& point) { return point.over_constrained; });
  };
  if (std::any_of(island.contacts.begin(), island.contacts.end(), any_over_constrained))
  {
    for (const int i : island.contacts)
    {
      for (WorldPoint& point : world.contacts[index_of(i)].points)
      {
        point.impulse = point.warm_start_impulse = 0;
        point.friction.setZero();
        point.over_constrained = false;
      }
    }
  }
}

// [island_impulses]
/// Turns impulses over so many substeps into those over others.
inline void scale_impulses(IslandView world, const Island& island, int to, int from)
{
  const double scale = static_cast<double>(to) / from;
  for (const int i : island.contacts)
  {
    for (WorldPoint& point : world.contacts[index_of(i)].points)
    {
      point.impulse *= scale;
      point.warm_start_impulse *= scale;
      point.friction *= scale;
    }
  }
  from > 1 ? prepare_constraints(world, island, from) : store_constraints(world, island, to);
}

/// What was pushed in a substep before does not fall freely in the step.
inline void keep_pushed(IslandView world, const Island& island, std::vector<bool>& fell)
{
  if (world.falls == nullptr)
  {
    return;
  }
  fell.resize(island.bodies.size(), true);
  for (std::size_t k = 0; k < fell.size(); ++k)
  {
    const std::size_t i = index_of(island.bodies[k]);
    fell[k] = fell[k] && (*world.falls)[i];
    (*world.falls)[i] = fell[k];
  }
}
// [island_impulses]

} // namespace cookbook
