#pragma once

/// \file
/// \brief What share of a core's peak the batches of boxes reach.

#include "04_obb_manifolds/box_chart/trial/batch_and_memory.hpp"
#include "04_obb_manifolds/box_chart/trial/box_chart.hpp"
#include "04_obb_manifolds/box_chart/trial/box_flops.hpp"
#include "tools/measure/peak.hpp"

#include <memory>
#include <string>
#include <vector>

namespace cookbook
{

/// What an instruction set's registers hold, in floats.
inline std::size_t lanes_of(InstructionSet set)
{
  return set == InstructionSet::avx512 ? 16 : set == InstructionSet::avx2 ? 8 : 4;
}

/// The batches on pairs of a workload, beside the peak of their registers, timed in one run.
inline std::vector<MeasuredShare> measured_shares(
    const std::string& workload, bool only_touch, std::size_t pairs, const measure::Effort& effort)
{
  const BoxPairLists lists = box_pair_lists(box_workload(workload, pairs).pairs);
  const auto batch = std::make_shared<BoxBatch>(lists.in_float);
  const double count = static_cast<double>(pairs);
  double flops = 0;
  for (const auto& [a, b] : lists.in_float)
  {
    const BoxFlops pair = box_flops(a, b);
    flops += static_cast<double>(only_touch ? pair.overlaps : pair.all) / count;
  }
  const std::string name = only_touch ? "box_pairs_touch, " : "box_pairs, ";
  std::vector<measure::Timed> timed;
  for (const InstructionSet set : instruction_sets())
  {
    timed.push_back({name + name_of(set), run_batch(batch, set, only_touch), count});
    timed.push_back(measure::peak_flops(lanes_of(set)));
  }
  const auto timings = measure::time_interleaved(timed, effort);
  std::vector<MeasuredShare> shares;
  for (std::size_t i = 0; i < timings.size(); i += 2)
  {
    shares.push_back({timings[i].name + ", " + workload, timings[i].ns, flops, timings[i + 1].ns});
  }
  return shares;
}

} // namespace cookbook
