/// \file
/// \brief Finds the least overlap of named pairs of boxes, and draws it for two crossed ridges.

#include "04_obb_manifolds/separating_axes.hpp"
#include "03_sphere_manifolds/pairs_file.hpp"
#include "04_obb_manifolds/box_cases.hpp"
#include "common/plot/bar_chart.hpp"
#include "common/plot/figure3d.hpp"
#include "common/program/program.hpp"
#include "common/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

/// Two bars with a ridge each: one seen along x, the other turned away from z.
const double eighth_turn = std::atan(1.0);
const Obb<double> ridge_a{{0, 0, 0}, turned(eighth_turn, {1, 0, 0}), {1.2, 0.6, 0.6}};
const Obb<double> ridge_b{
    {0.2, 1.4, 0.1}, turned(-0.3, {0, 1, 0}) * turned(eighth_turn, {0, 0, 1}), {0.6, 0.6, 1.2}};

/// The name of an axis: `a0`, `b1` or `a0 × b1`.
std::string axis_name(int axis)
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

// [print_cases]
void print_cases()
{
  Table table({"boxes", "depth", "axis", "normal x", "y", "z"});
  const auto add = [&](const std::string& scene, const Obb<double>& a, const Obb<double>& b)
  {
    const std::optional<LeastOverlap<double>> least = separating_axes(a, b);
    if (!least)
    {
      table.row({scene, "apart", "", "", "", ""});
      return;
    }
    const auto cell = [](double x) { return number(std::round(x * 1e6) * 1e-6); };
    table.row(
        {scene, cell(least->depth), axis_name(least->axis), cell(least->normal.x()),
         cell(least->normal.y()), cell(least->normal.z())});
  };
  add("two ridges, one askew", ridge_a, ridge_b);
  for (const BoxCase& pair : box_cases())
  {
    add(pair.scene, pair.a, pair.b);
  }
  std::cout << table.text();
}
// [print_cases]

void draw_axes(const Arguments& arguments)
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
  save_figure(arguments, "separating_axes.svg", chart.svg());
}

void draw_boxes(const Arguments& arguments)
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
  save_figure(arguments, "separating_axes_boxes.svg", figure.svg());
}

/// The least overlap as a manifold without points.
template <class Real>
std::optional<Manifold<Real>> of_row(const PairsRow& row, Real)
{
  const auto least = separating_axes(obb_at<Real>(row, 0), obb_at<Real>(row, 10));
  return least ? std::optional(Manifold<Real>{least->normal, least->depth, {}}) : std::nullopt;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "separating_axes",
      .summary = "The separating-axis test of two boxes: normal and depth, no points.",
      .pairs_header = "ax,ay,az,aqw,aqx,aqy,aqz,ahx,ahy,ahz,bx,by,bz,bqw,bqx,bqy,bqz,bhx,bhy,bhz",
      .options = {scalar_option()}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        if (!given.pairs.empty())
        {
          return print_pairs(
              given, [](const PairsRow& row, auto real) { return of_row(row, real); });
        }
        print_cases();
        draw_axes(given);
        draw_boxes(given);
      });
}
