/// \file
/// \brief Runs scenes in a world with any solver, and keeps what happens as pictures and as CSV.

#include "05_resolution/frames_file.hpp"
#include "05_resolution/number_option.hpp"
#include "05_resolution/scene_figures.hpp"
#include "05_resolution/scene_file.hpp"
#include "05_resolution/solver_names.hpp"
#include "05_resolution/world_cases.hpp"
#include "05_resolution/world_figures.hpp"
#include "05_resolution/world_runs.hpp"
#include "05_resolution/world_scenes.hpp"
#include "05_resolution/world_tables.hpp"
#include "common/program/program.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace
{

using namespace cookbook;

/// The scene that the reader asked for.
Scene scene_of(const Arguments& given)
{
  const std::string& file = given.value("scene-file");
  if (!file.empty() && !given.value("scene").empty())
  {
    throw std::invalid_argument("--scene and --scene-file name two scenes; give one of them");
  }
  return file.empty() ? named_scene(given.value("scene")) : read_scene(std::filesystem::path(file));
}

void save_frames(const Arguments& given, const Scene& scene, const std::vector<Frame>& frames)
{
  const std::string& file = given.value("frames");
  if (file.empty())
  {
    return;
  }
  std::ofstream stream(file);
  write_frames(stream, scene, frames);
  stream.close();
  if (!stream)
  {
    throw std::runtime_error("cannot write " + file);
  }
  std::cerr << "frames: " << file << "\n";
}

// [run_scene]
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
// [run_scene]

void run(const Arguments& given)
{
  if (given.value("scene").empty() && given.value("scene-file").empty())
  {
    std::cout << standings_table();
    save_figure(
        given, "world_cases.html",
        verdict_table(
            "The world at 60 frames a second under each solver, nothing asleep.", solver_names(),
            world_verdicts()));
    return draw_gallery(given);
  }
  run_scene(given);
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "world",
      .summary = "Runs a scene in a world with any solver: overlap, drift, energy, time. Without "
                 "--scene or --scene-file, five scenes with all solvers.",
      .options = {
          {"scene", "one of\n" + scene_list(), "", {}},
          {"scene-file", "a JSON file with your own scene, instead of --scene", "", {}},
          {"solver", "how contacts are solved", "direct", solver_names()},
          {"substeps", "small steps in a frame; 0: what the solver takes itself", "0", {}},
          {"duration", "how long to run [s]; the scene's own if left out", "", {}},
          {"sleep", "whether bodies that rest are left out", "no", {"no", "yes"}},
          {"frames", "a CSV file for every body in every step", "", {}}}};
  return run_program(argc, argv, arguments, run);
}
