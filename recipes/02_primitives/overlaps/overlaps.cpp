/// \file
/// \brief Asks pairs of shapes whether they overlap, and draws the projections of two triangles.

#include "02_primitives/overlaps/overlaps.hpp"
#include "02_primitives/triangle_triangle/trial/triangle_triangle_cases.hpp"
#include "common/math/rotation.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <iostream>

namespace
{

using namespace cookbook;
using Eigen::Vector2d;
using Eigen::Vector3d;

template <class First, class Second>
void add_pair(Table& table, const std::string& names, const First& a, const Second& b)
{
  table.row({names, overlaps(a, b) ? "yes" : "no"});
}

void print_overlaps()
{
  const Sphere<float> ball{{0, 2, 0}, 2};
  const Plane<float> ground{{0, 1, 0}, 0};
  const Sphere<float> other{{3, 6, 0}, 3}, farther{{3, 6.000001f, 0}, 3};
  const Aabb<float> crate(Eigen::Vector3f(2, 1, -1), Eigen::Vector3f(4, 3, 1));
  const Segment<float> rod{{1, 0, 5}, {9, 0, 5}}, wire{{4, -2, 5}, {4, 3, 5}};
  const Triangle<float> floor{{-9, 1, -9}, {9, 1, -9}, {0, 1, 9}};
  const Tetrahedron<float> solid{{0, 1, 0}, {1, 2, 0}, {0, 2, 1}, {-1, 2, -1}};
  Table table({"pair", "overlap"});
  add_pair(table, "ball on the ground", ball, ground);
  add_pair(table, "balls that touch", ball, other);
  add_pair(table, "one of them a millionth higher", ball, farther);
  add_pair(table, "ball beside a crate, touching", ball, crate);
  add_pair(table, "rods that cross", rod, wire);
  add_pair(table, "corner on a triangle", floor, solid);
  std::cout << table.text();
}

/// The two triangles of F1 in their plane, and their projections along an edge's direction across.
std::string projections_figure()
{
  plot::Figure2d figure("overlaps_projections", "", {{-1.5, -2.2}, {7.5, 7}, 400});
  figure.describe(
      "Two triangles in one plane; their projections on an axis have a gap between them.");
  const std::vector<Vector2d> a{{0, 0}, {1, 0}, {0, 1}}, b{{5, 5}, {6, 5.3}, {5.2, 6}};
  figure.polygon(a, plot::Ink::a).polygon(b, plot::Ink::b);
  const Vector2d axis = Vector2d(1, 1).normalized(), foot(1.5, -1.5);
  const auto on_axis = [&](double at) { return Vector2d(foot + at * axis); };
  figure.segment(on_axis(-1), on_axis(7.6), plot::Ink::muted);
  const auto projection = [&](const std::vector<Vector2d>& corners, plot::Ink ink)
  {
    double least = axis.dot(corners[0]), most = least;
    for (const Vector2d& corner : corners)
    {
      least = std::min(least, axis.dot(corner));
      most = std::max(most, axis.dot(corner));
    }
    figure.segment(on_axis(least), on_axis(most), ink, plot::Stroke::solid, 5);
    return Vector2d(least, most);
  };
  const Vector2d of_a = projection(a, plot::Ink::a), of_b = projection(b, plot::Ink::b);
  figure.segment(a[1], on_axis(of_a.y()), plot::Ink::muted, plot::Stroke::dashed)
      .segment(b[0], on_axis(of_b.x()), plot::Ink::muted, plot::Stroke::dashed)
      .dimension(on_axis(of_a.y()), on_axis(of_b.x()), "gap", -16);
  return figure.svg();
}

std::string verdicts()
{
  return verdict_table(
      "Ways to ask whether two triangles meet.", names_of(triangle_triangle_methods()),
      triangle_triangle_verdicts());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "overlaps", .summary = "Whether shapes of each kind overlap; touching counts."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_overlaps();
        save_figure(given, "overlaps_projections.svg", projections_figure());
        save_figure(given, "overlaps_cases.html", verdicts());
      });
}
