/// \file
/// \brief Finds overlaps, closest points and hits of shapes in the plane, and draws them.

#include "02_primitives/in_the_plane/in_the_plane.hpp"
#include "02_primitives/in_the_plane/trial/plane_cases.hpp"
#include "02_primitives/in_the_plane/trial/plane_figures.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

std::string pair_text(const Vector<double, 2>& v)
{
  return '(' + number(v.x()) + ", " + number(v.y()) + ")";
}

template <class Shape>
void add_pair(Table& table, const std::string& name, const Shape& shape)
{
  const OrientedRectangle<double> oriented = PlaneScene().oriented;
  const ClosestPoints<double, 2> found = closest_points(shape, oriented);
  table.row(
      {name, overlaps(shape, oriented) ? "yes" : "no", number(found.distance), pair_text(found.a),
       pair_text(found.b)});
}

void print_closest()
{
  const PlaneScene scene;
  Table table({"shape", "overlaps", "distance", "its point", "the rectangle's"});
  add_pair(table, "point", scene.point);
  add_pair(table, "segment", scene.segment);
  add_pair(table, "circle", scene.circle);
  add_pair(table, "rectangle", scene.rectangle);
  add_pair(table, "larger circle", Circle<double>{scene.circle.center, 2.5});
  std::cout << table.text() << '\n';
}

template <class Path, class Shape>
void add_hit(Table& table, const std::string& what, const Path& path, const Shape& shape)
{
  const auto hit = cast(path, shape);
  table.row(
      {what, hit ? number(hit->t) : "miss", hit ? pair_text(hit->point) : "",
       hit ? pair_text(hit->normal) : ""});
}

void print_hits()
{
  const PlaneScene scene;
  const Ray2<double> up{{2.5, -4}, {0, 2}};
  const Segment2<double> short_of_it{{2.5, -4}, {2.5, -2.5}};
  Table table({"cast", "t", "point", "normal"});
  add_hit(table, "ray, rectangle", up, scene.rectangle);
  add_hit(table, "ray, circle", up, scene.circle);
  add_hit(table, "ray, segment", up, scene.segment);
  add_hit(table, "segment, rectangle", short_of_it, scene.rectangle);
  add_hit(table, "from inside", Ray2<double>{{1.5, -1.5}, {3, 4}}, scene.rectangle);
  std::cout << table.text();
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "in_the_plane",
      .summary = "Overlaps, closest points and hits of shapes in the plane."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_closest();
        print_hits();
        save_figure(given, "in_the_plane.svg", closest_figure().svg());
        save_figure(given, "in_the_plane_projections.svg", projection_figures().svg());
        save_figure(given, "in_the_plane_slabs.svg", slab_figure().svg());
        save_figure(
            given, "in_the_plane_cases.html",
            verdict_table("Ways to answer in the plane.", names_in_plane(), verdicts_in_plane()));
      });
}
