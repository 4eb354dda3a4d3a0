#pragma once

/// \file
/// \brief How the solvers are made, each by its name.

#include "06_world/game_world/direct_or_soft.hpp"
#include "06_world/game_world/solver_names.hpp"
#include "06_world/position_based/position_based.hpp"
#include "06_world/sequential_impulses/sequential_impulses.hpp"
#include "06_world/wide_solver/wide_solver.hpp"

#include <span>
#include <stdexcept>
#include <string>

namespace cookbook
{

// [solvers]
COOKBOOK_WORLD_INLINE WorldSolver soft_solver(const SoftSettings& how)
{
  return one_by_one([how](IslandView w, const Island& i, double h) { soft_steps(w, i, h, how); });
}

COOKBOOK_WORLD_INLINE WorldSolver wide_solver(const SoftSettings& how, const WidePasses& passes)
{
  return [how,
          lanes = WideContacts(passes)](IslandView w, std::span<const Island> all, double h) mutable
  { wide_steps(w, all, h, how, lanes); };
}

COOKBOOK_WORLD_INLINE WorldSolver solver_named(const std::string& name, int substeps)
{
  if (substeps < 0)
  {
    throw std::invalid_argument("substeps must be zero or more, got " + std::to_string(substeps));
  }
  const auto or_else = [&](int usual) { return substeps > 0 ? substeps : usual; };
  if (name == "direct")
  {
    return one_by_one(DirectOrSoft(or_else(8)));
  }
  if (name == "soft_steps")
  {
    return soft_solver({.substeps = or_else(4)});
  }
  if (name == "wide_steps")
  {
    return wide_solver({.substeps = or_else(4)}, widest_passes());
  }
  if (name == "sequential_impulses" || name == "cold_impulses")
  {
    const bool warm_starting = name == "sequential_impulses";
    const SequentialSettings how{
        .substeps = or_else(1), .iterations = 8, .warm_starting = warm_starting};
    return one_by_one([how](IslandView w, const Island& i, double h)
                      { sequential_impulses(w, i, h, how); });
  }
  if (name == "position_based")
  {
    const PositionSettings how{.substeps = or_else(20)};
    return one_by_one([how](IslandView w, const Island& i, double h)
                      { position_based(w, i, h, how); });
  }
  std::string all;
  for (const std::string& one : solver_names())
  {
    all.append(all.empty() ? "" : ", ").append(one);
  }
  throw std::invalid_argument("there is no solver '" + name + "'; there are " + all);
}
// [solvers]

} // namespace cookbook
