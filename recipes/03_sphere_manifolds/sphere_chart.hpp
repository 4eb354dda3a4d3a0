#pragma once

/// \file
/// \brief What the chart of speed against accuracy says in words and tables.

#include "common/measure/pareto.hpp"
#include "common/measure/statistics.hpp"
#include "common/program/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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

/// The least time that any peer takes on a workload [ns]; infinite without peers.
inline double fastest_peer(const std::vector<MeasuredMethod>& methods, std::size_t workload)
{
  double least = std::numeric_limits<double>::infinity();
  for (const MeasuredMethod& method : methods)
  {
    least = method.peer ? std::min(least, method.ns[workload]) : least;
  }
  return least;
}

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

/// A number rounded to two significant digits, for sentences and tables.
inline std::string rounded(double value)
{
  if (!std::isfinite(value) || value <= 0)
  {
    return std::isfinite(value) ? "0" : "–";
  }
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return number(std::round(value / unit) * unit);
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
  std::string html = "<table class=\"doxtable\"><tr><th>method</th><th>mixed [ns]</th><th>× peer"
                     "</th><th>touching [ns]</th><th>× peer</th><th>apart [ns]</th><th>× peer</th>"
                     "<th>99 % of errors [ulp]</th><th>largest error [ulp]</th></tr>\n";
  for (const MeasuredMethod& method : methods)
  {
    html += "<tr><td>" + method.name + "</td>";
    for (std::size_t w = 0; w < 3; ++w)
    {
      html += "<td>" + rounded(method.ns[w]) + "</td><td>" +
              rounded(fastest_peer(methods, w) / method.ns[w]) + "</td>";
    }
    html += "<td>" + rounded(method.errors.p99) + "</td><td>" +
            (method_fails(method) ? "fails" : rounded(method.errors.maximum)) + "</td></tr>\n";
  }
  return html + "</table>\n";
}

/// The times from memory as a table in HTML; the last stream is the plain copy.
inline std::string streams_html(const std::vector<MeasuredStream>& streams)
{
  std::string html = "<table class=\"doxtable\"><tr><th>from memory</th><th>[ns a pair]</th>"
                     "<th>[GB/s]</th><th>of a plain copy</th></tr>\n";
  const MeasuredStream& copy = streams.back();
  for (const MeasuredStream& stream : streams)
  {
    const double rate = stream.bytes / stream.ns;
    html += "<tr><td>" + stream.name + "</td><td>" + rounded(stream.ns) + "</td><td>" +
            rounded(rate) + "</td><td>" + rounded(100 * rate / (copy.bytes / copy.ns)) +
            " %</td></tr>\n";
  }
  return html + "</table>\n";
}

} // namespace cookbook
