#pragma once

/// \file
/// \brief A rung of the ladder of worlds: the scene that it holds and the rung below fails.

#include "05_resolution/small_world/trial/small_scenes.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace cookbook
{

/// What a rung adds, and the scene that it holds and the rung below fails.
struct Rung
{
  std::string name;  ///< a step's number, or what a branch is called
  std::string adds;  ///< in the field's words
  std::string scene; ///< in a few words
  Verdict below;     ///< of the rung below
  Verdict here;      ///< of this one
  std::string right; ///< the right value
};

/// What a stack of cubes does that sinks so far [m]: its sink in mm, or that it falls.
inline Verdict sinks(double sink)
{
  const bool stands = small_world::stands(sink);
  return {stands, stands ? "sinks " + rounded(1000 * sink) + " mm" : "falls"};
}

/// The speeds [m/s] of shots at a wall.
inline constexpr std::array<double, 5> shot_speeds{10, 30, 100, 300, 1000};

/// How many of them come back; all is right.
inline Verdict come_back(std::size_t count)
{
  return {count == shot_speeds.size(), std::to_string(count) + " of 5 come back"};
}

/// Rungs as a table, under what their columns are called.
inline Cells rungs_table(const std::vector<std::string>& columns, const std::vector<Rung>& rungs)
{
  Cells cells{columns};
  for (const Rung& rung : rungs)
  {
    cells.push_back(
        {rung.name, rung.adds, rung.scene, rung.below.what, rung.here.what, rung.right});
  }
  return cells;
}

} // namespace cookbook
