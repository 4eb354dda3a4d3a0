#pragma once

/// \file
/// \brief Rows of tables that compare two kinds of small worlds.

#include "05_resolution/plain_positions/trial/plain_scenes.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <string>

namespace cookbook::small_world
{

/// A length [m] in millimetres.
inline std::string millimetres(double length)
{
  return number(std::round(1e5 * length) / 100) + " mm";
}

/// By how much a stack sinks in a time [s], or that it falls.
template <class World>
std::string sink_of(const World& world, double time)
{
  const double sink = largest_sink(world, time);
  return stands(sink) ? millimetres(sink) : "falls";
}

/// A tower of cubes for 20 s.
template <class One, class Other>
void add_tower(Table& table, int cubes)
{
  table.row(
      {"tower of " + std::to_string(cubes) + ", 20 s", sink_of(tower<One>(cubes), 20),
       sink_of(tower<Other>(cubes), 20), "0 mm"});
}

/// A cube of a mass [kg] on one of 1 kg for 10 s.
template <class One, class Other>
void add_load(Table& table, double mass)
{
  table.row(
      {std::to_string(std::lround(mass)) + " kg on 1 kg, 10 s",
       sink_of(heavy_on_light<One>(mass), 10), sink_of(heavy_on_light<Other>(mass), 10), "0 mm"});
}

/// A cube for 3 s on planes of several slopes, μ = 0.3.
template <class One, class Other>
void add_slopes(Table& table)
{
  for (const double degrees : {10.0, 16.0, 17.0, 20.0})
  {
    table.row(
        {number(degrees) + "°, μ = 0.3, 3 s",
         millimetres(distance_gone(slope<One>(degrees, 0.3), 3)),
         millimetres(distance_gone(slope<Other>(degrees, 0.3), 3)),
         millimetres(right_slide(degrees, 0.3, 3))});
  }
}

} // namespace cookbook::small_world
