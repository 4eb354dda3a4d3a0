/// \file
/// \brief Runs each step of the small world on the scene that it holds and the step before fails.

#include "05_resolution/small_world/trial/small_world_figures.hpp"
#include "05_resolution/small_world/trial/step_loop.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;
using namespace cookbook::small;

/// What a stack of cubes does in a time [s]: its sink in mm, or that it falls.
template <class World>
std::string sink_of(const World& world, double time)
{
  const double sink = largest_sink(world, time);
  return stands(sink) ? "sinks " + rounded(1000 * sink) + " mm" : "falls";
}

/// How many of five shots, at 10 to 1000 m/s, come back from a wall.
template <class World>
std::string shots_back()
{
  int count = 0;
  for (const double speed : {10.0, 30.0, 100.0, 300.0, 1000.0})
  {
    count += comes_back(shot_at_wall<World>(speed)) ? 1 : 0;
  }
  return std::to_string(count) + " of 5 come back";
}

/// How many contact points a world of 400 cubes solves in its 120th frame.
template <class World>
std::string points_solved()
{
  World world = floor_of_cubes<World>(20);
  run(world, 2);
  return std::to_string(world.contacts.size()) + " points";
}

/// How many pairs every body against every other makes in a world of 400 cubes.
std::string all_pairs()
{
  const std::size_t count = floor_of_cubes<step_4::World>(20).bodies.size();
  return std::to_string(count * (count - 1) / 2) + " pairs";
}

/// How high a sphere comes back that is dropped from 1 m with a restitution of 0.5.
template <class World>
std::string bounce()
{
  const double height = height_of_bounce(dropped_sphere<World>(1, 0.5), 1.2);
  return number(std::round(1e3 * height) * 1e-3) + " m";
}

void print_steps()
{
  const std::string swept =
      std::to_string(pairs_compared(floor_of_cubes<step_4::World>(20).bodies)) + " pairs";
  Table table({"step", "adds", "scene", "step before", "this step", "right"});
  table.row(
      {"1", "impulses, friction", "tower of 5, 20 s", "", sink_of(tower<step_1::World>(5), 20),
       "stands"});
  table.row(
      {"2", "warm starting", "pyramid of 55, 20 s", sink_of(pyramid<step_1::World>(10), 20),
       sink_of(pyramid<step_2::World>(10), 20), "stands"});
  table.row(
      {"3", "soft steps", "tower of 10, 40 s", sink_of(tower<step_2::World>(10), 40),
       sink_of(tower<step_3::World>(10), 40), "stands"});
  table.row({"4", "broad phase", "400 cubes", all_pairs(), swept, "400 touch"});
  table.row(
      {"5", "restitution", "dropped 1 m, e = 0.5", bounce<step_4::World>(), bounce<step_5::World>(),
       "0.25 m"});
  table.row(
      {"6", "sleeping", "400 cubes, after 2 s", points_solved<step_5::World>(),
       points_solved<step_6::World>(), "0 points"});
  table.row(
      {"7", "swept spheres", "wall, 10 to 1000 m/s", shots_back<step_6::World>(),
       shots_back<step_7::World>(), "5 of 5 come back"});
  std::cout << table.text();
}

} // namespace

int main(int argc, char** argv)
{
  return run_program(
      argc, argv,
      {.name = "small_world",
       .summary = "Runs each step of the small world on the scene that the step before fails."},
      [](const Arguments& given)
      {
        print_steps();
        save_figure(given, "small_world_loop.svg", loop_figure().svg());
        save_figure(given, "small_world_step_1.svg", first_figure().svg());
        save_figure(given, "small_world_step_2.svg", pyramids_figure().svg());
        save_figure(given, "small_world_step_3.svg", towers_figure().svg());
        save_figure(given, "small_world_step_4.svg", pairs_figure().svg());
        save_figure(given, "small_world_step_5.svg", bounces_figure().svg());
        save_figure(given, "small_world_step_6.svg", points_figure().svg());
        save_figure(given, "small_world_step_7.svg", shots_figure().svg());
      });
}
