/// \file
/// \brief Runs scenes, as every solver moves them.

#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/trial/joint_opening.hpp"
#include "06_world/game_world/trial/world_cost_measured.hpp"
#include "06_world/game_world/trial/world_measures.hpp"
#include "06_world/islands/island_points.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"

#include <algorithm>
#include <cmath>

namespace cookbook
{

std::size_t steps_of(const Scene& scene, double duration)
{
  return static_cast<std::size_t>(
      std::llround((duration < 0 ? scene.duration : duration) / scene.step));
}

GameWorld wide_world(const Scene& scene, const WidePasses& passes, const SoftSettings& how)
{
  return GameWorld(scene, wide_solver(how, passes));
}

WorldRun run_world(
    const Scene& scene, const RunSettings& settings,
    const std::function<void(std::size_t)>& observer)
{
  GameWorld world(scene, solver_named(settings.solver, settings.substeps), settings.may_sleep);
  const Vector3<double>& gravity = scene.gravity;
  WorldRun run;
  run.frames.push_back(frame_of(world));
  run.energy_start = run.energy_most = energy(world.bodies(), gravity);
  run.joined = world.constraint_sets() > 0;
  const std::size_t steps = steps_of(scene, settings.duration);
  const double bodies = movable_bodies(scene);
  for (std::size_t i = 1; i <= steps; ++i)
  {
    if (settings.before_step)
    {
      settings.before_step(world);
    }
    const double seconds = seconds_of([&] { world.step(); });
    run.time += seconds / (bodies * static_cast<double>(steps));
    run.longest_step = std::max(run.longest_step, seconds / bodies);
    run.deepest = std::max(run.deepest, deepest_overlap(world));
    run.energy_most = std::max(run.energy_most, energy(world.bodies(), gravity));
    const JointOpening open = joint_opening(world);
    run.joints_open = std::max(run.joints_open, open.length);
    run.joints_turned = std::max(run.joints_turned, open.angle);
    if (settings.keeps_frames || i == steps)
    {
      run.frames.push_back(frame_of(world));
    }
    if (observer)
    {
      observer(i);
    }
  }
  run.overlap = deepest_overlap(world);
  const FarthestMove move = farthest_move(scene, world);
  run.drift = move.sideways;
  run.sink = move.along;
  run.energy_end = energy(world.bodies(), gravity);
  run.momentum = momentum(world.bodies());
  run.residual = residual(world);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
  {
    run.asleep += world.has(i) && world.is_asleep(i) ? 1 : 0;
  }
  return run;
}

std::vector<double> warm_start_impulse(const Scene& scene, const std::string& solver, int steps)
{
  GameWorld world(scene, solver_named(solver));
  for (int i = 0; i < steps; ++i)
  {
    world.step();
  }
  return carried_in(world);
}

std::vector<std::pair<int, int>> touching_pairs(const Scene& scene)
{
  GameWorld world(scene, [](IslandView, const Island&, double) {});
  world.step();
  std::vector<std::pair<int, int>> pairs;
  for (const WorldContact& contact : world.contacts())
  {
    pairs.push_back(pair_of(contact));
  }
  return pairs;
}

SteppedWorld::SteppedWorld(const Scene& scene, const std::string& solver, int substeps)
    : world_(std::make_shared<GameWorld>(scene, solver_named(solver, substeps)))
{
}

void SteppedWorld::step()
{
  world_->step();
}

Frame SteppedWorld::frame() const
{
  return frame_of(*world_);
}

double SteppedWorld::deepest_overlap() const
{
  return cookbook::deepest_overlap(*world_);
}

std::vector<double> SteppedWorld::warm_start_impulse() const
{
  return carried_in(*world_);
}

} // namespace cookbook
