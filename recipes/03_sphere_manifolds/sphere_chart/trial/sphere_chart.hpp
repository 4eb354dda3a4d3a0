#pragma once

/// \file
/// \brief What the chart of speed against accuracy says in words and tables.

#include "tools/measure/statistics.hpp"
#include "tools/measure/times_table.hpp"

#include <vector>

namespace cookbook
{

/// What was measured of a method, in cache.
struct MeasuredMethod
{
  measure::TimingRow times;        ///< on mixed, touching and separate pairs
  measure::ErrorStatistics errors; ///< of the depth [ulp of the larger radius], on mixed pairs
};

// [useless_error]
/// A method is useless that is a tenth of the larger radius off, or wrong about touching.
constexpr double useless_error = 0.1 * 0x1p23; // [ulp]: a radius has at least 2^23 of them
// [useless_error]

/// The times in cache as a table, each beside the ratio to the fastest peer, and the errors.
inline Cells methods_table(const std::vector<MeasuredMethod>& methods)
{
  std::vector<measure::TimingRow> times;
  for (const MeasuredMethod& method : methods)
  {
    times.push_back(method.times);
  }
  Cells cells = measure::times_table("method", {"mixed", "touching", "separate"}, times);
  cells[0].insert(cells[0].end(), {"99 % of errors [ulp]", "largest error [ulp]"});
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    const measure::ErrorStatistics& errors = methods[i].errors;
    cells[i + 1].push_back(rounded(errors.p99));
    cells[i + 1].push_back(errors.maximum < useless_error ? rounded(errors.maximum) : "fails");
  }
  return cells;
}

/// The times from memory as a table, of pairs with so many bytes; the last stream is the plain
/// copy.
inline Cells streams_table(const std::vector<measure::Timing>& streams, double bytes)
{
  Cells cells{{"from memory", "[ns a pair]", "[GB/s]", "of a plain copy"}};
  for (const measure::Timing& stream : streams)
  {
    cells.push_back(
        {stream.name, measure::time_text(stream.ns), rounded(bytes / stream.ns),
         rounded(100 * streams.back().ns / stream.ns) + " %"});
  }
  return cells;
}

} // namespace cookbook
