/// \file
/// \brief Bounds points by circles and a rectangle, and draws them.

#include "02_primitives/bounding_circle/bounding_circle.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>
#include <vector>

namespace
{

using namespace cookbook;
using plot::Ink;
using plot::Side;

const std::vector<Vector<double, 2>> points{{0.25, 0.5}, {4, 0},       {0, 3},    {0.5, 1.5},
                                            {1, 0.75},   {0.75, 2.25}, {0.25, 1}, {1.25, 1.75}};

std::string pair_text(const Vector<double, 2>& v)
{
  return '(' + number(v.x()) + ", " + number(v.y()) + ")";
}

void print_bounds()
{
  const Circle<double> least = minimal_circle<double>(points);
  const Circle<double> centroid = centroid_circle<double>(points);
  const Rectangle<double> rectangle = bounding_rectangle<double>(points);
  Table table({"around eight points", "centre", "radius or half extents"});
  table.row({"smallest circle", pair_text(least.center), number(least.radius)});
  table.row({"circle about the mean", pair_text(centroid.center), number(centroid.radius)});
  table.row({"rectangle", pair_text(rectangle.center), pair_text(rectangle.half_extents)});
  std::cout << table.text();
}

std::string figure()
{
  const Circle<double> least = minimal_circle<double>(points);
  const Circle<double> centroid = centroid_circle<double>(points);
  const Rectangle<double> rectangle = bounding_rectangle<double>(points);
  const Vector<double, 2> upper_left = points[2], lower_right = points[1]; // the farthest
  plot::Figure2d figure("bounding_circle", "", {{-2.5, -2.3}, {5.0, 4.9}, 400});
  figure.describe("Eight points, the smallest circle around them, and the circle about their mean.")
      .box(
          rectangle.center, 0, rectangle.half_extents, Ink::muted, plot::Fill::none,
          plot::Stroke::dotted)
      .circle(centroid.center, centroid.radius, Ink::b, plot::Fill::none, plot::Stroke::dashed)
      .circle(least.center, least.radius, Ink::a)
      .segment(least.center, upper_left, Ink::a)
      .label((least.center + upper_left) / 2, "r_{min}", Side::above, Ink::a)
      .segment(centroid.center, lower_right, Ink::b)
      .label((centroid.center + lower_right) / 2, "r_{c}", Side::below, Ink::b)
      .dot(least.center, Ink::a, "centre", Side::right)
      .dot(centroid.center, Ink::b, "mean", Side::below);
  for (const Vector<double, 2>& point : points)
  {
    figure.dot(point, Ink::ink);
  }
  return figure.svg();
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "bounding_circle", .summary = "Circles and a rectangle around points in the plane."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_bounds();
        save_figure(given, "bounding_circle.svg", figure());
      });
}
