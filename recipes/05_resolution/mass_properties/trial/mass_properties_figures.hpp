#pragma once

/// \file
/// \brief The figures of mass properties: an axe with its principal axes, and what simpler shapes
/// than a capsule's cost.

#include "05_resolution/mass_properties/trial/mass_properties_scenes.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace cookbook
{

/// The solids of an axe.
inline std::vector<PlacedSolid<double>> solids(const std::vector<AxePart>& parts)
{
  std::vector<PlacedSolid<double>> found;
  for (const AxePart& part : parts)
  {
    found.push_back(part.solid);
  }
  return found;
}

/// An axe seen from the front, with its centre of mass and two of its principal axes; the third
/// points at the reader.
inline plot::Figure2d axe_figure(const std::vector<AxePart>& parts)
{
  plot::Figure2d figure("mass_properties", "", {{-0.32, -0.46}, {0.42, 0.5}, 420});
  figure.describe("An axe: centre of mass and principal axes of handle and head together.");
  for (const AxePart& part : parts)
  {
    figure.box(
        part.solid.center.head<2>(), 0, part.half_extents.head<2>(),
        part.solid.center.x() > 0 ? plot::Ink::b : plot::Ink::a);
    figure.point(part.solid.center.head<2>(), plot::Ink::muted);
  }
  const PlacedSolid<double> whole = combined(solids(parts));
  const Eigen::Vector2d center = whole.center.head<2>();
  const Eigen::Vector2d first = whole.axes.col(0).head<2>(), second = whole.axes.col(1).head<2>();
  figure.arrow(center, center + 0.24 * first, plot::Ink::ink, "1")
      .arrow(center, center + 0.24 * second, plot::Ink::ink, "2")
      .point(center, plot::Ink::overlap, "c");
  return figure;
}

/// How much too large the moment across a capsule is, if a simpler shape of the same mass and
/// length stands for it, against the length of the segment in radii.
inline plot::Chart simpler_figure()
{
  plot::Chart chart(
      "mass_properties_simpler", "", {"length of the segment [radii]", plot::Scale::linear},
      {"moment across, too large by [%]", plot::Scale::linear});
  chart.describe("The error of a box and of a cylinder that stand for a capsule.");
  std::vector<Eigen::Vector2d> box, cylinder;
  for (int i = 0; i <= 40; ++i)
  {
    const double length = i / 4.0;
    const double right = solid_capsule(1.0, length, 1.0).moments.x();
    const double whole = length + 2;
    const double boxed = solid_box<double>(1, {1, whole / 2, 1}).moments.x();
    box.emplace_back(length, 100 * (boxed / right - 1));
    cylinder.emplace_back(length, 100 * ((whole * whole / 12 + 0.25) / right - 1));
  }
  const plot::Look boxed{plot::Ink::series1, plot::Marker::none, plot::Stroke::solid};
  const plot::Look round{plot::Ink::series2, plot::Marker::none, plot::Stroke::dashed};
  chart.line("box", box, boxed).line("cylinder", cylinder, round);
  return chart;
}

} // namespace cookbook
