#pragma once

/// \file
/// \brief Boxes that move and turn, and what each way to find their first touch makes of them.

#include "05_resolution/tunnelling/trial/tunnelling_box_scenes.hpp"
#include "05_resolution/tunnelling/trial/tunnelling_pitfalls.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to find the time, 0 to 1, of the first touch of two boxes.
struct BoxSweepMethod
{
  std::string name;                                            ///< as on the page
  std::function<std::optional<double>(const BoxSweep&)> found; ///< 0 to 1
  bool runs_on = false; ///< whether finding nothing means that it never ends
};

/// The gap [m] at which boxes touch.
inline constexpr double box_touching = 1e-6;

/// The ways that compete; the last is the one to take.
inline std::vector<BoxSweepMethod> box_sweep_methods()
{
  return {
      {"overlap at the end", [](const BoxSweep& sweep) { return touch_at_end(sweep.a, sweep.b); }},
      {"halving, unchecked",
       [](const BoxSweep& sweep)
       { return touch_by_halving(sweep.a, sweep.b, box_touching, 10000); },
       true},
      {"turning left out",
       [](const BoxSweep& sweep) { return touch_without_turning(sweep.a, sweep.b, box_touching); }},
      {"swept_boxes", [](const BoxSweep& sweep)
       {
         const auto hit = swept_boxes(sweep.a, sweep.b, box_touching);
         return hit ? std::optional(hit->time) : std::nullopt;
       }}};
}

/// What became of a method with a pair of boxes: its time is to be right to 0.1 ms.
inline Verdict box_sweep_verdict(const BoxSweep& sweep, const BoxSweepMethod& method)
{
  const std::optional<double> found = method.found(sweep);
  if (!found && method.runs_on)
  {
    return {false, "never ends"};
  }
  const bool same = found.has_value() == sweep.time.has_value() &&
                    (!found || std::abs(*found * sweep.duration - *sweep.time) <= 1e-4);
  const std::string time = found ? number(*found * sweep.duration) + " s" : "no touch";
  return {same, time};
}

/// The verdicts on all pairs of boxes.
inline std::vector<VerdictRow> box_sweep_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const BoxSweep& sweep : box_sweeps())
  {
    rows.push_back({sweep.id, sweep.what, {}});
    for (const BoxSweepMethod& method : box_sweep_methods())
    {
      rows.back().verdicts.push_back(box_sweep_verdict(sweep, method));
    }
  }
  return rows;
}

} // namespace cookbook
