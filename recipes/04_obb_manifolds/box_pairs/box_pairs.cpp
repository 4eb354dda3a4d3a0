/// \file
/// \brief Answers sixteen pairs of boxes at once and one by one, and draws them lane by lane.

#include "04_obb_manifolds/box_pairs/box_pairs.hpp"
#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_oracles/trial/manifold_error.hpp"
#include "04_obb_manifolds/box_pairs/trial/box_pairs_scenes.hpp"
#include "04_obb_manifolds/box_workloads/trial/boxes_file.hpp"
#include "tools/plot/figures/figure3d.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

/// The pairs of all lanes.
std::vector<BoxPair<float>> pairs_of(const std::vector<Lane>& lanes)
{
  std::vector<BoxPair<float>> pairs;
  for (const Lane& lane : lanes)
  {
    pairs.push_back(lane.pair);
  }
  return pairs;
}

/// Whether two answers have the same numbers.
bool same(const std::optional<Manifold<float>>& x, const std::optional<Manifold<float>>& y)
{
  return manifolds_csv<float, 8>({x}) == manifolds_csv<float, 8>({y});
}

std::string cell(float x)
{
  return number(std::round(double(x) * 1e4) * 1e-4);
}

void print_scene(const std::vector<Lane>& lanes)
{
  const auto at_once = box_pairs_in_order(pairs_of(lanes));
  Table table(
      {"lane", "boxes", "depth", "normal x", "normal y", "normal z", "points", "one by one"});
  for (std::size_t i = 0; i < lanes.size(); ++i)
  {
    const auto& [a, b] = lanes[i].pair;
    const std::string verdict = same(at_once[i], box_box(a, b)) ? "the same" : "differs";
    if (const auto& m = at_once[i])
    {
      table.row(
          {std::to_string(i), lanes[i].name, cell(m->depth), cell(m->normal.x()),
           cell(m->normal.y()), cell(m->normal.z()), std::to_string(m->points.size()), verdict});
    }
    else
    {
      table.row({std::to_string(i), lanes[i].name, "apart", "", "", "", "0", verdict});
    }
  }
  std::cout << table.text();
}

/// The boxes of a lane, with normal and contact points.
plot::Figure3d
lane_figure(const std::string& name, const BoxPair<double>& pair, const Manifold<float>* manifold)
{
  const auto& [a, b] = pair;
  plot::Figure3d figure("box_pairs", name, {0.55, 0.4, 118, 118});
  figure.frame({(a.center + b.center) / 2, 3.1})
      .box(a.center, a.axes, a.half_extents, plot::Ink::a)
      .box(b.center, b.axes, b.half_extents, plot::Ink::b);
  if (manifold)
  {
    Vector3<double> middle(0, 0, 0);
    for (const ContactPoint<float>& point : manifold->points)
    {
      figure.point(point.position.cast<double>());
      middle += point.position.cast<double>() / static_cast<double>(manifold->points.size());
    }
    figure.arrow(middle, middle + 0.7 * manifold->normal.cast<double>());
  }
  return figure;
}

void draw(const Arguments& arguments, const std::vector<Lane>& lanes)
{
  plot::Grid grid("box_pairs", "", 3);
  grid.describe("Sixteen pairs of boxes, each with its normal and its contact points.");
  const auto manifolds = box_pairs_in_order(pairs_of(lanes));
  for (std::size_t i = 0; i < lanes.size(); ++i)
  {
    const BoxPair<double> pair = pair_in<double>(lanes[i].pair);
    const Manifold<float>* const manifold = manifolds[i] ? &*manifolds[i] : nullptr;
    grid.add(lane_figure(std::to_string(i) + ": " + lanes[i].name, pair, manifold));
  }
  save_figure(arguments, "box_pairs.svg", grid.svg());
}

void print_file(const Arguments& arguments)
{
  std::vector<BoxPair<float>> pairs;
  for (CsvRow& row : read_csv(arguments.pairs, arguments.pairs_header))
  {
    pairs.push_back(
        box_pair_at<float>({arguments.pairs.string(), arguments.pairs_header, std::move(row)}));
  }
  std::cout << manifolds_csv(box_pairs_in_order(pairs));
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "box_pairs",
      .summary = "Many pairs of boxes at once, in float.",
      .pairs_header = box_pairs_header};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        if (!given.pairs.empty())
        {
          return print_file(given);
        }
        print_scene(sixteen_lanes());
        draw(given, sixteen_lanes());
      });
}
