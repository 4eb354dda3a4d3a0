/// \file
/// \brief Finds the manifold of boxes that meet in three ways, and draws it.

#include "04_obb_manifolds/plain_box_box/plain_box_box.hpp"
#include "04_obb_manifolds/box_workloads/trial/boxes_file.hpp"
#include "04_obb_manifolds/face_clipping/trial/face_clipping_scenes.hpp"
#include "04_obb_manifolds/plain_box_box/trial/plain_box_box_rungs.hpp"
#include "04_obb_manifolds/separating_axes/trial/separating_axes_figures.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

std::string cell(double x)
{
  return number(std::round(x * 1e4) * 1e-4);
}

void print_scenes()
{
  Table table({"boxes", "axis", "depth", "x", "y", "z", "depth there", "feature"});
  for (const BoxScene& scene : box_scenes())
  {
    const Manifold<double> manifold = plain_box_box(scene.a, scene.b).value();
    for (const ContactPoint<double>& point : manifold.points)
    {
      const Vector3<double>& p = point.position;
      table.row(
          {scene.name, axis_name(static_cast<int>(point.feature / 64)), cell(manifold.depth),
           cell(p.x()), cell(p.y()), cell(p.z()), cell(point.depth),
           std::to_string(point.feature % 64)});
    }
  }
  std::cout << table.text();
}

void print_rungs()
{
  Table table({"case", "right", "face_clipping", "plain_box_box", "box_box", "next_frame"});
  for (const RungCase& row : rung_cases())
  {
    const auto count = [](int n) { return std::to_string(n); };
    table.row(
        {row.what, count(row.right), count(row.least), count(row.plain), count(row.hardened),
         count(row.steady)});
  }
  std::cout << '\n' << table.text();
}

void draw(const Arguments& given)
{
  plot::Grid grid("plain_box_box", "", 2);
  grid.describe("Two boxes that meet face on face, corner on face and edge on edge.");
  for (const BoxScene& scene : box_scenes())
  {
    grid.add(contacts_figure(scene, *plain_box_box(scene.a, scene.b), {2.5, 0.3, 189, 210, 22}));
  }
  save_figure(given, "plain_box_box.svg", grid.svg());
}

} // namespace

int main(int argc, char** argv)
{
  return run_pairs_program(
      argc, argv,
      {.name = "plain_box_box",
       .summary = "The manifold of two boxes, plain: separating axes, then clipping.",
       .pairs_header = box_pairs_header},
      of_box_rows(
          [](const auto& a, const auto& b) { return plain_box_box(a, b); },
          BoxLengths::with_squares),
      [](const Arguments& given)
      {
        print_scenes();
        print_rungs();
        draw(given);
      });
}
