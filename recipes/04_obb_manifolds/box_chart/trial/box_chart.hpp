#pragma once

/// \file
/// \brief What the chart of methods for two boxes says in words and tables.

#include "04_obb_manifolds/box_oracles/trial/method_times.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// Times on several workloads, each beside how many times as fast as the fastest peer that is.
inline std::string box_times_html(
    const std::string& what, const std::vector<std::string>& workloads,
    const std::vector<MeasuredTimes>& all)
{
  Cells cells{{what + " [ns a pair]"}};
  for (const std::string& workload : workloads)
  {
    cells[0].insert(cells[0].end(), {workload, "× peer"});
  }
  for (const MeasuredTimes& times : all)
  {
    cells.push_back({times.name});
    for (std::size_t w = 0; w < workloads.size(); ++w)
    {
      cells.back().push_back(rounded(times.ns[w]));
      cells.back().push_back(rounded(measure::fastest_peer(all, w) / times.ns[w]));
    }
  }
  return html_table(cells);
}

/// What the methods get wrong.
inline std::string box_errors_html(const std::vector<MeasuredBoxMethod>& methods)
{
  Cells cells{
      {"errors", "wrong verdicts", "99 % of depths [size]", "worst depth [size]",
       "99 % of jumps [size]", "1 % of areas [1]"}};
  for (const auto& [times, accuracy, steadiness] : methods)
  {
    cells.push_back(
        {times.name, std::to_string(accuracy.wrong + accuracy.not_finite),
         rounded(accuracy.depth_p99), rounded(accuracy.depth_max), rounded(steadiness.jump),
         rounded(steadiness.area)});
  }
  return html_table(cells);
}

/// The operations that the fifteen overlaps of a pair take: each +, − and ×.
///
/// B as A sees it: 9 entries of 5, an offset of 3, twice 3 of 5; 6 faces of 7; 9 edge axes of 14.
inline constexpr int overlap_operations = (9 * 5 + 3 + 2 * 3 * 5) + 6 * 7 + 9 * 14;

/// A decision [ns a pair] beside the peak of its core [ns an operation].
inline std::vector<std::string> peak_row(const std::string& name, double ns, double peak_ns)
{
  const double rate = overlap_operations / ns;
  return {
      name, rounded(ns), rounded(rate), rounded(1 / peak_ns), rounded(100 * rate * peak_ns) + " %"};
}

// [box_knee_sentence]
/// The sentence under a chart: where the knee is, what the cheapest method loses, and what less
/// than half the error costs.
inline std::string box_knee_sentence(
    const std::vector<MeasuredBoxMethod>& methods, const BoxErrorOf& error, std::size_t workload,
    const std::string& what)
{
  const auto points = box_costs_and_errors(methods, error, workload);
  const auto front = measure::pareto_front(points);
  const std::size_t knee = measure::knee(points, front, 1e-16);
  const auto told = [&](std::size_t i)
  {
    return methods[i].times.name + ", at " + rounded(points[i].cost) + " ns a pair, has " + what +
           " " + rounded(points[i].error) + " of the size";
  };
  std::string sentence = "The knee: " + told(knee);
  if (front.front() != knee)
  {
    sentence += ". The cheapest: " + told(front.front());
  }
  if (points[front.back()].error < points[knee].error / 2)
  {
    sentence += ". The finest: " + told(front.back());
  }
  return sentence + ".";
}
// [box_knee_sentence]

} // namespace cookbook
