#pragma once

/// \file
/// \brief What becomes of the cube inside the floor, way by way: speed, hop, jumps, rest.

#include "05_resolution/position_correction/trial/position_correction_scenes.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace cookbook
{

/// What happened until the overlap was gone.
struct Recovery
{
  double fastest; ///< [m/s], of the cube's own speed
  double highest; ///< [m], of its underside over the floor
  double jump;    ///< [m], the longest way of one frame
  double out;     ///< [s], when less than a centimetre of depth is left for good
  double first;   ///< [s], when so little was left for the first time
  double left;    ///< [m], depth at the end
};

/// Measures the frames of a recovery.
inline Recovery recovery(const std::vector<SunkCube>& rows)
{
  Recovery found{rows.back().fastest, rows.front().bottom, 0, 0, 0, -rows.back().bottom};
  const auto is_in = [](const SunkCube& cube) { return cube.bottom < -0.01; };
  const auto first = std::find_if_not(rows.begin(), rows.end(), is_in);
  found.first = double(first - rows.begin()) * frame_time;
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    found.highest = std::max(found.highest, rows[i].bottom);
    found.jump = std::max(found.jump, std::abs(rows[i].bottom - rows[i - 1].bottom));
    found.out = is_in(rows[i]) ? double(i + 1) * frame_time : found.out;
  }
  return found;
}

/// A case of the cube in the floor, and its oracle.
struct CorrectionCase
{
  std::string id;                                 ///< in the book, or empty
  std::string what;                               ///< in a few words
  SunkCube cube;                                  ///< as it starts
  double time;                                    ///< [s]
  std::function<Verdict(const Recovery&)> judged; ///< of a recovery
};

/// A number for a table: what is below a ten-thousandth is nothing.
inline std::string correction_number(double value)
{
  return number(std::round(value * 1e4) / 1e4);
}

/// S18: at most 4 m/s, never higher than on the floor, which is the energy m g d; out by the end.
inline Verdict comes_out_calmly(const Recovery& found)
{
  const bool holds = found.fastest <= 4 && found.highest <= 1e-6 && found.left <= 0.01;
  std::string text = correction_number(found.fastest);
  text.append(" m/s, ");
  return found.highest > 1e-6
             ? Verdict{holds, text.append("hops ").append(correction_number(found.highest + 0.5)) + " m"}
             : Verdict{
                   holds, text.append("out after ").append(correction_number(found.out)) + " s"};
}

/// No jump: less than 4 m/s of a way in any frame, however it is made.
inline Verdict never_jumps(const Recovery& found)
{
  return {found.jump <= 4 * frame_time, correction_number(found.jump) + " m in a frame"};
}

/// It ends on the floor and was never over it.
inline Verdict stays_on_floor(const Recovery& found)
{
  const std::string over = correction_number(found.highest) + " m over the floor";
  return {
      found.highest <= 1e-6 && found.left <= 0.01, found.highest > 1e-6 ? over : "on the floor"};
}

/// At rest, no deeper than a millimetre and a half.
inline Verdict rests(const Recovery& found)
{
  return {
      found.highest <= 1e-6 && found.left <= 1.5e-3,
      correction_number(1000 * found.left) + " mm deep"};
}

/// All cases.
inline std::vector<CorrectionCase> correction_cases()
{
  const SunkCube deep;
  SunkCube tiles, resting;
  tiles.impulses = {0, 0};
  resting.bottom = 0;
  return {
      {"S18", "cube 0.5 m deep: ≤ 4 m/s, no hop", deep, 2, comes_out_calmly},
      {"", "the same: no jump of more than 4 m/s", deep, 2, never_jumps},
      {"", "two tiles report it: ends on the floor", tiles, 2, stays_on_floor},
      {"", "cube at rest, 10 s: at most 1.5 mm deep", resting, 10, rests}};
}

/// The verdicts: a row for each case, a column for each way.
inline std::vector<VerdictRow> correction_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const CorrectionCase& one : correction_cases())
  {
    rows.push_back({one.id, one.what, {}});
    for (const Correction& way : corrections())
    {
      rows.back().verdicts.push_back(one.judged(recovery(run_out(one.cube, way, one.time))));
    }
  }
  return rows;
}

} // namespace cookbook
