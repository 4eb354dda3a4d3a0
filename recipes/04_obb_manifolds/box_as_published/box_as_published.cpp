/// \file
/// \brief Counts how often each fault of the published code shows on random and resting boxes.

#include "04_obb_manifolds/box_as_published/trial/box_as_published.hpp"
#include "04_obb_manifolds/box_as_published/trial/box_as_published_rates.hpp"
#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"
#include "04_obb_manifolds/box_workloads/trial/boxes_file.hpp"
#include "tools/plot/charts/bar_chart.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

/// A variant and what it got wrong.
struct Counted
{
  FaultVariant variant;
  FaultCounts counts;
};

std::vector<Counted> count_all()
{
  const std::vector<CheckedPair> pairs = checked_pairs(200000);
  std::vector<Counted> all;
  for (const FaultVariant& variant : fault_variants())
  {
    all.push_back({variant, count_faults(pairs, variant.faults)});
  }
  return all;
}

/// A rate in per cent, to the tenth.
double percent(std::size_t part, std::size_t whole)
{
  return std::round(1000 * double(part) / double(whole)) / 10;
}

/// What can be wrong, and in how many per cent of the pairs that it can befall.
std::vector<std::pair<std::string, double>> rates(const FaultCounts& counts)
{
  return {
      {"said to overlap", percent(counts.hit, counts.apart)},
      {"normal reversed", percent(counts.reversed, counts.overlapping)},
      {"depth off", percent(counts.off_depth, counts.overlapping)},
      {"point lost", percent(counts.lost, counts.asked)}};
}

void print(const std::vector<Counted>& all)
{
  const FaultCounts& first = all.front().counts;
  std::cout << first.apart << " pairs apart, " << first.overlapping << " overlapping; in per cent:"
            << "\n\n";
  Table table({"fault", "what", "said to overlap", "reversed", "depth off", "point lost"});
  for (const auto& [variant, counts] : all)
  {
    std::vector<std::string> cells{variant.id, variant.what};
    for (const auto& [what, rate] : rates(counts))
    {
      cells.push_back(number(rate));
    }
    table.row(cells);
  }
  std::cout << table.text();
}

void draw(const Arguments& arguments, const std::vector<Counted>& all)
{
  plot::BarChart chart("box_as_published", "", {"of the pairs that it can befall [%]"});
  chart.describe("How often each fault of the published code gives a wrong answer.").width(400);
  for (const auto& [variant, counts] : all)
  {
    for (const auto& [what, rate] : rates(counts))
    {
      const std::string text = number(rate) + " %";
      if (rate > 0 && variant.id == "all")
      {
        chart.highlight("all: " + what, rate, plot::Ink::overlap, text);
      }
      else if (rate > 0)
      {
        chart.bar(variant.id + ": " + what, rate, plot::Ink::a, text);
      }
    }
  }
  save_figure(arguments, "box_as_published.svg", chart.svg());
}

} // namespace

int main(int argc, char** argv)
{
  return run_pairs_program(
      argc, argv,
      {.name = "box_as_published",
       .summary = "What the published code makes of two boxes, and how often it is wrong.",
       .pairs_header = box_pairs_header},
      of_box_rows([](const auto& a, const auto& b) { return box_as_published(a, b); }),
      [](const Arguments& given)
      {
        const std::vector<Counted> all = count_all();
        print(all);
        draw(given, all);
      });
}
