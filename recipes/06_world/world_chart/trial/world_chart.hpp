#pragma once

/// \file
/// \brief What each solver costs beside how far it lets a scene sink, and Bullet beside them.

#include "06_world/direct_solver/trial/direct_solver_scenes.hpp"
#include "06_world/game_world/trial/world_cost_measured.hpp"
#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"
#include "06_world/world_chart/trial/world_peer_bullet.hpp"
#include "tools/program/table.hpp"

#include <algorithm>
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
    all.push_back({"wide steps", "wide_steps", substeps});
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

/// How good a solver was, at the end of a scene.
struct ChartedEnd
{
  double moved;      ///< [m], the farthest body, from where it began
  double overlap;    ///< [m], the deepest
  double load_error; ///< [1], of what bodies carry, if the scene is a tower
};

/// What a solver made of a scene.
struct ChartedRun
{
  ChartedSolver solver;
  double seconds; ///< a body and step
  ChartedEnd end;
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

/// A step of a world that, at the last of its steps, says what came of it.
template <class AnyWorld>
std::function<void()>
counted_step(const std::shared_ptr<AnyWorld>& world, const Scene& scene, ChartedRun& run, int steps)
{
  return [world, scene, &run, steps, done = 0]() mutable
  {
    world->step();
    if (++done == steps)
    {
      run.end = {
          farthest(scene, world->frame()), world->deepest_overlap(),
          load_error(scene, world->warm_start_impulse())};
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
      return counted_step(std::make_shared<BulletWorld>(scene), scene, run, steps);
    }
#endif
    const auto world = std::make_shared<SteppedWorld>(scene, run.solver.name, run.solver.substeps);
    return counted_step(world, scene, run, steps);
  };
  return {run.solver.line, build};
}

/// All solvers on a scene for a time [s], timed in turns.
inline std::vector<ChartedRun> charted_runs(
    const Scene& scene, double duration, const std::vector<ChartedSolver>& solvers, int repetitions)
{
  const int steps = static_cast<int>(steps_of(scene, duration));
  std::vector<ChartedRun> runs;
  for (const ChartedSolver& solver : solvers)
  {
    runs.push_back({solver, 0, {0, 0, 0}});
  }
  std::vector<TimedWorld> worlds;
  for (ChartedRun& run : runs)
  {
    worlds.push_back(timed_world(scene, run, steps));
  }
  const std::vector<double> seconds = step_seconds(worlds, steps, repetitions);
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    runs[i].seconds = seconds[i] / movable_bodies(scene);
  }
  return runs;
}

/// A cost as a fraction of Bullet's; – where Bullet is not there.
inline std::string share_of_bullet(double cost, double bullet)
{
  return bullet > 0 ? number(cost / bullet) : "–";
}

/// A row of text: the time of a run [µs], how far its bodies went and overlap [mm], its error of
/// loads if the scene is a tower, and its time as a fraction of Bullet's.
inline std::vector<std::string> charted_row(const ChartedRun& run, bool tower, double bullet)
{
  std::string name = run.solver.line;
  if (run.solver.substeps > 0)
  {
    name.append(", ").append(std::to_string(run.solver.substeps));
  }
  const std::string fraction = share_of_bullet(run.seconds, bullet);
  if (run.end.moved > 0.5)
  {
    return {name, number(run.seconds * 1e6), "falls", "–", "–", fraction};
  }
  return {
      name,
      number(run.seconds * 1e6),
      number(run.end.moved * 1e3),
      number(run.end.overlap * 1e3),
      tower ? number(run.end.load_error) : "–",
      fraction};
}

} // namespace cookbook
