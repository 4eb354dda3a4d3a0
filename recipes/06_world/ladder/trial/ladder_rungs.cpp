/// \file
/// \brief Runs the branches of the ladder, and both worlds on the same scenes.

#include "06_world/ladder/trial/ladder_rungs.hpp"
#include "05_resolution/small_world/small_world.hpp"
#include "05_resolution/small_world/trial/small_scenes.hpp"
#include "06_world/contacts/start_body.hpp"
#include "06_world/contacts/tree_overlaps.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/ladder/trial/ladder.hpp"
#include "06_world/ladder/trial/ladder_scenes.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"
#include "06_world/wide_solver/wide_groups.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <regex>
#include <stdexcept>

namespace cookbook
{

namespace
{

using Small = small_world::World;

/// The last state of a scene in GameWorld.
std::vector<BodyState> ends(const Scene& scene, const std::string& solver, double time)
{
  return run_world(scene, {.solver = solver, .duration = time}).frames.back().bodies;
}

/// The last state of a scene in the small world.
std::vector<small_world::RigidBody> small_ends(const Scene& scene, double time)
{
  Small world = small_of<Small>(scene);
  small_world::run(world, time);
  return world.bodies;
}

/// Stacks of a scene: by how much the body that sank most did in 20 s.
Rung stack(
    const std::string& name, const std::string& adds, const std::string& what, const Scene& scene,
    const std::string& solver)
{
  return {
      name,
      adds,
      what,
      sinks(small_world::largest_sink(small_of<Small>(scene), 20)),
      sinks(run_world(scene, {.solver = solver, .duration = 20}).sink),
      "stands"};
}

/// The load [N] that the ground takes from a tower of five after 20 s awake; within 1 % is right.
Rung load()
{
  const double right = 5 * 9.81, step = small_world::frame;
  const auto verdict = [right](double newtons) {
    return Verdict{std::abs(newtons - right) < 0.01 * right, rounded(newtons) + " N"};
  };
  Small world = small_of<Small>(scenes::tower(5));
  for (int i = 0; i < 1200; ++i)
  {
    keep_awake(world);
    small_world::step(world, step);
  }
  double impulse = 0; // of the last of four substeps
  for (const small_world::Contact& contact : world.contacts)
  {
    impulse += contact.a == 0 ? contact_impulse<double>(contact).y() : 0;
  }
  return {
      "",
      "",
      "load of a tower of 5",
      verdict(impulse / (step / 4)),
      verdict(warm_start_impulse(scenes::tower(5), "direct", 1200)[1] / step),
      rounded(right) + " N"};
}

/// The turns in which contact points of a wall are solved, one point or 16 of them at a time; at
/// most an eighth is right.
Rung turns()
{
  const Scene scene = scenes::wall(10);
  Small small = small_of<Small>(scene);
  std::size_t points = 0;
  auto groups = std::make_shared<std::size_t>(0);
  const auto count = [groups, solver = solver_named("wide_steps")](
                         IslandView view, std::span<const Island> all, double step) mutable
  {
    std::vector<int> contacts;
    for (const Island& island : all)
    {
      contacts.insert(contacts.end(), island.contacts.begin(), island.contacts.end());
    }
    WideGroups found;
    found.find(view, contacts, 16);
    *groups = found.points();
    solver(view, all, step);
  };
  GameWorld game(scene, WorldSolver(count));
  for (int i = 0; i < 20; ++i)
  {
    small_world::step(small, small_world::frame);
    points = small.contacts.size();
    game.step();
  }
  return {
      "SIMD",
      "16 contacts at a time",
      "wall of 195 bricks",
      {false, std::to_string(points) + " turns"},
      {8 * *groups <= points, std::to_string(*groups) + " turns"},
      std::to_string((points + 15) / 16) + " turns"};
}

/// The deepest [m] that a cube of 20 cm gets into the ground at 5 m/s, from nine heights; a
/// twentieth of its edge is right.
Rung falling_cube()
{
  const auto verdict = [](double depth) {
    return Verdict{depth < 0.01, rounded(1000 * depth) + " mm deep"};
  };
  double small = 0, game = 0;
  for (int i = 2; i <= 10; ++i)
  {
    const Scene scene = cube_thrown_down(0.1 + 0.01 * i);
    small = std::max(small, deepest_in_run(small_of<Small>(scene), 1));
    game = std::max(game, run_world(scene, {.solver = "soft_steps", .duration = 1}).deepest);
  }
  return {"sweeps",       "speculative contacts", "cube of 20 cm, 5 m/s",
          verdict(small), verdict(game),          "touches"};
}

/// How many of five cubes come back from a thin wall.
Rung shot_cubes()
{
  std::size_t small = 0, game = 0;
  for (const double speed : shot_speeds)
  {
    const Scene scene = cube_at_wall(speed);
    small += small_world::comes_back(small_of<Small>(scene)) ? 1U : 0U;
    game += ends(scene, "soft_steps", 2).back().velocity.x() < 0 ? 1U : 0U;
  }
  return {
      "",
      "swept boxes",
      "cubes at a wall, to 1000 m/s",
      come_back(small),
      come_back(game),
      "5 of 5 come back"};
}

/// The speed with which the last of three spheres that touch leaves; within 1 % is right.
Rung row_of_spheres()
{
  const auto verdict = [](double speed) {
    return Verdict{std::abs(speed - 5) < 0.05, rounded(speed) + " m/s"};
  };
  const Scene scene = sphere_at_row();
  return {
      "",
      "simultaneous impacts",
      "5 m/s at three that touch, e = 1",
      verdict(small_ends(scene, 0.5).back().motion.velocity.x()),
      verdict(ends(scene, "soft_steps", 0.5).back().velocity.x()),
      "5 m/s"};
}

/// The pairs of AABBs that a tree compares: those of leaves that it meets.
std::size_t pairs_of_tree(const Scene& scene)
{
  std::vector<Bounds> bounds;
  for (const SceneBody& body : scene.bodies)
  {
    bounds.push_back({bounds_of(rigid_body(body), body.shape, 0), static_cast<int>(bounds.size())});
  }
  BoundsTree tree;
  tree.build(bounds);
  std::size_t count = tree.unbounded().size() * tree.leaves().size();
  overlaps_below(tree, 0, [&count](const Bounds&, const Bounds&) { ++count; });
  return count;
}

/// The pairs compared in a row of 400 cubes across the axis of the sweep; a tenth is right.
Rung row_across()
{
  const Scene scene = row_of_cubes(400);
  const std::size_t swept = small_world::pairs_compared(small_of<Small>(scene).bodies);
  const std::size_t tree = pairs_of_tree(scene);
  return {
      "queries",
      "AABB tree, queries",
      "400 cubes in a row along z",
      {false, std::to_string(swept) + " pairs"},
      {10 * tree <= swept, std::to_string(tree) + " pairs"},
      "400 touch"};
}

/// The speed of a cube without friction at the end of ten flush tiles; within 1 % is right.
Rung tiles()
{
  const auto verdict = [](double speed) {
    return Verdict{std::abs(speed - 3) < 0.03, rounded(speed) + " m/s"};
  };
  return {
      "",
      "no ghost contacts",
      "3 m/s over flush tiles, smooth",
      verdict(small_ends(scenes::tiles(), 2.8).back().motion.velocity.x()),
      verdict(ends(scenes::tiles(), "soft_steps", 2.8).back().velocity.x()),
      "3 m/s"};
}

/// What the number of the last of three cubes means once the second was taken out.
Rung ids()
{
  const Scene scene = scenes::tower(3);
  Small small = small_of<Small>(scene);
  small.bodies.erase(small.bodies.begin() + 2);
  GameWorld game(scene, solver_named("soft_steps"));
  game.remove(2);
  const auto verdict = [](bool same) {
    return Verdict{same, same ? "the same body" : "another body"};
  };
  const bool small_same =
      small.bodies.size() > 3 && small.bodies[3].motion.center == scene.bodies[3].position;
  const bool game_same = game.body(3).motion.center == scene.bodies[3].position;
  return {
      "",
      "ids, events",
      "body 3, once body 2 is erased",
      verdict(small_same),
      verdict(game_same),
      "the same body"};
}

/// A scene in both worlds for a time [s].
Agreement agreement(const std::string& what, const Scene& scene, double time, bool rests)
{
  const std::vector<small_world::RigidBody> small = small_ends(scene, time);
  const std::vector<BodyState> game = ends(scene, "soft_steps", time);
  Agreement both{what, time, rests, 0, 0};
  for (std::size_t i = 0; i < game.size(); ++i)
  {
    const SceneBody& body = scene.bodies[i];
    if (body.mass > 0)
    {
      both.moved = std::max(both.moved, (game[i].position - body.position).norm());
      both.separation =
          std::max(both.separation, (game[i].position - small[i].motion.center).norm());
    }
  }
  return both;
}

/// Of a taken header, the lines of each file of the book in it; those before the first as "".
std::map<std::string, std::size_t> lines_of_files(const std::string& header)
{
  const std::string command = std::string("sh '")
                                  .append(COOKBOOK_SOURCE_DIR)
                                  .append("/tools/cmake/take_recipe.sh' '")
                                  .append(COOKBOOK_SOURCE_DIR)
                                  .append("' recipes/")
                                  .append(header);
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  if (!pipe)
  {
    throw std::runtime_error("cannot run " + command);
  }
  std::map<std::string, std::size_t> lines;
  std::string file, line;
  for (int letter = std::fgetc(pipe.get()); letter != EOF; letter = std::fgetc(pipe.get()))
  {
    line += static_cast<char>(letter);
    if (letter == '\n')
    {
      file = line.rfind("// ---- ", 0) == 0 ? line : file;
      ++lines[file];
      line.clear();
    }
  }
  return lines;
}

} // namespace

bool calls(const std::string& header, const std::string& function)
{
  std::ifstream file(std::string(COOKBOOK_SOURCE_DIR).append("/recipes/").append(header));
  const std::string text(std::istreambuf_iterator<char>(file), {});
  return std::regex_search(text, std::regex("\\b" + function + "[<(]"));
}

std::size_t lines_to_take(const std::vector<std::string>& headers)
{
  std::map<std::string, std::size_t> all;
  for (const std::string& header : headers)
  {
    all.merge(lines_of_files(header));
  }
  std::size_t sum = 0;
  for (const auto& [file, lines] : all)
  {
    sum += lines;
  }
  return sum;
}

std::vector<Rung> branch_rungs()
{
  return {
      stack(
          "direct", "direct solver", "1000 kg on 1 kg, 20 s", scenes::heavy_on_light(1000),
          "direct"),
      load(),
      turns(),
      stack("anchors", "lagged anchors", "tower of 16, 20 s", scenes::tower(16), "soft_steps"),
      falling_cube(),
      shot_cubes(),
      row_of_spheres(),
      row_across(),
      tiles(),
      ids()};
}

std::vector<Agreement> agreements()
{
  return {
      agreement("tower of 3", scenes::tower(3), 5, true),
      agreement("pyramid of 15", scenes::pyramid(5), 5, true),
      agreement("10 kg on 1 kg", scenes::heavy_on_light(10), 5, true),
      agreement("table on four legs", scenes::table_on(4), 5, true),
      agreement("floor of 100", scenes::floor_of_cubes(100), 2, true),
      agreement("cube slides from 5 m/s", sliding_cube(), 3, false),
      agreement("cube on a slope of 30°, μ = 0.5", scenes::incline(0.5, 0.5), 2, false),
      agreement("sphere slides until it rolls", scenes::rolling(), 3, false),
      agreement("sphere thrown", thrown_sphere(), 2, false),
      agreement("dropped 1 m, e = 0.5, at the top", dropped_sphere(), 0.67, false)};
}

} // namespace cookbook
