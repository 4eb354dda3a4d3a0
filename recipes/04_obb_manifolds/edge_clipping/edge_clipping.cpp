/// \file
/// \brief Finds contact points of a turned cube on a slab and of all cases, and draws the cube.

#include "04_obb_manifolds/edge_clipping/edge_clipping.hpp"
#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "04_obb_manifolds/box_cases/trial/contacts_figure.hpp"
#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"
#include "04_obb_manifolds/box_workloads/trial/boxes_file.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

const Obb<double> slab = upright({0, 0, 0}, {1.2, 0.3, 1});
const Obb<double> cube{{0.8, 0.7, 0.3}, turned(0.5, {0, 1, 0}), {0.6, 0.6, 0.6}};

/// Edges by the axis they run along and their number, faces by side: `A y2 on B +x`.
std::string feature_name(std::uint32_t feature)
{
  if (feature == 0)
  {
    return "inside";
  }
  const bool of_a = feature <= edge_face_pairs;
  const std::uint32_t number = (feature - 1) % edge_face_pairs;
  const std::uint32_t edge = number / 6, face = number % 6;
  const std::string edge_name = std::string(1, "xyz"[edge / 4]) + std::to_string(edge % 4);
  const std::string face_name = std::string(1, "+-"[face % 2]) + "xyz"[face / 2];
  return (of_a ? "A " : "B ") + edge_name + (of_a ? " on B " : " on A ") + face_name;
}

std::string cell(double x)
{
  return number(std::round(x * 1e6) * 1e-6);
}

void print_points()
{
  Table table({"edge and face", "x", "y", "z"});
  const Manifold<double, most_crossings> manifold = edge_clipping(slab, cube).value();
  for (const ContactPoint<double>& point : manifold.points)
  {
    table.row(
        {feature_name(point.feature), cell(point.position.x()), cell(point.position.y()),
         cell(point.position.z())});
  }
  std::cout << table.text();
}

void print_counts()
{
  Table table({"case", "boxes", "depth", "points", "first"});
  for (const BoxCase& pair : box_cases())
  {
    if (const auto manifold = edge_clipping(pair.a, pair.b))
    {
      table.row(
          {id_in_tables(pair), pair.scene, cell(manifold->depth),
           std::to_string(manifold->points.size()), feature_name(manifold->points[0].feature)});
    }
  }
  std::cout << "\n" << table.text();
}

void draw(const Arguments& arguments)
{
  const Manifold<double, most_crossings> manifold = edge_clipping(slab, cube).value();
  const BoxScene scene{"", slab, cube, {-0.9, 0, 1}, {0.8, 1.1, 0.3}, 0.42};
  plot::Figure3d figure = contacts_figure(scene, manifold, {-0.5, scene.pitch, 400, 320});
  figure.describe("A cube turned on a slab: one contact point for each edge that passes a face.");
  save_figure(arguments, "edge_clipping.svg", figure.svg());
}

} // namespace

int main(int argc, char** argv)
{
  return run_pairs_program(
      argc, argv,
      {.name = "edge_clipping",
       .summary = "The manifold of two boxes from edges of one that pass faces of the other.",
       .pairs_header = box_pairs_header},
      of_box_rows([](const auto& a, const auto& b) { return edge_clipping(a, b); }),
      [](const Arguments& given)
      {
        print_points();
        print_counts();
        draw(given);
      });
}
