#pragma once

/// \file
/// \brief Tables of times, several workloads wide, with the fastest peer beside each.

#include "tools/measure/timing.hpp"
#include "tools/program/table.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace cookbook::measure
{

/// What a method takes on each workload.
using TimingRow = std::vector<Timing>;

/// Appends the times on one more workload; the first makes the rows.
void add_column(std::vector<TimingRow>& rows, const std::vector<Timing>& timings);

/// The least time that any peer takes on a workload [ns]; infinite without peers.
double fastest_peer(const std::vector<TimingRow>& rows, std::size_t workload);

/// The rows as a table; beside each time how many times as fast as the fastest peer that is.
Cells times_table(
    const std::string& what, const std::vector<std::string>& workloads,
    const std::vector<TimingRow>& rows);

} // namespace cookbook::measure
