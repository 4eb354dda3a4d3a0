#pragma once

/// \file
/// \brief Times and checks every method on the reader's own pairs of boxes.

#include "04_obb_manifolds/box_oracles/trial/method_times.hpp"
#include "04_obb_manifolds/box_workloads/trial/boxes_file.hpp"
#include "tools/files/whole_file.hpp"

#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace cookbook
{

// [own_pairs]
/// The pairs of --pairs in both number types; CsvError at what makes no sense in either.
inline BoxPairLists own_box_pairs(const Arguments& arguments)
{
  BoxPairLists lists;
  for (CsvRow& row : read_csv(arguments.pairs, arguments.pairs_header))
  {
    const PairsRow place{arguments.pairs.string(), arguments.pairs_header, std::move(row)};
    lists.in_double.push_back(box_pair_at<double>(place));
    lists.in_float.push_back(box_pair_at<float>(place));
  }
  if (lists.in_float.empty())
  {
    throw std::runtime_error(arguments.pairs.string() + ": no pairs to compare methods on");
  }
  return lists;
}

/// At least `least` pairs in random order: the given ones again and again, if they are fewer.
inline BoxPairLists repeated_at_random(const BoxPairLists& lists, std::size_t least)
{
  const std::size_t given = lists.in_float.size();
  std::vector<std::size_t> order;
  while (order.size() < least || order.size() % given != 0)
  {
    order.push_back(order.size() % given);
  }
  std::mt19937 random(1);
  BoxPairLists result;
  for (std::size_t left = order.size(); left > 0; --left)
  {
    std::swap(order[left - 1], order[random() % left]);
    result.in_float.push_back(lists.in_float[order[left - 1]]);
    result.in_double.push_back(lists.in_double[order[left - 1]]);
  }
  return result;
}
// [own_pairs]

/// Every method on the reader's pairs.
inline std::vector<MeasuredBoxMethod>
compared_methods(const BoxPairLists& given, const measure::Effort& effort)
{
  const std::vector<TimedMethod> all = own_contenders();
  const auto times = box_times(all, repeated_at_random(given, 2048), effort);
  std::vector<MeasuredBoxMethod> methods;
  for (std::size_t m = 0; m < all.size(); ++m)
  {
    methods.push_back({{times[m]}, box_accuracy(all[m].checks(given))});
  }
  return methods;
}

/// The table of methods: what each costs, also as a multiple of box_box in the same scalar type,
/// and what it gets wrong.
inline Cells compared_table(const std::vector<MeasuredBoxMethod>& methods)
{
  Cells cells{
      {"method", "ns a pair", "x box_box", "wrong", "depth error 99 %", "greatest", "points lost"}};
  for (const MeasuredBoxMethod& method : methods)
  {
    const BoxAccuracy& found = method.accuracy;
    const auto error = [&](double value) { return found.compared > 0 ? rounded(value) : "none"; };
    const auto& [name, ns, usual, peer] = method.times[0];
    const auto box_box = std::find_if(
        methods.begin(), methods.end(),
        [type = name.substr(name.find(','))](const auto& other)
        { return other.times[0].name == "box_box" + type; });
    cells.push_back(
        {name, measure::time_text(ns), rounded(ns / box_box->times[0].ns),
         std::to_string(found.wrong + found.not_finite), error(found.depth_p99),
         error(found.depth_max), std::to_string(found.points_lost)});
  }
  return cells;
}

/// Times and checks every method on the pairs of --pairs: a table, and a chart in --out.
inline void compare_box_methods(const Arguments& arguments)
{
  check_place(arguments.out / "box_compare.svg");
  const BoxPairLists given = own_box_pairs(arguments);
  const std::vector<MeasuredBoxMethod> methods = compared_methods(given, {});
  const BoxAccuracy& first = methods[0].accuracy;
  std::cout << given.in_float.size() << " pairs; " << first.compared << " overlap, " << first.rest
            << " rest face on face.\nErrors are parts of a pair's size. Points are lost where they "
               "span less "
               "than 99 % of\nwhat two resting faces have in common.\n\n"
            << text_table(compared_table(methods)) << '\n'
            << measure::machine_line() << '\n';
  plot::Chart chart(
      "box_compare", "Your pairs of boxes: cost against error",
      {"time [ns a pair]", plot::Scale::log},
      {"error of the depth, 99 % below [1, of the size]", plot::Scale::log});
  chart.describe("Time of each method against the 99th percentile of its depth's error.");
  save_figure(
      arguments, "box_compare.svg",
      box_chart_svg(chart, box_points(methods, depth_error_of, same_depth)));
}

} // namespace cookbook
