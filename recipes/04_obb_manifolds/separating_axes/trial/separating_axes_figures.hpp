#pragma once

/// \file
/// \brief The figures of separating_axes: shadows on an axis, fifteen overlaps, the two bars that
/// have them, and which kind of axis wins while a cube tips over.

#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "04_obb_manifolds/separating_axes/separating_axes.hpp"
#include "common/plot/charts/bar_chart.hpp"
#include "common/plot/charts/chart.hpp"
#include "common/plot/figures/figure2d.hpp"
#include "common/plot/figures/figure3d.hpp"
#include "common/program/table.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <vector>

namespace cookbook
{

/// Draws a box in the plane and its shadow on a line along x at a height, and returns r; O2.
inline double draw_shadow(
    plot::Figure2d& figure, const Eigen::Vector2d& center, double angle,
    const Eigen::Vector2d& half_extents, plot::Ink ink, const std::string& name, double height)
{
  const Eigen::Vector2d u = half_extents.x() * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d v = half_extents.y() * Eigen::Vector2d(-std::sin(angle), std::cos(angle));
  const Eigen::Vector2d reach = u + (v.x() < 0 ? Eigen::Vector2d(-v) : v);
  const Eigen::Vector2d along(reach.x(), 0);
  const Eigen::Vector2d below(center.x(), height);
  figure.box(center, angle, half_extents, ink)
      .segment(center + reach, below + along, ink, plot::Stroke::dotted, 1.2)
      .segment(center - reach, below - along, ink, plot::Stroke::dotted, 1.2)
      .segment(center, below - Eigen::Vector2d(0, 1.3), plot::Ink::muted, plot::Stroke::dotted, 1.2)
      .segment(below - along, below + along, ink, plot::Stroke::solid, 5)
      .dot(center, ink, name, plot::Side::above)
      .dot(below, ink);
  return reach.x();
}

/// Two boxes in the plane, the centres a distance t apart along L, and their shadows; O2, O6.
inline plot::Figure2d shadows_figure(const Eigen::Vector2d& t, const std::string& title)
{
  const double axis = -1.5, from_b = axis - 0.1; // heights of the shadows of A and B
  plot::Figure2d figure("shadows", title, {{-1.2, -3}, {3.7, 1}, 400});
  figure.segment({-1.2, axis - 0.05}, {3.4, axis - 0.05}, plot::Ink::muted, plot::Stroke::solid, 1)
      .arrow({3.1, axis - 0.05}, {3.45, axis - 0.05}, plot::Ink::ink, "L");
  const double a = draw_shadow(figure, {0, 0}, -0.35, {1, 0.6}, plot::Ink::a, "A", axis);
  const double b = draw_shadow(figure, t, 0.5, {0.7, 0.5}, plot::Ink::b, "B", from_b);
  const bool apart = a + b < t.x();
  return figure
      .dimension(
          {std::min(a, t.x() - b), axis + 0.25}, {std::max(a, t.x() - b), axis + 0.25},
          apart ? "gap s(L)" : "overlap −s(L)")
      .dimension({0, axis - 0.45}, {a, axis - 0.45}, "r_{A}", 0, plot::Ink::a)
      .dimension({t.x() - b, from_b - 0.7}, {t.x(), from_b - 0.7}, "r_{B}", 0, plot::Ink::b)
      .dimension({0, axis - 1.3}, {t.x(), axis - 1.3}, "|t · L|", 0, plot::Ink::ink);
}

/// The shadows of two boxes on one axis: with a gap, and overlapping.
inline plot::Grid shadows_grid()
{
  plot::Grid grid("separating_axes_shadows", "", 1);
  grid.describe("The shadows of two boxes on an axis: a gap proves that they are apart.")
      .add(shadows_figure({2.25, 0.1}, "A gap: the boxes are apart"))
      .add(shadows_figure({1.4, 0.15}, "No gap: the shadows overlap"));
  return grid;
}

/// 45° [rad].
inline constexpr double eighth_turn = std::numbers::pi / 4;

/// Two bars with a ridge each: one seen along x, the other turned away from z.
inline const Obb<double> ridge_a{{0, 0, 0}, turned(eighth_turn, {1, 0, 0}), {1.2, 0.6, 0.6}};
inline const Obb<double> ridge_b{
    {0.2, 1.4, 0.1}, turned(-0.3, {0, 1, 0}) * turned(eighth_turn, {0, 0, 1}), {0.6, 0.6, 1.2}};

/// The name of an axis: `a0`, `b1` or `a0 × b1`.
inline std::string axis_name(int axis)
{
  const auto name = [](const char* box, int i) { return box + std::to_string(i); };
  switch (axis_kind(axis))
  {
  case AxisKind::face_of_a:
    return name("a", axis);
  case AxisKind::face_of_b:
    return name("b", axis - 3);
  default:
    return name("a", (axis - 6) / 3) + " × " + name("b", (axis - 6) % 3);
  }
}

/// The overlap of the two bars along all fifteen axes, the least marked.
inline plot::BarChart axes_chart()
{
  const RelativeBoxes<double> boxes = relative_boxes(ridge_a, ridge_b);
  const int least = separating_axes(ridge_a, ridge_b)->axis;
  plot::BarChart chart("separating_axes", "", {"overlap along the axis [m]"});
  chart.describe("The overlap of two boxes along all fifteen axes; a pair of edges has the least.");
  for (int axis = 0; axis < box_axes; ++axis)
  {
    const AxisOverlap<double> along = axis_overlap(boxes, axis);
    if (from_parallel_edges(along))
    {
      continue;
    }
    const double overlap = along.overlap / std::sqrt(along.squared_length);
    const plot::Ink ink = axis_kind(axis) == AxisKind::face_of_a   ? plot::Ink::a
                          : axis_kind(axis) == AxisKind::face_of_b ? plot::Ink::b
                                                                   : plot::Ink::muted;
    axis == least ? chart.highlight(axis_name(axis), overlap)
                  : chart.bar(axis_name(axis), overlap, ink);
  }
  return chart;
}

/// The two bars, with the way they part soonest.
inline plot::Figure3d ridges_figure()
{
  const LeastOverlap<double> least = separating_axes(ridge_a, ridge_b).value();
  const Vector3<double> top = Vector3<double>(0, 0.6 * std::sqrt(2.0), 0);
  const Vector3<double> beside(1.2, 0, 0);
  plot::Figure3d figure("separating_axes_boxes", "", {0.5, 0.3, 560, 420});
  figure.describe("Two crossed bars, ridge into ridge, with the normal and the depth.")
      .box(ridge_a.center, ridge_a.axes, ridge_a.half_extents, plot::Ink::a)
      .box(ridge_b.center, ridge_b.axes, ridge_b.half_extents, plot::Ink::b)
      .label(
          ridge_a.center + Vector3<double>(-0.2, -0.6, 0.3), "A", plot::Side::centre, plot::Ink::a)
      .label(ridge_b.center + Vector3<double>(0.55, 0.6, 0), "B", plot::Side::centre, plot::Ink::b)
      .dimension(
          top + beside - least.depth * least.normal, top + beside, "depth " + number(least.depth))
      .arrow(top, top + 0.8 * least.normal, plot::Ink::ink, "normal");
  return figure;
}

/// The least overlap of two boxes along each kind of axis: A's faces, B's faces, pairs of edges.
inline std::array<double, 3> least_of_each_kind(const Obb<double>& a, const Obb<double>& b)
{
  const RelativeBoxes<double> boxes = relative_boxes(a, b);
  std::array<double, 3> least;
  least.fill(std::numeric_limits<double>::max());
  for (int axis = 0; axis < box_axes; ++axis)
  {
    const AxisOverlap<double> along = axis_overlap(boxes, axis);
    if (!from_parallel_edges(along))
    {
      double& of_kind = least[static_cast<std::size_t>(axis_kind(axis))];
      of_kind = std::min(of_kind, along.overlap / std::sqrt(along.squared_length));
    }
  }
  return least;
}

/// A cube beside another, both 2 m wide, yawed and then tipped by an angle [rad].
inline Obb<double> tipped_cube(double angle)
{
  const Matrix3<double> yawed = turned(eighth_turn * 4 / 9, {0, 1, 0});
  return {{1.6, 1.2, 0.4}, turned(angle, {1, 0, -1}) * yawed, {1, 1, 1}};
}

/// The least overlap along each kind of axis while a cube beside another tips over, and where the
/// kind that wins changes.
inline plot::Chart tilt_chart()
{
  const Obb<double> standing = upright({0, 0, 0}, {1, 1, 1});
  plot::Chart chart(
      "separating_axes_tilt", "", {"tilted by [°]", {}, 0, 60}, {"least overlap [m]", {}, 0.6, 1});
  chart.describe("A face of A, a face of B and a pair of edges have the least overlap in turn.");
  std::array<std::vector<Eigen::Vector2d>, 3> lines;
  AxisKind before = AxisKind::face_of_a;
  for (int tilt = 0; tilt <= 60; ++tilt)
  {
    const Obb<double> tipped = tipped_cube(eighth_turn * tilt / 45);
    const std::array<double, 3> least = least_of_each_kind(standing, tipped);
    for (std::size_t kind = 0; kind < 3; ++kind)
    {
      lines[kind].push_back({double(tilt), least[kind]});
    }
    const AxisKind now = axis_kind(separating_axes(standing, tipped)->axis);
    if (now != before)
    {
      chart.reference_x(tilt, now == AxisKind::edges ? "edges" : "B's face");
    }
    before = now;
  }
  return chart.line("A's faces", lines[0], {plot::Ink::a, plot::Marker::none, plot::Stroke::solid})
      .line("B's faces", lines[1], {plot::Ink::b, plot::Marker::none, plot::Stroke::dashed})
      .line("edges", lines[2], {plot::Ink::ink, plot::Marker::none, plot::Stroke::dotted});
}

} // namespace cookbook
