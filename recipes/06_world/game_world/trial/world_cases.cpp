/// \file
/// \brief Scenes on which solvers fail, run with each of them.

#include "06_world/game_world/trial/world_cases.hpp"
#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"
#include "06_world/game_world/solver_names.hpp"
#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/game_world/world_inputs.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"
#include "tools/program/table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace cookbook
{

namespace
{

/// A case: its id in the book, what is asked, and how a solver is judged.
struct WorldCase
{
  std::string id;
  std::string what;
  std::function<Verdict(const std::string& solver)> oracle;
};

/// A number in millimetres or millimetres a second, to two digits.
std::string in_thousandths(double value, const std::string& unit)
{
  const double thousandths = 1000 * value;
  if (thousandths < 0.01)
  {
    return std::string("under 0.01 ").append(unit);
  }
  const double power = std::pow(10, std::floor(std::log10(thousandths)) - 1);
  return number(std::round(thousandths / power) * power).append(" ").append(unit);
}

/// All frames of a scene.
std::vector<Frame> frames_of(const Scene& scene, const std::string& solver, double duration)
{
  return run_world(scene, {.solver = solver, .duration = duration, .keeps_frames = true}).frames;
}

/// S3: each cube of a dropped tower is on top of the one below it in the end.
Verdict stands_dropped(const std::string& solver)
{
  const WorldRun run = run_world(scenes::tower_dropped(15), {.solver = solver, .duration = 20});
  const Frame& end = run.frames.back();
  double most = 0;
  for (std::size_t i = 1; i < end.bodies.size(); ++i)
  {
    most = std::max(most, std::abs(end.bodies[i].position.y() + 0.5 - double(i)));
  }
  return most > 0.5 ? Verdict{false, "falls"} : Verdict{most <= 0.1, in_thousandths(most, "mm")};
}

/// S6, S7, S21: how far anything has gone, within a limit [m].
Verdict stays(const Scene& scene, const std::string& solver, double duration, double limit)
{
  const WorldRun run = run_world(scene, {.solver = solver, .duration = duration});
  const double moved = std::hypot(run.sink, run.drift);
  return moved > 0.5 ? Verdict{false, "falls"}
                     : Verdict{moved <= limit, in_thousandths(moved, "mm")};
}

/// S8: two balls of 1 kg under one of 100 kg, which is taken away after 2 s: how fast they hop.
Verdict stays_unloaded(const std::string& solver)
{
  Scene scene = scenes::standing(4);
  for (int i = 0; i < 3; ++i)
  {
    scene.bodies.push_back(
        ball_body(numbered("ball", i + 1), 0.5, {0, i + 0.5, 0}, i < 2 ? 1 : 100));
  }
  double fastest = 0;
  RunSettings settings{.solver = solver};
  settings.before_step = [&fastest, step = 0](GameWorld& world) mutable
  {
    if (++step == 120)
    {
      world.remove(3);
    }
    if (step > 120)
    {
      fastest = std::max(
          {fastest, world.bodies()[1].motion.velocity.y(), world.bodies()[2].motion.velocity.y()});
    }
  };
  run_world(scene, settings);
  return {fastest <= 0.1, in_thousandths(fastest, "mm/s")};
}

/// S18: cubes that begin inside each other: how fast they part, and what energy that leaves beyond
/// the work of lifting each by as much as it lay in what is below it.
Verdict parts_gently(const std::string& solver)
{
  const Scene scene = scenes::overlap();
  const WorldRun run = run_world(scene, {.solver = solver, .keeps_frames = true});
  const double lifted = 9.81 * (3 * 0.25 + 2 * 0.5 + 1 * 0.75 + 0.5);
  double fastest = 0;
  for (const Frame& frame : run.frames)
  {
    for (const BodyState& body : frame.bodies)
    {
      fastest = std::max(fastest, body.velocity.norm());
    }
  }
  const double gained = run.energy_most - run.energy_start;
  const auto rounded = [](double value) { return number(std::round(10 * value) / 10); };
  return {
      fastest <= 4 && gained <= lifted,
      rounded(fastest).append(" m/s, ").append(rounded(gained)).append(" J")};
}

/// S22: what slides or rolls over flush tiles keeps its speed and does not hop.
Verdict slides_on(const std::string& solver, bool sphere)
{
  Scene scene = scenes::tiles();
  if (sphere)
  {
    scene.bodies.back().shape = SphereShape{0.5};
  }
  double upward = 0;
  const std::vector<Frame> frames = frames_of(scene, solver, 2.8);
  for (const Frame& frame : frames)
  {
    upward = std::max(upward, std::abs(frame.bodies.back().velocity.y()));
  }
  const double lost = std::abs(frames.back().bodies.back().velocity.x() / 3 - 1);
  return {lost <= 0.01 && upward <= 0.001, in_thousandths(upward, "mm/s up")};
}

/// S23: ten balls of 1 kg under one of 100 kg, the mirror image of a chain with 100 kg at its end:
/// by what fraction of its length it gives way in 5 s.
Verdict holds_as_chain(const std::string& solver)
{
  Scene scene = scenes::standing();
  for (int i = 0; i <= 10; ++i)
  {
    const double mass = i < 10 ? 1 : 100;
    scene.bodies.push_back(ball_body(numbered("ball", i + 1), 0.5, {0, i + 0.5, 0}, mass));
  }
  double most = 0;
  for (const Frame& frame : frames_of(scene, solver, 5))
  {
    most = std::max(most, std::abs(frame.bodies.back().position.y() - 10.5) / 10.5);
  }
  return {most <= 0.01, number(std::round(1000 * most) / 10).append(" %")};
}

bool same_places(const Frame& a, const Frame& b, std::size_t count)
{
  return std::equal(
      a.bodies.begin(), a.bodies.begin() + static_cast<std::ptrdiff_t>(count), b.bodies.begin(),
      [](const BodyState& one, const BodyState& other)
      { return one.position == other.position && one.velocity == other.velocity; });
}

/// S20: the same bits twice, and with one more body far away.
Verdict repeats(const std::string& solver)
{
  const Scene scene = scenes::pile(12);
  Scene with_other = scene;
  with_other.bodies.push_back(cube_body("other", {500, 2, 0}));
  const RunSettings settings{.solver = solver, .duration = 2};
  const Frame once = run_world(scene, settings).frames.back();
  const std::size_t count = scene.bodies.size();
  const bool same = same_places(once, run_world(scene, settings).frames.back(), count) &&
                    same_places(once, run_world(with_other, settings).frames.back(), count);
  return {same, same ? "same bits" : "other bits"};
}

/// L3: a force that is not a number on one box of a heap, tried in every step.
Verdict refuses(const std::string& solver)
{
  const Scene scene = scenes::pile(12);
  RunSettings settings{.solver = solver, .duration = 1};
  const Frame alone = run_world(scene, settings).frames.back();
  int refused = 0;
  settings.before_step = [&refused](GameWorld& world)
  {
    try
    {
      apply_force(world, 3, {std::numeric_limits<double>::quiet_NaN(), 0, 0});
    }
    catch (const std::invalid_argument&)
    {
      ++refused;
    }
  };
  const Frame pushed = run_world(scene, settings).frames.back();
  const bool same = refused == 60 && same_places(alone, pushed, scene.bodies.size());
  return {same, same ? "refused" : "spreads"};
}

/// A ball at rest on the ground.
Scene resting_ball()
{
  Scene scene = scenes::standing(60);
  scene.bodies.push_back(ball_body("ball", 0.5, {0, 0.5, 0}));
  return scene;
}

/// All cases.
std::vector<WorldCase> world_cases()
{
  const auto within = [](const Scene& scene, double duration, double limit)
  { return [=](const std::string& solver) { return stays(scene, solver, duration, limit); }; };
  const auto over_tiles = [](bool sphere)
  { return [sphere](const std::string& solver) { return slides_on(solver, sphere); }; };
  return {
      {"S3", "15 cubes dropped 10 cm apart, μ = 0.3, 20 s", stands_dropped},
      {"S6", "1,000,000 kg on 1 kg, 5 s: 2 cm", within(scenes::heavy_on_light(1'000'000), 5, 0.02)},
      {"S7", "pyramid of ten rows, 300 kg on top, 10 s: 10 cm",
       within(scenes::pyramid_heavy_top(300), 10, 0.1)},
      {"S8", "100 kg taken off two balls of 1 kg: up at 0.1 m/s", stays_unloaded},
      {"S18", "cubes inside each other: 4 m/s, 29.4 J", parts_gently},
      {"S20", "a heap, twice, and with a cube far away", repeats},
      {"S21", "a ball on the ground, 60 s: 1 mm", within(resting_ball(), 60, 0.001)},
      {"S22", "a cube over flush tiles, 3 m/s: 1 mm/s", over_tiles(false)},
      {"", "a ball over them", over_tiles(true)},
      {"S23", "ten balls of 1 kg under 100 kg, a chain's image, 5 s: 1 %", holds_as_chain},
      {"L3", "a force that is not a number in a heap", refuses}};
}

} // namespace

std::vector<VerdictRow> world_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const WorldCase& one : world_cases())
  {
    rows.push_back({one.id, one.what, {}});
    for (const std::string& solver : solver_names())
    {
      rows.back().verdicts.push_back(one.oracle(solver));
    }
  }
  return rows;
}

} // namespace cookbook
