#pragma once

/// \file
/// \brief The solvers of this chapter by name, for a world.

#include "05_resolution/direct_solver/direct_solver.hpp"
#include "05_resolution/position_based/position_based.hpp"
#include "05_resolution/sequential_impulses/sequential_impulses.hpp"
#include "05_resolution/soft_steps/soft_steps.hpp"
#include "05_resolution/wide_solver/wide_solver.hpp"
#include "05_resolution/world/solver_names.hpp"
#include "05_resolution/world/world.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

// [direct_or_soft]
/// How a frame of an island was solved.
enum class DirectAnswer
{
  none,     ///< not directly: by soft steps
  softened, ///< directly, with contacts that give way
  exact     ///< directly, with contacts as stiff as they get
};

/// Hears of each island how its frame was solved.
using DirectWatch = std::function<void(const Island&, DirectAnswer)>;

/// The recommended solver: direct where that finds an answer, and soft steps where it does not, as
/// in impacts and dense heaps.
///
/// Where it has not found one it lets some frames pass before it tries again: 1, 2, 4, up to 16;
/// then with soft contacts, which become stiff from frame to frame. A copy remembers what the
/// original did, and goes on by itself.
class DirectOrSoft
{
public:
  /// Soft steps take so many substeps; `watch`, if given, hears of every island and frame.
  explicit DirectOrSoft(int substeps, DirectWatch watch = {})
      : soft_{.substeps = substeps}, watch_(std::move(watch))
  {
  }

  /// Moves an island on by a step [s].
  void operator()(IslandView world, const Island& island, double step)
  {
    const DirectAnswer answer = solved(tries_of(island), world, island, step);
    if (watch_)
    {
      watch_(island, answer);
    }
    if (answer == DirectAnswer::none)
    {
      return soft_steps(world, island, step, soft_);
    }
    for (const int body : island.bodies)
    {
      move(world.bodies[static_cast<std::size_t>(body)], step);
    }
  }

  /// How many islands it remembers: none that has joined another one.
  std::size_t remembered() const { return tries_.size(); }

private:
  struct Tries
  {
    DirectSolver direct;
    std::size_t bodies = 1;
    int frames_to_wait = 0;
    int pause = 1;   // frames to wait after the next failure
    double give = 0; // how soft contacts are in the next try
  };

  /// What is known of an island; of those that it was made of no more is.
  Tries& tries_of(const Island& island)
  {
    Tries& tries = tries_[island.bodies.front()];
    if (tries.bodies != island.bodies.size())
    {
      tries.bodies = island.bodies.size();
      for (std::size_t i = 1; i < tries.bodies; ++i)
      {
        tries_.erase(island.bodies[i]);
      }
    }
    return tries;
  }

  /// Sets the velocities of an island, unless it has to wait or no answer is found.
  static DirectAnswer solved(Tries& tries, IslandView world, const Island& island, double step)
  {
    if (tries.frames_to_wait > 0)
    {
      --tries.frames_to_wait;
      return DirectAnswer::none;
    }
    const bool soft = tries.give > 0;
    const bool found = tries.direct.solve(world, island, step, settings_at(tries.give));
    tries.frames_to_wait = found ? 0 : tries.pause;
    tries.pause = found ? 1 : std::min(2 * tries.pause, 16);
    tries.give = next_give(tries.give, found);
    return !found ? DirectAnswer::none : soft ? DirectAnswer::softened : DirectAnswer::exact;
  }

  SoftSettings soft_;
  DirectWatch watch_;
  std::map<int, Tries> tries_; // by the island's first body
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
  if (name == "wide_steps")
  {
    return [how = SoftSettings{.substeps = or_else(4)},
            lanes = WideContacts()](IslandView w, const Island& i, double h) mutable
    { wide_steps(w, i, h, how, lanes); };
  }
  if (name == "sequential_impulses" || name == "cold_impulses")
  {
    const bool warm = name == "sequential_impulses";
    return [how = SequentialSettings{.iterations = 8, .warm = warm},
            n = or_else(1)](IslandView w, const Island& i, double h)
    {
      const auto scale = [&](double by)
      {
        const std::span<IslandPoint> points = points_of(w, i);
        scale_impulses(points, by);
        store(points);
      };
      scale(1.0 / n);
      for (int k = 0; k < n; ++k)
      {
        sequential_impulses(w, i, h / n, how);
      }
      scale(n);
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
