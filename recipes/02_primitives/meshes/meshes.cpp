/// \file
/// \brief Counts what a ray asks of meshes of growing size, or says what is in a reader's mesh.

#include "02_primitives/meshes/meshes.hpp"
#include "02_primitives/meshes/trial/mesh_file.hpp"
#include "02_primitives/meshes/trial/meshes_cases.hpp"
#include "02_primitives/meshes/trial/meshes_figures.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <iostream>

namespace
{

using namespace cookbook;

void print_asked()
{
  const int rays = 10'000;
  Table table({"triangles", "boxes in the tree", "boxes a ray asks", "triangles a ray asks"});
  for (const int times : {2, 3, 4, 5, 6})
  {
    const TriangleMesh<double> ball = ball_mesh(times);
    const Asked all = asked_in_all(ball, rays);
    const auto mean = [&](std::size_t sum) { return rounded(static_cast<double>(sum) / rays); };
    table.row(
        {std::to_string(ball.triangles.size()), std::to_string(build_volumes(ball).nodes.size()),
         mean(all.boxes), mean(all.triangles)});
  }
  std::cout << table.text();
}

void print_mesh(const std::string& file)
{
  const TriangleMesh<double> mesh = read_mesh(file);
  const BoundingVolumes<double> tree = build_volumes(mesh);
  Table table({"what", "value"});
  table.row({"corners", std::to_string(mesh.vertices.size())});
  table.row({"triangles", std::to_string(mesh.triangles.size())});
  table.row({"boxes in the tree", std::to_string(tree.nodes.size())});
  if (const auto closest = closest_point_of_mesh<double>(mesh, tree, {0, 0, 0}))
  {
    table.row({"distance from the origin", number(closest->distance)});
    table.row({"closest triangle", std::to_string(closest->triangle)});
    for (int axis = 0; axis < 3; ++axis)
    {
      const Eigen::AlignedBox<double, 3>& box = tree.nodes[0].box;
      table.row({std::string("from ") + "xyz"[axis] + " = ", number(box.min()[axis])});
      table.row({std::string("to ") + "xyz"[axis] + " = ", number(box.max()[axis])});
    }
  }
  std::cout << table.text();
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "meshes",
      .summary = "Counts what a ray asks of meshes of growing size, or looks at your mesh.",
      .options = {{"mesh", "your own mesh, .obj or .stl", "", {}, {}, {}, FileUse::read, false}}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        if (!given.value("mesh").empty())
        {
          return print_mesh(given.value("mesh"));
        }
        print_asked();
        save_figure(given, "meshes.svg", tree_figure().svg());
        save_figure(
            given, "meshes_cases.html",
            verdict_table(
                "Ways to cast a ray at a mesh, in float.", names_of(mesh_methods()),
                mesh_verdicts(1'000'000)));
      });
}
