#pragma once

/// \file
/// \brief The figures of separating_axes: fifteen overlaps, the two bars that have them, and which
/// kind of axis wins while a cube tips over.

#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "04_obb_manifolds/separating_axes/separating_axes.hpp"
#include "tools/plot/charts/bar_chart.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure3d.hpp"
#include "tools/program/table.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

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

/// The colour of an axis: that of the box whose face it belongs to.
inline plot::Ink axis_ink(int axis)
{
  const AxisKind kind = axis_kind(axis);
  return kind == AxisKind::face_of_a   ? plot::Ink::a
         : kind == AxisKind::face_of_b ? plot::Ink::b
                                       : plot::Ink::muted;
}

/// The overlap [m] of two boxes along each of the fifteen axes; nothing where edges are parallel.
inline std::array<std::optional<double>, box_axes>
axes_overlaps(const Obb<double>& a, const Obb<double>& b)
{
  const RelativeBoxes<double> boxes = relative_boxes(a, b);
  std::array<std::optional<double>, box_axes> overlaps;
  for (int axis = 0; axis < box_axes; ++axis)
  {
    const AxisOverlap<double> along = axis_overlap(boxes, axis);
    if (!from_parallel_edges(along))
    {
      overlaps[static_cast<std::size_t>(axis)] = along.overlap / std::sqrt(along.squared_length);
    }
  }
  return overlaps;
}

/// The overlap of the two bars along all fifteen axes, the least marked.
inline plot::BarChart axes_chart()
{
  const int least = separating_axes(ridge_a, ridge_b)->axis;
  plot::BarChart chart("separating_axes", "", {"overlap along the axis [m]"});
  chart.describe("The overlap of two boxes along all fifteen axes; a pair of edges has the least.")
      .width(400);
  const std::array<std::optional<double>, box_axes> overlaps = axes_overlaps(ridge_a, ridge_b);
  for (int axis = 0; axis < box_axes; ++axis)
  {
    if (const std::optional<double> overlap = overlaps[static_cast<std::size_t>(axis)])
    {
      axis == least ? chart.highlight(axis_name(axis), *overlap)
                    : chart.bar(axis_name(axis), *overlap, axis_ink(axis));
    }
  }
  return chart;
}

/// The two bars: the edges that meet thick, the overlap between them, and the normal.
inline plot::Figure3d ridges_figure()
{
  const LeastOverlap<double> least = separating_axes(ridge_a, ridge_b).value();
  const double ridge = 0.6 * std::sqrt(2.0);
  const Vector3<double> top(0, ridge, 0), along_a(1.2, 0, 0);
  const Vector3<double> bottom = ridge_b.center - top, along_b = 1.2 * ridge_b.axes.col(2);
  // Seen from above, B's edge crosses A's where z = 0.
  const Vector3<double> crossing = bottom - bottom.z() / along_b.z() * along_b;
  plot::Figure3d figure("separating_axes_boxes", "", {0.5, 0.3, 400, 320});
  figure.describe("Two crossed bars, ridge into ridge, with the normal and the depth.")
      .box(ridge_a.center, ridge_a.axes, ridge_a.half_extents, plot::Ink::a)
      .box(ridge_b.center, ridge_b.axes, ridge_b.half_extents, plot::Ink::b)
      .label(
          ridge_a.center - Vector3<double>(0.2, 0.6, -0.3), "A", plot::Side::centre, plot::Ink::a)
      .label(ridge_b.center + Vector3<double>(0.55, 0.6, 0), "B", plot::Side::centre, plot::Ink::b)
      .segment(top - along_a, top + along_a, plot::Ink::a, plot::Stroke::solid, 4)
      .segment(bottom - along_b, bottom + along_b, plot::Ink::b, plot::Stroke::solid, 4)
      .dimension(crossing + least.depth * least.normal, crossing, "depth " + number(least.depth))
      .arrow(top - along_a, top - along_a + 0.8 * least.normal, plot::Ink::ink, "n");
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

/// The least overlap along each kind of axis while the cube tips over, and where the kind that wins
/// changes.
inline plot::Chart tilt_chart()
{
  const Obb<double> standing = upright({0, 0, 0}, {1, 1, 1});
  plot::Chart chart(
      "separating_axes_tilt", "", {"tilted by [°]", {}, 0, 60}, {"least overlap [m]", {}, 0.6, 1});
  chart.size(400, 320);
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

/// The cubes at three tilts, one for each kind of axis that wins, and the chart below them.
inline plot::Grid tilt_grid()
{
  plot::Grid scenes("scenes", "", 3);
  const std::pair<int, std::string> winners[] = {{5, "A's face"}, {17, "B's face"}, {45, "edges"}};
  for (const auto& [tilt, kind] : winners)
  {
    const Obb<double> standing = upright({0, 0, 0}, {1, 1, 1});
    const Obb<double> tipped = tipped_cube(eighth_turn * tilt / 45);
    const Vector3<double> normal = separating_axes(standing, tipped)->normal;
    plot::Figure3d figure("cubes", std::to_string(tilt) + "°: " + kind, {-0.5, 0.35, 118, 130, 6});
    figure.box(standing.center, standing.axes, standing.half_extents, plot::Ink::a)
        .box(tipped.center, tipped.axes, tipped.half_extents, plot::Ink::b)
        .arrow(tipped.center, tipped.center + normal, plot::Ink::ink, "n");
    scenes.add(figure);
  }
  plot::Grid grid("separating_axes_tilt", "", 1);
  grid.describe("A face of A, a face of B and a pair of edges have the least overlap in turn.");
  return grid.add(scenes).add(tilt_chart());
}

} // namespace cookbook
