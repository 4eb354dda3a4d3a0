/// \file
/// \brief Finds the points of an oriented box closest to points around and inside it, and draws
/// them.

#include "02_primitives/closest_point_box/closest_point_box.hpp"
#include "02_primitives/closest_point_box/trial/closest_point_box_cases.hpp"
#include "common/math/rotation.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/program/program.hpp"

#include <iostream>
#include <numbers>

namespace
{

using namespace cookbook;
using Eigen::Vector2d;

/// Turned about z by the angle of the triangle with sides 3, 4 and 5.
const Obb<double> box{{0, 0, 0}, rational_rotation<double>(3, 0, 0, 1), {2, 1, 1}};

struct NamedPoint
{
  std::string name;
  Vector3<double> local; ///< [m], in the box's coordinates
};

const NamedPoint points[] = {{"before a face", {3.5, 0.5, 0}},   {"before an edge", {3, 2, 0.5}},
                             {"before a corner", {-3, -1.5, 2}}, {"on the surface", {-2, 0.5, 0}},
                             {"inside", {1.5, -0.25, 0}},        {"the centre", {0, 0, 0}}};

std::string vector_text(const Vector3<double>& v)
{
  return number(v.x()) + ", " + number(v.y()) + ", " + number(v.z());
}

void print_points()
{
  Table table({"point", "at", "closest", "distance", "direction"});
  for (const NamedPoint& named : points)
  {
    const Vector3<double> world = box.axes * named.local;
    const Direction<double> out =
        signed_distance_box(box_coordinates(box, world), box.half_extents);
    table.row(
        {named.name, vector_text(world), vector_text(closest_point(box, world)), number(out.length),
         vector_text(box.axes * out.unit)});
  }
  std::cout << table.text();
}

Vector2d flat(const Vector3<double>& v)
{
  return {v.x(), v.y()};
}

/// All points of the plane z = 0 at a distance from the box, as corners of a closed line.
std::vector<Vector2d> contour(double distance)
{
  std::vector<Vector2d> line;
  for (int i = 0; i <= 4 * 17; ++i)
  {
    const int quarter = i / 17 % 4;
    const double angle = (quarter + i % 17 / 16.0) * std::numbers::pi / 2;
    const Vector3<double> corner(quarter == 0 || quarter == 3 ? 2 : -2, quarter < 2 ? 1 : -1, 0);
    const Vector3<double> out(std::cos(angle), std::sin(angle), 0);
    line.push_back(flat(box.axes * (corner + distance * out)));
  }
  return line;
}

std::string figure()
{
  plot::Figure2d figure("closest_point_box", "", {{-4, -3.7}, {4, 4.1}, 400});
  figure.describe("An oriented box, six points, and the way from each to the surface of the box.");
  for (const double distance : {0.5, 1.0, 1.5})
  {
    figure.polyline(contour(distance), plot::Ink::faint);
  }
  figure.box({0, 0}, std::atan2(3, 4), {1.5, 0.5}, plot::Ink::faint, plot::Fill::none)
      .box({0, 0}, std::atan2(3, 4), {2, 1}, plot::Ink::b);
  for (const NamedPoint& named : points)
  {
    const Vector3<double> world = box.axes * named.local;
    const Direction<double> out = signed_distance_box(named.local, box.half_extents);
    const Vector3<double> surface = world - box.axes * out.unit * out.length;
    figure.arrow(flat(world), flat(surface), plot::Ink::overlap)
        .dot(flat(world), plot::Ink::a, named.name + " (" + number(out.length) + ")");
  }
  return figure.svg();
}

/// The example's plane, segment and box, and the closest point of each to one point.
std::string points_figure()
{
  const Vector3<double> p(7, -1, 0);
  const Segment<double> rope{{0, 0, 0}, {8, 6, 0}};
  const Obb<double> crate{{0, 1, 0}, Matrix3<double>::Identity(), {2, 1, 1}};
  plot::Figure2d figure("plain_points", "", {{-2.6, -2.2}, {9.4, 6.6}, 400});
  figure.describe("A point below the ground, and the closest points of ground, rope and crate.")
      .half_plane({0, 1}, 0)
      .box({0, 1}, 0, {2, 1}, plot::Ink::b)
      .segment(flat(rope.start), flat(rope.end), plot::Ink::b)
      .arrow(flat(p), {p.x(), 0}, plot::Ink::overlap)
      .arrow(flat(p), flat(closest_point(rope, p)), plot::Ink::overlap)
      .arrow(flat(p), flat(closest_on_box(crate, p)), plot::Ink::overlap)
      .dot(flat(closest_point(rope, p)), plot::Ink::b, "(4, 3)")
      .dot(flat(closest_on_box(crate, p)), plot::Ink::b, "(2, 0)")
      .dot({p.x(), 0}, plot::Ink::b)
      .dot(flat(p), plot::Ink::a, "p = (7, -1)");
  return figure.svg();
}

template <class Real>
void add_errors(plot::Chart& chart, const std::string& name)
{
  std::vector<Vector2d> line;
  for (double scale = 1; scale <= 1e6; scale *= 10)
  {
    line.push_back({15 * scale, axes_error<Real>(scale)});
  }
  chart.line(name, line);
}

// [error_chart]
std::string error_chart()
{
  plot::Chart chart(
      "closest_point_box_error", "", {"distance of the point [m]", plot::Scale::log},
      {"error of the closest point [m]", plot::Scale::log});
  chart.describe("The error of the closest point grows with the distance of the point.")
      .size(400, 340);
  add_errors<float>(chart, "float");
  add_errors<double>(chart, "double");
  chart.reference_y(1e-5, "a hundredth of a millimetre");
  return chart.svg();
}
// [error_chart]

// [verdict_table]
std::string verdicts()
{
  return verdict_table(
      "Ways to answer for a point and a box.", names_of(point_box_methods()), point_box_verdicts());
}
// [verdict_table]

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "closest_point_box",
      .summary = "The points of an oriented box closest to points around and inside it."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_points();
        save_figure(given, "closest_point_box.svg", figure());
        save_figure(given, "plain_points.svg", points_figure());
        save_figure(given, "closest_point_box_error.svg", error_chart());
        save_figure(given, "closest_point_box_cases.html", verdicts());
      });
}
