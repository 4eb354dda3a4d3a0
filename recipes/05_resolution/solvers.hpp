#pragma once

/// \file
/// \brief The solvers of this chapter by name, for a world.

#include "05_resolution/direct_solver.hpp"
#include "05_resolution/position_based.hpp"
#include "05_resolution/sequential_impulses.hpp"
#include "05_resolution/soft_steps.hpp"
#include "05_resolution/solver_names.hpp"
#include "05_resolution/world.hpp"

#include <map>
#include <memory>
#include <stdexcept>
#include <string>

namespace cookbook
{

// [direct_or_soft]
/// The recommended solver: direct where that finds an answer, and a frame of soft steps where it
/// does not, as in impacts and dense heaps.
class DirectOrSoft
{
public:
  /// Soft steps take so many substeps.
  explicit DirectOrSoft(int substeps) : soft_{.substeps = substeps} {}

  /// Moves an island on by a step [s].
  void operator()(IslandView world, const Island& island, double step)
  {
    DirectSolver& direct = (*solvers_)[island.bodies.front()];
    if (!direct.solve(world, island, step))
    {
      return soft_steps(world, island, step, soft_);
    }
    for (const int body : island.bodies)
    {
      move(world.bodies[static_cast<std::size_t>(body)], step);
    }
  }

private:
  SoftSettings soft_;
  // What each island's first body remembers; shared by copies of the solver.
  std::shared_ptr<std::map<int, DirectSolver>> solvers_ =
      std::make_shared<std::map<int, DirectSolver>>();
};
// [direct_or_soft]

// [solvers]
/// A solver by name, with so many substeps, or what it takes itself if that is 0.
///
/// std::invalid_argument if there is no such name, or the substeps are negative.
inline IslandSolver solver_named(const std::string& name, int substeps = 0)
{
  if (substeps < 0)
  {
    throw std::invalid_argument("substeps must be zero or more, got " + std::to_string(substeps));
  }
  const auto or_else = [&](int usual) { return substeps > 0 ? substeps : usual; };
  if (name == "direct")
  {
    return DirectOrSoft(or_else(8));
  }
  if (name == "soft_steps")
  {
    return [how = SoftSettings{.substeps = or_else(4)}](IslandView w, const Island& i, double h)
    { soft_steps(w, i, h, how); };
  }
  if (name == "sequential_impulses" || name == "cold_impulses")
  {
    const bool warm = name == "sequential_impulses";
    return [how = SequentialSettings{.iterations = 8, .warm = warm},
            n = or_else(1)](IslandView w, const Island& i, double h)
    {
      for (int k = 0; k < n; ++k)
      {
        sequential_impulses(w, i, h / n, how);
      }
    };
  }
  if (name == "position_based")
  {
    return
        [how = PositionSettings{.substeps = or_else(20)}](IslandView w, const Island& i, double h)
    { position_based(w, i, h, how); };
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
