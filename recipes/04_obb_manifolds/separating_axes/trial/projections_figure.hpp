#pragma once

/// \file
/// \brief A picture of the mechanism of separating_axes: the projections of two boxes on an axis.

#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/panel.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace cookbook
{

/// Draws a box in the plane and its projection on a line along x at a height, and returns r; O2.
inline double draw_projection(
    plot::Figure2d& figure, const Eigen::Vector2d& center, double angle,
    const Eigen::Vector2d& half_extents, plot::Ink ink, const std::string& name, double height)
{
  const Eigen::Vector2d u = half_extents.x() * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d v = half_extents.y() * Eigen::Vector2d(-std::sin(angle), std::cos(angle));
  const Eigen::Vector2d radius = u + (v.x() < 0 ? Eigen::Vector2d(-v) : v);
  const Eigen::Vector2d along(radius.x(), 0);
  const Eigen::Vector2d below(center.x(), height);
  figure.box(center, angle, half_extents, ink)
      .segment(center + radius, below + along, ink, plot::Stroke::dotted, 1.2)
      .segment(center - radius, below - along, ink, plot::Stroke::dotted, 1.2)
      .segment(center, below - Eigen::Vector2d(0, 1.3), plot::Ink::muted, plot::Stroke::dotted, 1.2)
      .segment(below - along, below + along, ink, plot::Stroke::solid, 5)
      .dot(center, ink, name, plot::Side::above)
      .dot(below, ink);
  return radius.x();
}

/// Two boxes in the plane, the centres a distance t apart along L, and their projections; O2, O6.
inline plot::Figure2d projections_figure(const Eigen::Vector2d& t, const std::string& title)
{
  const double axis = -1.5, from_b = axis - 0.1; // heights of the projections of A and B
  plot::Figure2d figure("projections", title, {{-1.2, -3}, {3.7, 1}, 400});
  figure.segment({-1.2, axis - 0.05}, {3.4, axis - 0.05}, plot::Ink::muted, plot::Stroke::solid, 1)
      .arrow({3.1, axis - 0.05}, {3.45, axis - 0.05}, plot::Ink::ink, "L");
  const double a = draw_projection(figure, {0, 0}, -0.35, {1, 0.6}, plot::Ink::a, "A", axis);
  const double b = draw_projection(figure, t, 0.5, {0.7, 0.5}, plot::Ink::b, "B", from_b);
  const bool apart = a + b < t.x();
  return figure
      .dimension(
          {std::min(a, t.x() - b), axis + 0.25}, {std::max(a, t.x() - b), axis + 0.25},
          apart ? "gap s(L)" : "overlap −s(L)")
      .dimension({0, axis - 0.45}, {a, axis - 0.45}, "r_{A}", 0, plot::Ink::a)
      .dimension({t.x() - b, from_b - 0.7}, {t.x(), from_b - 0.7}, "r_{B}", 0, plot::Ink::b)
      .dimension({0, axis - 1.3}, {t.x(), axis - 1.3}, "|t · L|", 0, plot::Ink::ink);
}

/// The projections of two boxes on one axis: with a gap, and overlapping.
inline plot::Grid projections_grid()
{
  plot::Grid grid("separating_axes_projections", "", 1);
  grid.describe("The projections of two boxes on an axis: a gap proves that they are apart.")
      .add(projections_figure({2.25, 0.1}, "A gap: the boxes are apart"))
      .add(projections_figure({1.4, 0.15}, "No gap: the projections overlap"));
  return grid;
}

} // namespace cookbook
