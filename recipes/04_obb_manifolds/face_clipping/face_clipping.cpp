/// \file
/// \brief Finds the full manifold of named pairs of boxes, and draws how one face is cut out by
/// another, the three ways in which two boxes meet, and the points of other methods.

#include "04_obb_manifolds/face_clipping/face_clipping.hpp"
#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"
#include "04_obb_manifolds/box_workloads/trial/boxes_file.hpp"
#include "04_obb_manifolds/face_clipping/trial/face_clipping_figures.hpp"
#include "04_obb_manifolds/face_clipping/trial/same_pair_figures.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>
#include <set>

namespace
{

using namespace cookbook;

/// Edges by box, the axis they run along and their number of four.
std::string feature_name(std::uint32_t feature)
{
  const auto name = [](std::uint32_t edge)
  {
    const std::string box = edge < box_edges ? "A " : "B ";
    return box + "xyz"[edge % box_edges / 4] + std::to_string(edge % 4);
  };
  return name((feature - 1) / (2 * box_edges)) + ", " + name((feature - 1) % (2 * box_edges));
}

std::string cell(double x)
{
  return number(std::round(x * 1e6) * 1e-6);
}

void print_points()
{
  Table table({"boxes", "edges", "x", "y", "z", "depth"});
  for (const BoxScene& scene : box_scenes())
  {
    const Manifold<double> manifold = face_clipping(scene.a, scene.b).value();
    for (const ContactPoint<double>& point : manifold.points)
    {
      const Vector3<double>& p = point.position;
      table.row(
          {scene.name, feature_name(point.feature), cell(p.x()), cell(p.y()), cell(p.z()),
           cell(point.depth)});
    }
  }
  std::cout << table.text();
}

/// What the least overlap belongs to.
std::string kind_name(const Obb<double>& a, const Obb<double>& b)
{
  const AxisKind kind = axis_kind(least_with_certain_edges(a, b)->axis);
  return kind == AxisKind::edges       ? "edges"
         : kind == AxisKind::face_of_a ? "face of A"
                                       : "face of B";
}

void print_cases()
{
  const std::set<std::string> shown{"G2", "G3", "G4", "G6", "G7", "G8", "G15", "G16", "X09"};
  Table table({"case", "boxes", "least", "depth", "points"});
  for (const BoxCase& pair : box_cases())
  {
    if (shown.count(pair.id) == 1)
    {
      const Manifold<double> manifold = face_clipping(pair.a, pair.b).value();
      table.row(
          {pair.id, pair.scene, kind_name(pair.a, pair.b), cell(manifold.depth),
           std::to_string(manifold.points.size())});
    }
  }
  std::cout << "\n" << table.text();
}

/// A cube on a cube, 0.001 deep, tilted by less and less about a line that is parallel to no edge.
void print_tilts()
{
  Table table({"tilt", "least", "depth", "of faces", "points"});
  const Vector3<double> half(0.5, 0.5, 0.5), about(1, 2, 3);
  for (const double tilt : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 0.0})
  {
    const Obb<double> below = upright({0, 0, 0}, half);
    const Obb<double> above{{0, 0.999, 0}, turned(tilt, about), half};
    const Manifold<double> manifold = face_clipping(below, above).value();
    table.row(
        {number(tilt), kind_name(below, above), cell(manifold.depth),
         cell(least_overlap(below, above, 6)->depth), std::to_string(manifold.points.size())});
  }
  std::cout << "\n" << table.text();
}

} // namespace

int main(int argc, char** argv)
{
  return run_pairs_program(
      argc, argv,
      {.name = "face_clipping",
       .summary = "The full manifold of two boxes: a face cut out by a face, or two edges.",
       .pairs_header = box_pairs_header},
      of_box_rows(
          [](const auto& a, const auto& b) { return face_clipping(a, b); }, BoxLengths::any),
      [](const Arguments& given)
      {
        print_points();
        print_cases();
        print_tilts();
        save_figure(given, "face_clipping.svg", clip_figure(box_scenes()[0]));
        save_figure(given, "face_clipping_methods.svg", same_pair_figure(box_scenes()[0]).svg());
      });
}
