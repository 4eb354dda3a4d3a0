#pragma once

/// \file
/// \brief What each solver costs beside how far it lets a scene sink, and Bullet beside them.

#include "05_resolution/solvers.hpp"
#include "05_resolution/world_cost_measured.hpp"
#include "05_resolution/world_measures.hpp"
#include "05_resolution/world_peer_bullet.hpp"
#include "05_resolution/world_scenes.hpp"
#include "common/program/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cookbook
{

// [charted_solvers]
/// A solver as the chart runs it.
struct ChartedSolver
{
  std::string line; ///< the curve that it belongs to
  std::string name; ///< of the solver; empty: Bullet
  int substeps;     ///< 0: its own
};

/// The solvers of the chart; the recommended one first.
inline std::vector<ChartedSolver> charted_solvers()
{
  std::vector<ChartedSolver> all{{"direct", "direct", 0}};
  for (const int substeps : {2, 4, 8, 16, 32})
  {
    all.push_back({"soft steps", "soft_steps", substeps});
  }
  for (const int substeps : {5, 10, 20, 40})
  {
    all.push_back({"position based", "position_based", substeps});
  }
  for (const int substeps : {1, 2, 4, 8})
  {
    all.push_back({"sequential impulses", "sequential_impulses", substeps});
  }
#if defined(COOKBOOK_HAS_BULLET)
  all.push_back({"Bullet", "", 0});
#endif
  return all;
}
// [charted_solvers]

/// What a solver made of a scene.
struct ChartedRun
{
  ChartedSolver solver;
  double seconds; ///< a body and step
  double moved;   ///< [m], the farthest body, at the end
};

/// The farthest [m] that a body of a scene is from where it began.
inline double farthest(const Scene& scene, const Frame& frame)
{
  double most = 0;
  for (std::size_t i = 0; i < frame.bodies.size(); ++i)
  {
    most = std::max(most, (frame.bodies[i].position - scene.bodies[i].position).norm());
  }
  return most;
}

// [world_to_time]
/// A step of a world that, at the last of its steps, writes how far the farthest body has gone.
///
/// `frame(world)` says where its bodies are.
template <class AnyWorld, class FrameOf>
std::function<void()> counted_step(
    std::shared_ptr<AnyWorld> world, const Scene& scene, ChartedRun& run, int steps,
    const FrameOf& frame)
{
  return [world, scene, &run, steps, frame, done = 0]() mutable
  {
    world->step();
    if (++done == steps)
    {
      run.moved = farthest(scene, frame(*world));
    }
  };
}

/// A scene with a solver, to be timed.
inline TimedWorld timed_world(const Scene& scene, ChartedRun& run, int steps)
{
  const auto build = [scene, &run, steps]
  {
#if defined(COOKBOOK_HAS_BULLET)
    if (run.solver.name.empty())
    {
      return counted_step(
          std::make_shared<BulletWorld>(scene), scene, run, steps,
          [](const BulletWorld& world) { return world.frame(); });
    }
#endif
    const IslandSolver solver = solver_named(run.solver.name, run.solver.substeps);
    return counted_step(std::make_shared<World>(scene, solver), scene, run, steps, &frame_of);
  };
  return {run.solver.line, build};
}
// [world_to_time]

/// All solvers on a scene for a time [s], timed in turns.
inline std::vector<ChartedRun>
charted_runs(const Scene& scene, double duration, const std::vector<ChartedSolver>& solvers)
{
  const int steps = static_cast<int>(std::lround(duration / scene.step));
  std::vector<ChartedRun> runs;
  for (const ChartedSolver& solver : solvers)
  {
    runs.push_back({solver, 0, 0});
  }
  std::vector<TimedWorld> worlds;
  for (ChartedRun& run : runs)
  {
    worlds.push_back(timed_world(scene, run, steps));
  }
  const std::vector<double> seconds = step_seconds(worlds, steps);
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    runs[i].seconds = seconds[i] / movable_bodies(scene);
  }
  return runs;
}

/// A row of text: the time of a run [µs], how far its bodies went, and its time as a share of
/// Bullet's.
inline std::vector<std::string> charted_row(const ChartedRun& run, double bullet)
{
  std::string name = run.solver.line;
  if (run.solver.substeps > 0)
  {
    name.append(", ").append(std::to_string(run.solver.substeps));
  }
  return {
      name, number(run.seconds * 1e6), run.moved > 0.5 ? "falls" : number(run.moved * 1e3),
      bullet > 0 ? number(run.seconds / bullet) : "–"};
}

} // namespace cookbook
