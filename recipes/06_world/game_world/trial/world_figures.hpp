#pragma once

/// \file
/// \brief The same scenes under all solvers: what became of them, in a table and in pictures.

#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/scene_figures/trial/scene_figures.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// The solvers that are compared; six with a second number of substeps.
struct GallerySolver
{
  std::string title; ///< as in the figure
  std::string name;  ///< of the solver
  int substeps;      ///< 0: its own
};

/// Six ways to solve the same contacts, the recommended one last.
inline const std::vector<GallerySolver> gallery_solvers{
    {"cold impulses", "cold_impulses", 0},   {"warm impulses", "sequential_impulses", 0},
    {"position based", "position_based", 0}, {"soft, 4 substeps", "soft_steps", 4},
    {"soft, 16 substeps", "soft_steps", 16}, {"direct", "direct", 0}};

/// How far the farthest body of each scene is from where it was after some seconds [mm].
inline std::string standings_table()
{
  std::vector<std::string> header{"moved after 8 s [mm]"};
  for (const GallerySolver& solver : gallery_solvers)
  {
    header.push_back(solver.title);
  }
  Table table(header);
  for (const char* const scene : {"tower", "tower_20", "pyramid", "heavy_on_light_100", "plates"})
  {
    std::vector<std::string> row{scene};
    for (const GallerySolver& solver : gallery_solvers)
    {
      const WorldRun run = run_world(
          named_scene(scene), {.solver = solver.name, .substeps = solver.substeps, .duration = 8});
      const double moved = std::hypot(run.sink, run.drift) * 1e3;
      row.push_back(moved > 500 ? "falls" : number(std::round(moved * 1e3) / 1e3));
    }
    table.row(row);
  }
  return table.text();
}

/// Draws a tower under six solvers, and a run of the recommended one in time.
inline void draw_gallery(const Arguments& given)
{
  const Scene scene = named_scene("tower");
  std::vector<NamedFrame> ends;
  for (const GallerySolver& solver : gallery_solvers)
  {
    const WorldRun run =
        run_world(scene, {.solver = solver.name, .substeps = solver.substeps, .duration = 5});
    ends.push_back({solver.title, run.frames.back()});
  }
  const SceneView view{0, 0, {-4, -0.5}, {4, 11}, 200};
  save_figure(
      given, "game_world_gallery.svg",
      scene_gallery("game_world_gallery", scene, ends, view).svg());

  const Scene domino = named_scene("domino_12");
  const WorldRun fall = run_world(domino, {.duration = 3, .keeps_frames = true});
  save_figure(
      given, "game_world.svg",
      scene_strip(
          "game_world", domino, fall.frames, {0, 0.6, 1.2, 2.4}, view_of(domino, fall.frames, 300),
          2)
          .svg());
}

} // namespace cookbook
