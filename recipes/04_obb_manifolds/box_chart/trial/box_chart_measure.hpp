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
  std::size_t in_cache = 2048;     ///< pairs
  std::size_t for_errors = 10'000; ///< pairs
  measure::Effort effort{};        ///< for each workload
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
    methods.push_back({{}, box_accuracy(each.checks(random)), each.steadiness(resting)});
  }
  for (const std::string& workload : timed_workloads)
  {
    const BoxPairLists lists = box_pair_lists(box_workload(workload, extent.in_cache).pairs);
    const std::vector<measure::Timing> times = box_times(all, lists, extent.effort);
    for (std::size_t m = 0; m < all.size(); ++m)
    {
      methods[m].times.push_back(times[m]);
    }
  }
  return methods;
}

/// Only whether boxes touch.
inline std::vector<measure::Timing>
overlap_times(const std::string& workload, const BoxExtent& extent)
{
  const BoxPairLists lists = box_pair_lists(box_workload(workload, extent.in_cache).pairs);
  const auto batch = std::make_shared<BoxBatch>(lists.in_float);
  const double count = static_cast<double>(extent.in_cache);
  std::vector<measure::Timed> timed;
  for (const InstructionSet set : instruction_sets())
  {
    timed.push_back({"box_pairs_touch, " + name_of(set), run_batch(batch, set, true), count});
  }
#if defined(COOKBOOK_HAS_ODE)
  const auto ode = std::make_shared<OdeBoxPairs>(lists.in_double);
  timed.push_back({"ODE, overlap only", [ode] { ode->run_overlaps(); }, count, true});
#endif
  return measure::time_interleaved(timed, extent.effort);
}

/// The decision on random pairs beside the peak of each instruction set's registers.
inline Cells peak_table(const BoxExtent& extent)
{
  const auto batch = std::make_shared<BoxBatch>(box_workload("random", extent.in_cache).pairs);
  std::vector<measure::Timed> timed;
  std::vector<measure::AtLeast> limits;
  for (const InstructionSet set : instruction_sets())
  {
    const std::size_t lanes = set == InstructionSet::avx512 ? 16
                              : set == InstructionSet::avx2 ? 8
                                                            : 4;
    timed.push_back(
        {"box_pairs_touch, " + name_of(set), run_batch(batch, set, true), double(extent.in_cache)});
    timed.push_back(measure::peak_flops(lanes));
    limits.push_back({timed[timed.size() - 2].name, timed.back().name, overlap_operations});
  }
  const auto timings = measure::time_interleaved(timed, extent.effort, limits);
  Cells cells{{"of the peak, random", "[ns a pair]", "[Gflop/s]", "peak [Gflop/s]", "fraction"}};
  for (std::size_t i = 0; i < timings.size(); i += 2)
  {
    cells.push_back(peak_row(timings[i].name, timings[i].ns, timings[i + 1].ns));
  }
  return cells;
}

} // namespace cookbook
