#pragma once

/// \file
/// \brief What the chart of speed against accuracy says in words and tables.

#include "tools/measure/pareto.hpp"
#include "tools/measure/statistics.hpp"
#include "tools/program/table.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

namespace cookbook
{

/// What was measured of a method, in cache.
struct MeasuredMethod
{
  std::string name;
  bool peer;                       ///< whether it is another library's
  std::array<double, 3> ns;        ///< [ns a pair], on mixed, touching and apart pairs
  measure::ErrorStatistics errors; ///< of the depth [ulp of the larger radius], on mixed pairs
};

/// What was measured of a method with its pairs in memory.
struct MeasuredStream
{
  std::string name;
  double ns;    ///< [ns a pair]
  double bytes; ///< read and written a pair
};

// [method_fails]
/// Whether a method is useless: a tenth of the larger radius off, or wrong about touching.
inline bool method_fails(const MeasuredMethod& method)
{
  constexpr double tenth = 0.1 * 0x1p23; // [ulp]: a radius has at least 2^23 of them
  return !(method.errors.maximum < tenth);
}
// [method_fails]

/// Costs on mixed pairs and largest errors, as the Pareto front needs them.
inline std::vector<measure::CostAndError>
costs_and_errors(const std::vector<MeasuredMethod>& methods)
{
  std::vector<measure::CostAndError> points;
  for (const MeasuredMethod& method : methods)
  {
    points.push_back(
        {method.ns[0],
         method_fails(method) ? std::numeric_limits<double>::infinity() : method.errors.maximum});
  }
  return points;
}

// [knee_sentence]
/// The sentence under the chart: where the knee is, and what more accuracy costs.
inline std::string knee_sentence(const std::vector<MeasuredMethod>& methods)
{
  const auto points = costs_and_errors(methods);
  const auto front = measure::pareto_front(points);
  const MeasuredMethod& best = methods[measure::knee(points, front, 1e-3)];
  const MeasuredMethod& finest = methods[front.back()];
  std::string sentence = "The knee is at " + best.name + ": " + rounded(best.ns[0]) +
                         " ns a pair, at most " + rounded(best.errors.maximum) +
                         " ulp of the larger radius off";
  if (best.name != finest.name)
  {
    sentence += "; the most accurate, " + finest.name + ", takes " +
                rounded(finest.ns[0] / best.ns[0]) + " times as long";
  }
  return sentence + ".";
}
// [knee_sentence]

/// The times in cache as a table in HTML, each beside the ratio to the fastest peer.
inline std::string times_html(const std::vector<MeasuredMethod>& methods)
{
  Cells cells{
      {"method", "mixed [ns]", "× peer", "touching [ns]", "× peer", "apart [ns]", "× peer",
       "99 % of errors [ulp]", "largest error [ulp]"}};
  for (const MeasuredMethod& method : methods)
  {
    std::vector<std::string> row{method.name};
    for (std::size_t w = 0; w < 3; ++w)
    {
      row.push_back(rounded(method.ns[w]));
      row.push_back(rounded(measure::fastest_peer(methods, w) / method.ns[w]));
    }
    row.push_back(rounded(method.errors.p99));
    row.push_back(method_fails(method) ? "fails" : rounded(method.errors.maximum));
    cells.push_back(row);
  }
  return html_table(cells);
}

/// The times from memory as a table in HTML; the last stream is the plain copy.
inline std::string streams_html(const std::vector<MeasuredStream>& streams)
{
  Cells cells{{"from memory", "[ns a pair]", "[GB/s]", "of a plain copy"}};
  const MeasuredStream& copy = streams.back();
  for (const MeasuredStream& stream : streams)
  {
    const double rate = stream.bytes / stream.ns;
    cells.push_back(
        {stream.name, rounded(stream.ns), rounded(rate),
         rounded(100 * rate / (copy.bytes / copy.ns)) + " %"});
  }
  return html_table(cells);
}

} // namespace cookbook
