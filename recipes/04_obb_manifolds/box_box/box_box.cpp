/// \file
/// \brief Finds the manifolds of pairs of boxes that meet in every way, and draws them; with
/// --compare it tries every method on the reader's own pairs.

#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_box/trial/box_box_figures.hpp"
#include "04_obb_manifolds/box_box/trial/compare_pairs.hpp"
#include "04_obb_manifolds/feature_memory/feature_memory.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

/// What the manifold is built on: a face or two edges.
std::string axis_name(int axis)
{
  const auto name = [](const char* box, int i) { return std::string(box) + "xyz"[i]; };
  return axis_kind(axis) == AxisKind::edges
             ? "edges " + name("A ", (axis - 6) / 3) + ", " + name("B ", (axis - 6) % 3)
             : "face " + name(axis < 3 ? "A " : "B ", axis % 3);
}

std::string cell(double x)
{
  return number(std::round(x * 1e6) * 1e-6);
}

void print_manifolds()
{
  Table table({"boxes", "built on", "depth", "normal x", "y", "z", "points"});
  Table points({"boxes", "point", "x", "y", "z", "depth"});
  for (const BoxScene& scene : box_box_scenes())
  {
    const std::optional<Manifold<double>> manifold = box_box(scene.a, scene.b);
    if (!manifold)
    {
      table.row({scene.name, "none", "", "", "", "", "0"});
      continue;
    }
    const Vector3<double>& n = manifold->normal;
    table.row(
        {scene.name, axis_name(axis_of(manifold)), cell(manifold->depth), cell(n.x()), cell(n.y()),
         cell(n.z()), std::to_string(manifold->points.size())});
    for (std::size_t i = 0; i < manifold->points.size(); ++i)
    {
      const auto& [p, depth, feature] = manifold->points[i];
      points.row(
          {scene.name, std::to_string(i), cell(p.x()), cell(p.y()), cell(p.z()), cell(depth)});
    }
  }
  std::cout << table.text() << "\n" << points.text();
}

void run(const Arguments& given)
{
  const bool compares = !given.value("compare").empty();
  if (!given.pairs.empty())
  {
    return compares ? compare_box_methods(given) : print_own_manifolds(given);
  }
  print_manifolds();
  save_figure(given, "box_box.svg", manifolds_figure());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "box_box",
      .summary = "The manifold of two boxes: normal, depth and contact points.",
      .pairs_header = box_pairs_header,
      .options = {
          scalar_option(),
          {"method", "what answers --pairs", "box_box", box_manifold_names(), {"pairs"}},
          {"compare",
           "time and check every method on --pairs instead",
           "",
           {"yes"},
           {"pairs"},
           {"method", "scalar"}}}};
  return run_program(argc, argv, arguments, run);
}
