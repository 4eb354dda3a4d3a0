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
  std::string name;
  double ns;             ///< [ns a pair]
  std::size_t faster_of; ///< a row; its own where there is none
};

/// A function of two boxes, called for all pairs.
template <class Method>
std::function<void()> for_all(const std::vector<BoxPair<float>>& pairs, const Method& method)
{
  return [&pairs, method]
  {
    for (const auto& [a, b] : pairs)
    {
      const auto answer = method(a, b);
      measure::keep(answer);
    }
  };
}

/// All steps on resting pairs, timed in one run.
inline std::vector<SpeedStep> measured_steps(std::size_t pairs, const measure::Effort& effort)
{
  const std::vector<BoxPair<float>> resting = box_workload("resting", pairs).pairs;
  const auto batch = std::make_shared<BoxBatch>(resting);
  const auto plain = [](const auto& a, const auto& b) { return face_clipping(a, b); };
  const auto by_rows = [](const auto& a, const auto& b) { return box_box(a, b); };
  const auto fast = [](const auto& a, const auto& b) { return box_box_in_registers(a, b); };
  TimedColumn column;
  column.add("manifold, clipped line by line", false, for_all(resting, plain), pairs);
  column.add("manifold, four edges at a time", false, for_all(resting, by_rows), pairs);
  column.add("the same in registers", false, for_all(resting, fast), pairs);
  std::vector<std::size_t> faster_of{0, 0, 1};
  for (const InstructionSet set : instruction_sets())
  {
    column.add(
        "manifolds of many pairs, " + name_of(set), false, run_batch(batch, set, false), pairs);
    faster_of.push_back(2);
  }
  std::vector<SpeedStep> steps;
  for (const measure::Timing& timing : measure::time_interleaved(column.timed, effort))
  {
    steps.push_back({timing.name, timing.ns, faster_of[steps.size()]});
  }
  return steps;
}

/// The steps as a table in HTML.
inline std::string steps_html(const std::vector<SpeedStep>& steps)
{
  Cells cells{{"resting boxes, float", "[ns a pair]", "times as fast as", ""}};
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    const SpeedStep& before = steps[steps[i].faster_of];
    const bool first = steps[i].faster_of == i;
    cells.push_back(
        {steps[i].name, rounded(steps[i].ns), first ? "" : before.name,
         first ? "" : rounded(before.ns / steps[i].ns)});
  }
  return html_table(cells);
}

} // namespace cookbook
