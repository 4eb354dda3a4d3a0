/// \file
/// \brief Runs each step of the small world on the scene that it holds and the step before fails.

#include "05_resolution/small_world/trial/small_world_figures.hpp"
#include "05_resolution/small_world/trial/step_loop.hpp"
#include "05_resolution/small_world/trial/step_rungs.hpp"
#include "tools/program/program.hpp"

#include <iostream>

namespace
{

using namespace cookbook;
using namespace cookbook::small_world;

void print_steps()
{
  std::cout << text_table(
      rungs_table({"step", "adds", "scene", "step before", "this step", "right"}, step_rungs()));
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
