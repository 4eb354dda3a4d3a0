/// \file
/// \brief Finds the least overlap of named pairs of boxes, and draws it for two crossed ridges and
/// for a cube that tips over.

#include "04_obb_manifolds/separating_axes/separating_axes.hpp"
#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"
#include "04_obb_manifolds/box_workloads/trial/boxes_file.hpp"
#include "04_obb_manifolds/separating_axes/trial/projections_figure.hpp"
#include "04_obb_manifolds/separating_axes/trial/separating_axes_figures.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

void print_cases()
{
  Table table({"boxes", "depth", "axis", "normal x", "y", "z"});
  const auto add = [&](const std::string& scene, const Obb<double>& a, const Obb<double>& b)
  {
    const std::optional<LeastOverlap<double>> least = separating_axes(a, b);
    if (!least)
    {
      table.row({scene, "apart", "", "", "", ""});
      return;
    }
    const auto cell = [](double x) { return number(std::round(x * 1e6) * 1e-6); };
    table.row(
        {scene, cell(least->depth), axis_name(least->axis), cell(least->normal.x()),
         cell(least->normal.y()), cell(least->normal.z())});
  };
  add("two ridges, one askew", ridge_a, ridge_b);
  for (const BoxCase& pair : box_cases())
  {
    add(pair.scene, pair.a, pair.b);
  }
  std::cout << table.text();
}

/// The least overlap as a manifold without points.
template <class Real>
std::optional<Manifold<Real>> without_points(const Obb<Real>& a, const Obb<Real>& b)
{
  const auto least = separating_axes(a, b);
  return least ? std::optional(Manifold<Real>{least->normal, least->depth, {}}) : std::nullopt;
}

} // namespace

int main(int argc, char** argv)
{
  return run_pairs_program(
      argc, argv,
      {.name = "separating_axes",
       .summary = "The separating-axis test of two boxes: normal and depth, no points.",
       .pairs_header = box_pairs_header},
      of_box_rows([](const auto& a, const auto& b) { return without_points(a, b); }),
      [](const Arguments& given)
      {
        print_cases();
        save_figure(given, "separating_axes_projections.svg", projections_grid().svg());
        save_figure(given, "separating_axes.svg", axes_chart().svg());
        save_figure(given, "separating_axes_boxes.svg", ridges_figure().svg());
        save_figure(given, "separating_axes_tilt.svg", tilt_grid().svg());
      });
}
