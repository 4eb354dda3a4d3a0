/// \file
/// \brief Runs scenes in a world with any solver, and keeps what happens as pictures and as CSV.

#include "06_world/game_world/solver_names.hpp"
#include "06_world/game_world/trial/impact_figures.hpp"
#include "06_world/game_world/trial/impacts.hpp"
#include "06_world/game_world/trial/world_cases.hpp"
#include "06_world/game_world/trial/world_figures.hpp"
#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/game_world/trial/world_tables.hpp"
#include "06_world/scene_figures/trial/scene_figures.hpp"
#include "06_world/scenes/trial/frames_file.hpp"
#include "06_world/scenes/trial/scene_file.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"
#include "tools/files/whole_file.hpp"
#include "tools/program/number_option.hpp"
#include "tools/program/program.hpp"

#include <filesystem>
#include <iostream>

namespace
{

using namespace cookbook;

/// The scene that the reader asked for.
Scene scene_of(const Arguments& given)
{
  const std::string& file = given.value("scene-file");
  return file.empty() ? named_scene(given.value("scene")) : read_scene(std::filesystem::path(file));
}

void save_frames(const Arguments& given, const Scene& scene, const std::vector<Frame>& frames)
{
  const std::string& file = given.value("frames");
  if (!file.empty())
  {
    save_whole(file, [&](std::ostream& stream) { write_frames(stream, scene, frames); });
    std::cerr << "frames: " << file << "\n";
  }
}

void run_scene(const Arguments& given)
{
  const Scene scene = scene_of(given);
  const RunSettings settings{
      .solver = given.value("solver"),
      .substeps = number_option<int>(given, "substeps", 0, 10'000),
      .duration = given.value("duration").empty()
                      ? scene.duration
                      : number_option<double>(given, "duration", 0, 1e6),
      .may_sleep = given.value("sleep") == "yes",
      .keeps_frames = true};
  Progress progress("steps of " + scene.name, steps_of(scene, settings.duration));
  const WorldRun run = run_world(scene, settings, [&](std::size_t done) { progress.at(done); });
  std::cout << measures(run, settings);
  save_frames(given, scene, run.frames);
  const SceneView view = view_of(scene, run.frames);
  save_figure(
      given, "world_run.svg",
      scene_animation("world_run", scene.name, scene, run.frames, view).svg());
}

void run(const Arguments& given)
{
  if (given.value("scene").empty() && given.value("scene-file").empty())
  {
    std::cout << standings_table();
    save_figure(
        given, "game_world_cases.html",
        verdict_table(
            "The world at 60 frames a second under each solver, nothing asleep.", solver_names(),
            world_verdicts()));
    save_figure(given, "game_world_one_step.svg", impact_figure().svg());
    save_figure(given, "game_world_impacts.svg", impacts_chart().svg());
    return draw_gallery(given);
  }
  run_scene(given);
}

} // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> scene{"scene", "scene-file"};
  const Arguments arguments{
      .name = "game_world",
      .summary = "Runs a scene in a world with any solver: overlap, drift, energy, time. Without "
                 "--scene or --scene-file, five scenes with all solvers.",
      .options = {
          {"scene", "one of\n" + scene_list(), "", {}, {}, {"scene-file"}},
          {"scene-file", "a JSON file with your own scene", "", {}, {}, {}, FileUse::read},
          {"solver", "how contacts are solved", "direct", solver_names(), scene},
          {"substeps", "small steps in a frame; 0: what the solver takes itself", "0", {}, scene},
          {"duration", "how long to run [s]; the scene's own if left out", "", {}, scene},
          {"sleep", "whether bodies that rest are left out", "no", {"no", "yes"}, scene},
          {"frames",
           "a CSV file for every body in every step",
           "",
           {},
           scene,
           {},
           FileUse::written}}};
  return run_program(argc, argv, arguments, run);
}
