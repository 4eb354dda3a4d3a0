#pragma once

/// \file
/// \brief A rung of the ladder of worlds: the scene that it holds and the rung below fails.

#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

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
