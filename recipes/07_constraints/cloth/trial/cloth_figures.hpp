#pragma once

/// \file
/// \brief The figures of the cloths: a curtain, a flag, cloths on things, stretch against the work.

#include "07_constraints/cloth/trial/cloth_scenes.hpp"
#include "07_constraints/cloth/trial/shaded_cloth.hpp"
#include "tools/plot/charts/chart.hpp"

#include <string>
#include <vector>

namespace cookbook
{

/// The curtain, drawn aside and at rest.
inline std::string curtain_picture()
{
  Curtain made = curtain();
  StepSettings settings;
  settings.substeps = 10;
  settings.damping = 2;
  run_cloth(made.cloth, 60, settings);
  made.stop_tie();
  run_cloth(made.cloth, 180, settings);
  return ShadedCloth(
             made.cloth, {.capsules = {{{{-0.76, 0.03, 0}, {0.76, 0.03, 0}}, 0.012}}},
             {.yaw = 0.15,
              .pitch = 0.1,
              .center = {-0.06, -0.8, 0},
              .meters = 2.0,
              .width = 480,
              .height = 420,
              .description = "A curtain in pleats, drawn aside by a tie, its folds shaded."})
      .svg("cloth");
}

/// The flag after some frames of wind.
inline ShadedCloth flag_picture(int frames, const Air& air, const std::string& title)
{
  Cloth cloth = flag();
  StepSettings settings;
  settings.substeps = 10;
  run_cloth(cloth, frames, settings, {}, air);
  return ShadedCloth(
      cloth, {.capsules = {{{{0, 0.1, 0}, {0, -1.6, 0}}, 0.012}}},
      {.yaw = 0.6,
       .pitch = 0.15,
       .center = {0.62, -0.6, 0},
       .meters = 1.75,
       .width = 310,
       .height = 290,
       .light = {0.6, 0.5, 0.45},
       .title = title});
}

/// The flag in a breeze and in a wind.
inline plot::Grid flag_picture()
{
  return plot::Grid("cloth_flag", "", 2)
      .describe("A flag in a breeze of 3 m/s, which hangs, and in a wind of 8 m/s, which flies.")
      .add(flag_picture(150, {.wind = {3, 0, 0.6}}, "3 m/s"))
      .add(flag_picture(170, {.wind = {8, 0, 1.6}}, "8 m/s"));
}

/// A square that has fallen on something.
inline ShadedCloth draped(const Obstacles& on, const std::string& title)
{
  Cloth cloth = falling_square();
  StepSettings settings;
  settings.substeps = 10;
  settings.damping = 1;
  run_cloth(cloth, 300, settings, on);
  return ShadedCloth(
      cloth, on,
      {.yaw = 0.5,
       .pitch = 0.4,
       .center = {0, -0.05, 0},
       .meters = 1.75,
       .width = 310,
       .height = 270,
       .title = title});
}

/// Cloths on a sphere and on a box.
inline plot::Grid drape_picture()
{
  const Matrix3<double> upright = Matrix3<double>::Identity();
  return plot::Grid("cloth_drape", "", 2)
      .describe("A square of cloth that rests on a sphere, and one on a box.")
      .add(draped({.spheres = {{{0, 0, 0}, 0.4}}}, "on a sphere"))
      .add(draped({.boxes = {{{0, 0.05, 0}, upright, {0.35, 0.3, 0.35}}}}, "on a box"));
}

/// How much longer the longest thread of the held square is, by substeps and iterations.
inline Cloth sagged(int substeps, int iterations)
{
  Cloth cloth = held_square();
  StepSettings settings;
  settings.damping = 4;
  settings.substeps = substeps;
  settings.iterations = iterations;
  run_cloth(cloth, 240, settings, {}, {.density = 0});
  return cloth;
}

/// Stretch against the work of a frame.
inline plot::Chart stretch_chart()
{
  plot::Chart chart(
      "cloth_stretch", "", {"passes over the cloth a frame", plot::Scale::log, 0.8, 40},
      {"longest thread, too long by", plot::Scale::log, 5e-3, 2});
  chart.describe("Passes a frame against the stretch of a square that hangs at its corners.");
  std::vector<Eigen::Vector2d> iterations, substeps;
  for (const int count : {1, 3, 10, 30})
  {
    iterations.push_back({static_cast<double>(count), worst_thread(sagged(1, count))});
    substeps.push_back({static_cast<double>(count), worst_thread(sagged(count, 1))});
  }
  return chart.line("iterations", iterations).line("substeps", substeps).size(560, 380);
}

} // namespace cookbook
