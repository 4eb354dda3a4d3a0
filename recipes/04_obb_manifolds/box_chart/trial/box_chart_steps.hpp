#pragma once

/// \file
/// \brief What each change for speed brought: resting boxes by the plain text and by the fast one.

#include "04_obb_manifolds/box_box/box_box_in_registers.hpp"
#include "04_obb_manifolds/box_chart/trial/box_chart.hpp"
#include "04_obb_manifolds/box_chart/trial/box_chart_measure.hpp"
#include "04_obb_manifolds/face_clipping/face_clipping.hpp"

#include <string>
#include <vector>

namespace cookbook
{

/// What something costs, and of which earlier row it is the faster form.
struct SpeedStep
{
  measure::Timing timing; ///< of a pair
  std::size_t faster_of;  ///< a row; its own where there is none
};

/// All steps on resting pairs, timed in one run.
inline std::vector<SpeedStep> measured_steps(std::size_t pairs, const measure::Effort& effort)
{
  const std::vector<BoxPair<float>> resting = box_workload("resting", pairs).pairs;
  const auto batch = std::make_shared<BoxBatch>(resting);
  const auto plain = [](const auto& a, const auto& b) { return face_clipping(a, b); };
  const auto by_rows = [](const auto& a, const auto& b) { return box_box(a, b); };
  const auto fast = [](const auto& a, const auto& b) { return box_box_in_registers(a, b); };
  const double count = static_cast<double>(pairs);
  const auto on_all = [&](const std::string& name, const auto& method)
  {
    return measure::timed_over(
        name, resting,
        [method](const BoxPair<float>& pair) { return method(pair.first, pair.second); });
  };
  std::vector<measure::Timed> timed{
      on_all("manifold, clipped line by line", plain),
      on_all("manifold, four edges at a time", by_rows), on_all("the same in registers", fast)};
  std::vector<std::size_t> faster_of{0, 0, 1};
  for (const InstructionSet set : instruction_sets())
  {
    timed.push_back(
        {"manifolds of many pairs, " + name_of(set), run_batch(batch, set, false), count});
    faster_of.push_back(2);
  }
  std::vector<SpeedStep> steps;
  for (const measure::Timing& timing : measure::time_interleaved(timed, effort))
  {
    steps.push_back({timing, faster_of[steps.size()]});
  }
  return steps;
}

/// The steps as a table.
inline Cells steps_table(const std::vector<SpeedStep>& steps)
{
  Cells cells{{"resting boxes, float", "[ns a pair]", "times as fast as", ""}};
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    const measure::Timing &before = steps[steps[i].faster_of].timing, &timing = steps[i].timing;
    const bool first = steps[i].faster_of == i;
    cells.push_back(
        {timing.name, measure::time_text(timing.ns), first ? "" : before.name,
         first ? "" : rounded(before.ns / timing.ns)});
  }
  return cells;
}

} // namespace cookbook
