/// \file
/// \brief Casts a ray and a segment at one shape of each kind, and draws where they meet it.

#include "02_primitives/casts/casts.hpp"
#include "02_primitives/casts/trial/casts_cases.hpp"
#include "02_primitives/casts/trial/casts_figures.hpp"
#include "common/math/rotation.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

std::string triple(const Vector3<double>& v)
{
  return '(' + number(v.x()) + ", " + number(v.y()) + ", " + number(v.z()) + ")";
}

template <class Shape>
void add_row(Table& table, const std::string& name, const Shape& shape)
{
  const Ray<double> ray{{-6, 1, 0}, {2, 0, 0}};
  const Segment<double> segment{{-6, 1, 0}, {-3, 1, 0}};
  const auto hit = cast(ray, shape);
  table.row(
      {name, hit ? number(hit->t) : "none", hit ? triple(hit->point) : "",
       hit ? triple(hit->normal) : "", cast(segment, shape) ? "yes" : "no"});
}

void print_casts()
{
  using V = Vector3<double>;
  const Matrix3<double> turned = rational_rotation<double>(3, 0, 0, 1); // about z, by 3-4-5
  Table table({"shape", "t", "point", "normal", "segment of 3 m"});
  add_row(table, "plane x = 0", Plane<double>{{-1, 0, 0}, 0});
  add_row(table, "sphere", Sphere<double>{{0, -2, 0}, 5});
  add_row(table, "capsule", Capsule<double>{{{0, -9, 0}, {0, -2, 0}}, 5});
  add_row(table, "box along the axes", Aabb<double>(V(-4, -1, -1), V(2, 2, 2)));
  add_row(table, "oriented box", Obb<double>{{0, 1, 0}, turned, {2, 4, 1}});
  add_row(table, "triangle", Triangle<double>{{-1, 0, 0}, {1, 4, 3}, {1, 4, -3}});
  add_row(table, "tetrahedron", Tetrahedron<double>{{-1, 0, 0}, {1, 4, 3}, {1, 4, -3}, {6, 0, 0}});
  add_row(table, "ball behind", Sphere<double>{{-9, 1, 0}, 1});
  std::cout << table.text();
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "casts",
      .summary = "Casts a ray and a segment at one shape of each kind, and draws what they meet."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_casts();
        save_figure(
            given, "casts_cases.html",
            verdict_table(
                "Ways to cast a ray, in float.", names_of(cast_methods()), cast_verdicts()));
        save_figure(given, "casts.svg", casts_figure().svg());
        save_figure(given, "casts_sphere.svg", chord_figure().svg());
        save_figure(given, "casts_slabs.svg", slab_figure().svg());
        save_figure(given, "casts_sheared.svg", sheared_figure().svg());
      });
}
