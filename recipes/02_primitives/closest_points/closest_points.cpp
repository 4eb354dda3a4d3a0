/// \file
/// \brief Finds where shapes of each kind are closest, and draws two of them.

#include "02_primitives/closest_points/closest_points.hpp"
#include "02_primitives/closest_point_triangle/trial/point_triangle_cases.hpp"
#include "common/math/rotation.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/figures/figure3d.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <iostream>

namespace
{

using namespace cookbook;
using Eigen::Vector2d;
using Eigen::Vector3d;

const Tetrahedron<double> solid{{-3, 0, 0}, {0, 0, 1}, {-1, 0, -2}, {-1.5, 2, 0}};
const Obb<double> box{{2.6, 1, 0}, rational_rotation<double>(3, 0, 0, 1), {1, 0.5, 1}};
const Plane<double> ground{{0, 1, 0}, -1};
const Capsule<double> capsule{{{0, 4, -1}, {3, 4, 2}}, 0.5};
const Triangle<double> triangle{{-2, 5, 2}, {2, 5, 2}, {0, 5, -2}};

std::string point_text(const Vector3d& v)
{
  return number(v.x()) + ", " + number(v.y()) + ", " + number(v.z());
}

template <class First, class Second>
void add_pair(Table& table, const std::string& names, const First& a, const Second& b)
{
  const ClosestPoints<double, 3> points = closest_points(a, b);
  table.row({names, point_text(points.a), point_text(points.b), number(points.distance)});
}

void print_pairs()
{
  Table table({"pair", "point of the first", "point of the second", "distance"});
  add_pair(table, "ground, tetrahedron", ground, solid);
  add_pair(table, "ground, capsule", ground, capsule);
  add_pair(table, "capsule, box", capsule, box);
  add_pair(table, "capsule, triangle", capsule, triangle);
  add_pair(table, "box, tetrahedron", box, solid);
  add_pair(table, "triangle, tetrahedron", triangle, solid);
  add_pair(table, "capsule, itself", capsule, capsule);
  std::cout << table.text();
}

std::string pair_figure()
{
  plot::Figure3d figure("closest_points", "", {.yaw = 0.35, .pitch = 0.3, .width = 400});
  figure.describe("A tetrahedron and an oriented box, and the shortest way between them.");
  const Vector3d &a = solid.a, &b = solid.b, &c = solid.c, &d = solid.d;
  for (const std::vector<Vector3d>& face : {std::vector<Vector3d>{a, c, d}, {b, c, d}, {a, b, d}})
  {
    figure.polygon(face, plot::Ink::a);
  }
  figure.box(box.center, box.axes, box.half_extents, plot::Ink::b);
  const ClosestPoints<double, 3> points = closest_points(box, solid);
  figure.segment(points.b, points.a, plot::Ink::overlap)
      .point(points.b, plot::Ink::a)
      .point(points.a, plot::Ink::b)
      .label((points.a + points.b) / 2, number(points.distance) + " m", plot::Side::automatic);
  return figure.svg();
}

/// The regions around a triangle, each with the corner, edge or face that is closest there.
std::string regions_figure()
{
  const Vector2d corners[] = {{-2, -1}, {2, -1}, {0.5, 1.8}};
  const char* const names[] = {"a", "b", "c"};
  plot::Figure2d figure("closest_points_regions", "", {{-4, -3}, {4, 4}, 400});
  figure.describe("A triangle; rays perpendicular to its edges part the plane into seven regions.");
  figure.polygon({corners[0], corners[1], corners[2]}, plot::Ink::b);
  for (int i = 0; i < 3; ++i)
  {
    const Vector2d from = corners[i], to = corners[(i + 1) % 3];
    const Vector2d along = (to - from).normalized(), out(along.y(), -along.x());
    figure.segment(from, from + 1.7 * out, plot::Ink::muted, plot::Stroke::dashed)
        .segment(to, to + 1.7 * out, plot::Ink::muted, plot::Stroke::dashed)
        .label((from + to) / 2 + 0.9 * out, std::string("edge ") + names[i] + names[(i + 1) % 3])
        .dot(from, plot::Ink::b, names[i]);
  }
  figure.label({0.2, -0.2}, "face");
  const Vector3d p(3.2, -1.8, 0);
  const Triangle<double> flat{{-2, -1, 0}, {2, -1, 0}, {0.5, 1.8, 0}};
  const Vector3d closest = closest_points(p, flat).b;
  figure.arrow({p.x(), p.y()}, {closest.x(), closest.y()}, plot::Ink::overlap)
      .dot({p.x(), p.y()}, plot::Ink::a, "p");
  return figure.svg();
}

std::string verdicts()
{
  return verdict_table(
      "Ways to find the closest point of a triangle.", names_of(point_triangle_methods()),
      point_triangle_verdicts());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "closest_points", .summary = "Where shapes of each kind are closest."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_pairs();
        save_figure(given, "closest_points.svg", pair_figure());
        save_figure(given, "closest_points_regions.svg", regions_figure());
        save_figure(given, "closest_points_cases.html", verdicts());
      });
}
