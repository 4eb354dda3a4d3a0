#pragma once

/// \file
/// \brief The recommended solver: direct, or by soft steps where that finds no answer.

#include "06_world/direct_solver/direct_solver.hpp"
#include "06_world/game_world/island_impulses.hpp"
#include "06_world/game_world/joint_substeps.hpp"
#include "06_world/soft_steps/soft_steps.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
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

/// Hears of each island how its frame was solved, or, with joints, each of its substeps.
using DirectObserver = std::function<void(const Island&, DirectAnswer)>;

/// The recommended solver: direct where that finds an answer, and soft steps where it does not, as
/// in impacts and dense heaps.
///
/// An island of few bodies is tried once more, without friction where overlaps open. Where it has
/// not found an answer it lets some frames pass before it tries again: 1, 2, 4, up to 16;
/// then with soft contacts, which become stiff from frame to frame. An island for which exact
/// answers do not last, such as a heap of jammed spheres, would be squeezed by that again and
/// again, and gain energy where it opens: it is left to soft steps, for a time that grows. A copy
/// remembers what the original did, and goes on by itself.
///
/// An island with joints is solved in substeps: a taut chain swings too fast for a frame. How many
/// it takes, the frame before has told; a pull that comes suddenly is taken by implicit steps.
class DirectOrSoft
{
public:
  /// Soft steps take so many substeps; arms turn and corners are sharp, as in the frames that are
  /// solved. `observer`, if given, hears of every island and frame.
  explicit DirectOrSoft(int substeps, DirectObserver observer = {}, JointSubsteps joints = {})
      : joints_(joints),
        soft_{.substeps = substeps, .anchor_lag = 0, .torsional_radius = 0},
        resting_{.substeps = substeps},
        observer_(std::move(observer))
  {
  }

  /// Moves an island on by a step [s].
  void operator()(IslandView world, const Island& island, double step)
  {
    Tries& tries = tries_of(world, island);
    if (island.constraints.empty())
    {
      if (!step_directly(tries, world, island, step))
      {
        soft_steps(world, island, step, tries.rest.left() ? resting_ : soft_);
      }
      return;
    }
    DrivenAlong driven(world, island);
    const int substeps = substeps_of(joints_, step * std::exchange(tries.swing_rate, 0));
    const double substep = step / substeps;
    scale_impulses(world, island, 1, substeps);
    std::vector<bool> fell;
    for (int left = substeps; left > 0; --left)
    {
      if (!step_directly(tries, world, island, substep))
      {
        scale_impulses(world, island, left, 1);
        soft_steps(world, island, left * substep, tries.rest.left() ? resting_ : soft_);
        scale_impulses(world, island, 1, left);
        left = 1;
      }
      tries.swing_rate = std::max(tries.swing_rate, tries.direct.swing() / substep);
      keep_pushed(world, island, fell);
      driven.move(substep);
    }
    scale_impulses(world, island, substeps, 1);
  }

  /// How many islands it remembers: none that has joined another one.
  std::size_t remembered() const { return tries_.size(); }

private:
  static constexpr std::size_t few = 8; // bodies, for which a second try costs little
  struct Tries
  {
    DirectSolver direct;
    std::size_t bodies = 1;
    int frames_to_wait = 0;
    int pause = 1;        // frames to wait after the next failure
    double softening = 0; // how soft contacts are in the next try
    Restlessness rest;
    double swing_rate = 0; // [rad/s], ω of the frame, R63
  };

  /// Tries to move an island on by a step [s].
  bool step_directly(Tries& tries, IslandView world, const Island& island, double step)
  {
    const DirectAnswer answer = solved(tries, world, island, step);
    if (observer_)
    {
      observer_(island, answer);
    }
    if (answer == DirectAnswer::none)
    {
      forget_over_constrained(world, island);
      return false;
    }
    first_ = tries.direct.velocities();
    const bool opens = answer == DirectAnswer::exact && tries.direct.opening() > slow_opening &&
                       tries.direct.solve_without_opening(
                           world, island, step, {.squared_swing = joints_.squared_swing});
    DirectStep stepped(world, island, first_, opens ? tries.direct.velocities() : first_);
    run_substeps(world, {&island, 1}, step, stepped);
    return true;
  }

  /// What is known of an island; of those that it was made of no more is, nor of what is gone.
  Tries& tries_of(IslandView world, const Island& island)
  {
    const auto id = [&](int body) { return id_at(world.bodies, index_of(body)); };
    if (tries_.size() > 2 * kept_) // bodies that were taken out are fixed
    {
      std::erase_if(
          tries_,
          [&](const auto& one)
          {
            const std::size_t first = index_of_id(one.first);
            return first >= world.bodies.size() || is_fixed(world.bodies[first]) ||
                   id_at(world.bodies, first) != one.first;
          });
      kept_ = tries_.size() + 16;
    }
    Tries& tries = tries_[id(island.bodies.front())];
    if (tries.bodies != island.bodies.size())
    {
      tries.bodies = island.bodies.size();
      for (std::size_t i = 1; i < tries.bodies; ++i)
      {
        tries_.erase(id(island.bodies[i]));
      }
    }
    return tries;
  }

  /// Whether any body of an island is a sphere: one that is jammed opens again by rolling aside.
  static bool has_spheres(IslandView world, const Island& island)
  {
    return std::any_of(
        island.bodies.begin(), island.bodies.end(),
        [&](int i) { return world.bodies[index_of(i)].is_sphere; });
  }

  /// Finds the velocities of an island, unless it has to wait or no answer is found.
  DirectAnswer solved(Tries& tries, IslandView world, const Island& island, double step) const
  {
    if (tries.frames_to_wait > 0)
    {
      --tries.frames_to_wait;
      tries.rest.wait(step);
      return DirectAnswer::none;
    }
    bool soft = tries.softening > 0;
    const auto solve_at = [&](double softening, int iterations)
    {
      DirectSettings settings = settings_at(softening);
      settings.iterations = iterations;
      settings.squared_swing = joints_.squared_swing;
      return tries.direct.solve(world, island, step, settings);
    };
    bool found = solve_at(tries.softening, DirectSettings{}.iterations);
    if (!found && !soft && island.bodies.size() <= few && tries.direct.opens())
    {
      found = tries.direct.solve(
          world, island, step, {.squared_swing = joints_.squared_swing, .opening_friction = false});
    }
    if (!found && !soft && !island.constraints.empty()) // contacts give way rather than joints
    {
      found = soft = solve_at(1, 3 * DirectSettings{}.iterations);
    }
    tries.frames_to_wait = found ? 0 : tries.pause;
    tries.pause = found ? 1 : std::min(2 * tries.pause, 16);
    tries.softening = next_softening(tries.softening, found);
    const double absence = tries.rest.watch(found, soft, has_spheres(world, island), step);
    if (absence > 0)
    {
      tries.frames_to_wait = static_cast<int>(std::min(absence / step, 1e9));
      tries.softening = 0;
    }
    return !found ? DirectAnswer::none : soft ? DirectAnswer::softened : DirectAnswer::exact;
  }

  JointSubsteps joints_;
  SoftSettings soft_;                 // of single frames, between others
  SoftSettings resting_;              // of an island that is left to them
  std::vector<DirectVelocity> first_; // of an island's bodies, in the first answer
  DirectObserver observer_;
  std::map<BodyId, Tries> tries_; // by the island's first body
  std::size_t kept_ = 16;         // how many there were, and some more, when it was last tidied up
};
// [direct_or_soft]

} // namespace cookbook
