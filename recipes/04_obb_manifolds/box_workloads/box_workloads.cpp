/// \file
/// \brief Says what the ten workloads are made of, draws a pair of each, and writes them as CSV.

#include "04_obb_manifolds/box_workloads/trial/box_workloads.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_workload_contents.hpp"
#include "tools/measure/statistics.hpp"
#include "tools/plot/figures/figure3d.hpp"
#include "tools/plot/panel.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <charconv>
#include <iostream>

namespace
{

using namespace cookbook;

constexpr std::size_t pairs_each = 2000;

void print_contents()
{
  Table definitions({"workload", "two boxes"});
  Table table({"workload", "overlap %", "parallel %", "edges %", "depth / size"});
  for (const BoxRecipe& recipe : box_workload_recipes())
  {
    definitions.row({recipe.name, recipe.what});
    const BoxContents found = contents(box_workload(recipe, pairs_each));
    const auto percent = [](std::size_t part, std::size_t whole)
    { return number(std::round(100 * static_cast<double>(part) / static_cast<double>(whole))); };
    const std::size_t overlapping = found.depths.size();
    table.row(
        {recipe.name, percent(overlapping, pairs_each), percent(found.parallel, pairs_each),
         percent(found.edges, overlapping),
         number(std::round(measure::median(found.depths) * 1e4) * 1e-4)});
  }
  std::cout << definitions.text() << "\n" << table.text();
}

/// The shortest turn that brings a unit vector upwards.
Matrix3<double> turned_up(const Vector3<double>& way)
{
  const Vector3<double> up(0, 1, 0);
  const double cosine = way.dot(up);
  return cosine > -1 ? quaternion_rotation(1 + cosine, way.cross(up))
                     : quaternion_rotation(0, Vector3<double>(1, 0, 0));
}

/// The first pair of a workload that overlaps, A in the origin, B above it.
BoxPair<double> shown(const BoxWorkload& workload)
{
  for (const BoxPair<float>& pair : workload.pairs)
  {
    const Obb<double> a = orthonormal(pair.first), b = orthonormal(pair.second);
    const TrueLeast<double> least = true_least_overlap(a, b);
    if (true_depth(least) > 0)
    {
      const double side = least.axis.dot(b.center - a.center) < 0 ? -1 : 1;
      const Matrix3<double> turn = turned_up(normalize<double>(side * least.axis).unit);
      const auto turned = [&](const Obb<double>& box) -> Obb<double> {
        return {turn * (box.center - a.center), turn * box.axes, box.half_extents};
      };
      return {turned(a), turned(b)};
    }
  }
  throw std::logic_error(workload.name + " has no pair that overlaps");
}

// [draw]
/// A pair of boxes, with the length that is one metre, millimetre or kilometre in its workload.
plot::Figure3d pair_figure(const BoxRecipe& recipe)
{
  const auto [a, b] = shown(box_workload(recipe, 20));
  const plot::Camera camera{0.5, 0.3, 118, 150, 8};
  const Vector3<double> right(std::cos(camera.yaw), 0, -std::sin(camera.yaw));
  const double lowest = a.center.y() - 1.2 * a.half_extents.norm();
  const Vector3<double> end = Vector3<double>(0, lowest, 0) + recipe.scale / 2 * right;
  const std::string length = recipe.scale < 1 ? "1 mm" : recipe.scale > 1 ? "1 km" : "1 m";
  plot::Figure3d figure("box_workloads_pair", recipe.name, camera);
  return figure.box(a.center, a.axes, a.half_extents, plot::Ink::a)
      .box(b.center, b.axes, b.half_extents, plot::Ink::b)
      .dimension(end - recipe.scale * right, end, length, 0, plot::Ink::muted);
}

void draw(const Arguments& arguments)
{
  plot::Grid grid("box_workloads", "", 3);
  grid.describe("One pair of boxes of each of the ten workloads, turned so that B parts upwards.");
  for (const BoxRecipe& recipe : box_workload_recipes())
  {
    grid.add(pair_figure(recipe));
  }
  save_figure(arguments, "box_workloads.svg", grid.svg());
}
// [draw]

/// The number of pairs asked for; std::invalid_argument if it is none.
std::size_t count_asked_for(const Arguments& arguments)
{
  const std::string& text = arguments.value("count");
  std::size_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || end != text.data() + text.size() || count == 0)
  {
    throw std::invalid_argument("--count must be a whole number from 1 on, got " + text);
  }
  return count;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "box_workloads",
      .summary = "Ten named sets of pairs of boxes, and any of them as a file for --pairs.",
      .options = {
          {.name = "csv",
           .help = "print the pairs of this workload instead",
           .value = "",
           .choices = box_workload_names(),
           .draws = false},
          {"count", "how many pairs to print", "1000", {}, {"csv"}}}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        if (!given.value("csv").empty())
        {
          const BoxWorkload workload = box_workload(given.value("csv"), count_asked_for(given));
          std::cout << box_pairs_csv(workload.pairs);
          return;
        }
        print_contents();
        draw(given);
      });
}
