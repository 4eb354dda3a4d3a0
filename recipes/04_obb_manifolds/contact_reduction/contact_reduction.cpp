/// \file
/// \brief Keeps four of eight contact points in two ways, and draws what area each of them loses.

#include "04_obb_manifolds/contact_reduction/contact_reduction.hpp"
#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"
#include "04_obb_manifolds/box_oracles/trial/resting_steadiness.hpp"
#include "04_obb_manifolds/contact_reduction/trial/contact_reduction_figures.hpp"
#include "04_obb_manifolds/contact_reduction/trial/contact_reduction_verdicts.hpp"
#include "tools/program/program.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

const Vector3<double> middle(0, 1, 0);

void print_octagon()
{
  const Manifold<double> octagon = turned_squares(45 * degree, 1e-3);
  Table table({"kept", "area", "fraction", "middle inside by", "weight inside by"});
  const auto add = [&](const std::string& name, const auto& manifold)
  {
    const std::vector<Corner> hull = support(manifold);
    const auto held = [&](const Vector3<double>& point)
    { return cell(inside(hull, seen_along(manifold.normal, point))); };
    const double fraction = area(hull) / area(support(octagon));
    table.row({name, cell(area(hull)), cell(fraction), held(middle), held(weight)});
  };
  add("all 8", octagon);
  for (const Way& way : ways)
  {
    add(way.name, way.keep(octagon));
  }
  std::cout << table.text();
}

void print_resting()
{
  const BoxWorkload workload = box_workload("resting", 2000);
  Table table({"kept", "least area of 99%", "largest jump of 99%"});
  const auto add = [&](const std::string& name, const auto& keep)
  {
    const RestingSteadiness steadiness = resting_steadiness<double>(
        workload,
        [&](const Obb<double>& a, const Obb<double>& b)
        {
          const auto all = box_box(a, b);
          return all ? std::optional(keep(*all)) : std::nullopt;
        });
    table.row({name, cell(steadiness.area), cell(steadiness.jump)});
  };
  add("all points", [](const Manifold<double>& many) { return many; });
  for (const std::size_t way : {0u, 1u, 3u})
  {
    add(ways[way].name, ways[way].keep);
  }
  std::cout << "\n" << table.text();
}

void draw_octagons(const Arguments& arguments)
{
  plot::Grid grid("contact_reduction", "", 2);
  grid.describe("An octagon of contact: reduced() keeps a square, four_deepest() keeps one side.")
      .add(octagon_figure(ways[1]))
      .add(octagon_figure(ways[3]));
  save_figure(arguments, "contact_reduction.svg", grid.svg());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "contact_reduction", .summary = "Four contact points of eight, and what that loses."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_octagon();
        print_resting();
        draw_octagons(given);
        save_figure(given, "contact_reduction_yaw.svg", yaw_chart().svg());
        save_figure(
            given, "contact_reduction_verdicts.html",
            verdict_table(
                "Four points of eight", names_of(reduction_methods()), reduction_verdicts()));
      });
}
