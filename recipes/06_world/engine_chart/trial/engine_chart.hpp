#pragma once

/// \file
/// \brief What scenes as games have them cost under our solvers and in Bullet: on average, once
/// they have settled, and in their worst frame.

#include "06_world/game_world/game_world.hpp"
#include "06_world/game_world/trial/world_cost_measured.hpp"
#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"
#include "06_world/soft_steps/soft_settings.hpp"
#include "06_world/wide_passes/wide_passes.hpp"
#include "06_world/world_chart/trial/world_chart.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cookbook
{

/// The solvers that are recommended for some scene; then Bullet, if it is there.
inline std::vector<ChartedSolver> recommended_engines()
{
  std::vector<ChartedSolver> all{
      {"direct", "direct", 0},
      {"soft steps, 4", "soft_steps", 4},
      {"wide steps, 4", "wide_steps", 4}};
#if defined(COOKBOOK_HAS_BULLET)
  all.push_back({"Bullet", "", 0});
#endif
  return all;
}

/// All that are compared.
inline std::vector<ChartedSolver> engines()
{
  std::vector<ChartedSolver> all{
      {"position based, 10", "position_based", 10},
      {"sequential impulses", "sequential_impulses", 0}};
  const std::vector<ChartedSolver> others = recommended_engines();
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

/// A scene in an engine, to be timed.
inline TimedWorld timed(const Scene& scene, const ChartedSolver& engine)
{
  return {
      engine.line,
      [scene, engine]() -> std::function<void()>
      {
#if defined(COOKBOOK_HAS_BULLET)
        if (engine.name.empty())
        {
          return [world = std::make_shared<BulletWorld>(scene)] { world->step(); };
        }
#endif
        return [world = SteppedWorld(scene, engine.name, engine.substeps)]() mutable
        { world.step(); };
      }};
}

// [scene_costs]
/// What a scene costs in an engine, a body and step.
struct SceneCost
{
  double mean;    ///< [s], over the first half of the time
  double worst;   ///< [s], of the dearest step in it
  double settled; ///< [s], over the last tenth of the time
};

/// The cost of a scene of so many bodies whose steps took these times [s].
inline SceneCost scene_cost(std::span<const double> times, double bodies)
{
  const std::span<const double> first = times.first(times.size() / 2);
  const std::span<const double> last = times.last(times.size() / 10);
  return {
      mean_of(first) / bodies, *std::max_element(first.begin(), first.end()) / bodies,
      mean_of(last) / bodies};
}

/// What a scene costs in each engine, over a time [s] of which half is the beginning.
inline std::vector<SceneCost> scene_costs(
    const Scene& scene, const std::vector<ChartedSolver>& engines, double duration, int repetitions)
{
  std::vector<TimedWorld> worlds;
  for (const ChartedSolver& engine : engines)
  {
    worlds.push_back(timed(scene, engine));
  }
  const int steps = static_cast<int>(steps_of(scene, duration));
  std::vector<SceneCost> costs;
  for (const std::vector<double>& times : each_step_seconds(worlds, steps, repetitions))
  {
    costs.push_back(scene_cost(times, movable_bodies(scene)));
  }
  return costs;
}
// [scene_costs]

// [width_costs]
/// What a body and step [s] of a scene cost for a time [s] from its beginning, in registers of each
/// width that this processor has.
inline std::vector<double> width_costs(const Scene& scene, double duration, int repetitions)
{
  std::vector<TimedWorld> worlds;
  for (const InstructionSet set : instruction_sets())
  {
    const auto build = [scene, set]() -> std::function<void()>
    {
      return [world = std::make_shared<GameWorld>(wide_world(scene, wide_passes(set), {}))]
      { world->step(); };
    };
    worlds.push_back({name_of(set), build});
  }
  const int steps = static_cast<int>(steps_of(scene, duration));
  std::vector<double> costs = step_seconds(worlds, steps, repetitions);
  for (double& cost : costs)
  {
    cost /= movable_bodies(scene);
  }
  return costs;
}
// [width_costs]

} // namespace cookbook
