#pragma once

/// \file
/// \brief Measures every method for two boxes beside other libraries.

#include "04_obb_manifolds/box_chart/trial/batch_and_memory.hpp"
#include "04_obb_manifolds/box_chart/trial/box_chart.hpp"
#include "04_obb_manifolds/box_chart/trial/box_chart_peers.hpp"
#include "tools/measure/peak.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

/// How much is measured.
struct BoxExtent
{
  std::size_t in_cache = 2048;       ///< pairs
  std::size_t in_memory = 1'000'000; ///< pairs
  std::size_t for_errors = 10'000;   ///< pairs
  measure::Effort cache{11, 0.005};  ///< for each workload
  measure::Effort memory{5, 0.005};  ///< for each workload
};

/// What is timed in cache.
inline const std::vector<std::string> timed_workloads{"random",    "near-parallel", "resting",
                                                      "edge-edge", "deep",          "thin plates"};

/// All that the chart shows.
inline std::vector<TimedMethod> chart_contenders()
{
  std::vector<TimedMethod> all = own_contenders();
  all.push_back(memory_contender<float>("feature_memory, float"));
  all.push_back(memory_contender<double>("feature_memory, double"));
  for (const InstructionSet set : instruction_sets())
  {
    all.push_back(batch_contender(set));
  }
  const std::vector<TimedMethod> peers = box_peers();
  all.insert(all.end(), peers.begin(), peers.end());
  return all;
}

/// All methods, in cache, with what they get wrong.
inline std::vector<MeasuredBoxMethod> measured_methods(const BoxExtent& extent)
{
  const std::vector<TimedMethod> all = chart_contenders();
  const BoxPairLists random = box_pair_lists(box_workload("random", extent.for_errors).pairs);
  const BoxWorkload resting = box_workload("resting", extent.for_errors / 4);
  std::vector<MeasuredBoxMethod> methods;
  for (const TimedMethod& each : all)
  {
    methods.push_back(
        {{each.name, each.peer, {}}, box_accuracy(each.checks(random)), each.steadiness(resting)});
  }
  for (const std::string& workload : timed_workloads)
  {
    const BoxPairLists lists = box_pair_lists(box_workload(workload, extent.in_cache).pairs);
    const std::vector<double> ns = box_times(all, lists, extent.cache);
    for (std::size_t m = 0; m < all.size(); ++m)
    {
      methods[m].times.ns.push_back(ns[m]);
    }
  }
  return methods;
}

/// One column of a table of times: what is timed, and which of it is a peer.
struct TimedColumn
{
  std::vector<measure::Timed> timed; ///< what runs
  std::vector<bool> peer;            ///< of each: whether it is another library's

  /// Adds something that answers so many pairs.
  void add(const std::string& name, bool is_peer, std::function<void()> run, std::size_t pairs)
  {
    timed.push_back({name, std::move(run), static_cast<double>(pairs)});
    peer.push_back(is_peer);
  }

  /// Times all in one run, and appends what they take to their rows.
  void time_into(std::vector<MeasuredTimes>& rows, const measure::Effort& effort) const
  {
    const auto timings = measure::time_interleaved(timed, effort);
    for (std::size_t i = 0; i < timings.size(); ++i)
    {
      if (rows.size() == i)
      {
        rows.push_back({timings[i].name, peer[i], {}});
      }
      rows[i].ns.push_back(timings[i].ns);
    }
  }
};

/// Only whether boxes touch.
inline void time_overlaps(
    const std::string& workload, std::size_t pairs, const measure::Effort& effort,
    std::vector<MeasuredTimes>& rows)
{
  const BoxPairLists lists = box_pair_lists(box_workload(workload, pairs).pairs);
  const auto batch = std::make_shared<BoxBatch>(lists.in_float);
  TimedColumn column;
  for (const InstructionSet set : instruction_sets())
  {
    column.add("box_pairs_touch, " + name_of(set), false, run_batch(batch, set, true), pairs);
  }
#if defined(COOKBOOK_HAS_ODE)
  const auto ode = std::make_shared<OdeBoxPairs>(lists.in_double);
  column.add(
      "ODE, overlap only", true, [ode] { ode->run_overlaps(); }, pairs);
#endif
  column.time_into(rows, effort);
}

/// The decision on random pairs beside the peak of each instruction set's registers.
inline std::string peaks_html(const BoxExtent& extent)
{
  const auto batch = std::make_shared<BoxBatch>(box_workload("random", extent.in_cache).pairs);
  std::vector<measure::Timed> timed;
  for (const InstructionSet set : instruction_sets())
  {
    const std::size_t lanes = set == InstructionSet::avx512 ? 16
                              : set == InstructionSet::avx2 ? 8
                                                            : 4;
    timed.push_back(
        {"box_pairs_touch, " + name_of(set), run_batch(batch, set, true), double(extent.in_cache)});
    timed.push_back(measure::peak_flops(lanes));
  }
  const auto timings = measure::time_interleaved(timed, extent.cache);
  Cells cells{{"of the peak, random", "[ns a pair]", "[Gflop/s]", "peak [Gflop/s]", "fraction"}};
  for (std::size_t i = 0; i < timings.size(); i += 2)
  {
    cells.push_back(peak_row(timings[i].name, timings[i].ns, timings[i + 1].ns));
  }
  return html_table(cells);
}

/// Whole manifolds, with the pairs in memory.
inline void
time_streams(const std::string& workload, const BoxExtent& extent, std::vector<MeasuredTimes>& rows)
{
  const BoxPairLists lists = box_pair_lists(box_workload(workload, extent.in_memory).pairs);
  const auto batch = std::make_shared<BoxBatch>(lists.in_float);
  TimedColumn column;
  const TimedMethod scalar = own_contenders()[0];
  column.add(scalar.name, false, scalar.prepare(lists), extent.in_memory);
  for (const InstructionSet set : instruction_sets())
  {
    column.add("box_pairs, " + name_of(set), false, run_batch(batch, set, false), extent.in_memory);
  }
  for (const TimedMethod& peer : box_peers())
  {
    column.add(peer.name, true, peer.prepare(lists), extent.in_memory);
  }
  column.time_into(rows, extent.memory);
}

} // namespace cookbook
