#pragma once

/// \file
/// \brief The methods that the table of failing cases compares, and the table's three parts.

#include "04_obb_manifolds/box_failures/trial/box_verdicts.hpp"

#include <set>
#include <string>
#include <vector>

namespace cookbook
{

/// One part of the table: methods that are checked in the same way.
struct VerdictPart
{
  std::string name;                                                    ///< of its figure
  std::string caption;                                                 ///< above the table
  std::vector<BoxMethod> methods;                                      ///< its columns
  Verdict (*verdict)(const BoxCase&, const std::optional<BoxAnswer>&); ///< on each answer
  std::set<std::string> telling; ///< ids of the cases that the page shows unfolded
};

/// The whole table.
std::vector<VerdictPart> verdict_parts();

/// The verdict on a method at a case. One that answers in float is held to a millionth of all half
/// extents together.
inline Verdict verdict_of(const VerdictPart& part, const BoxMethod& method, BoxCase pair)
{
  const std::optional<BoxAnswer> answer = method.answer(pair);
  const double size = pair.a.half_extents.sum() + pair.b.half_extents.sum();
  pair.tolerance = std::max(pair.tolerance, method.in_float ? 1e-6 * size : 0);
  return part.verdict(pair, answer);
}

/// How many random pairs of cubes [1] a method decides on for the table.
inline constexpr int decided_cubes = 20'000;

/// Right if no pair of random cubes whose gap or depth is more than 0.1 mm is decided wrongly, in
/// float; where points are asked for, a yes needs one.
inline Verdict verdict_on_decisions(const BoxMethod& method, bool needs_points)
{
  RandomCubes draw(1);
  int wrong = 0;
  for (int i = 0; i < decided_cubes; ++i)
  {
    BoxCase pair{"K4", "", draw.next(), draw.next(), 0, {0, 0, 0}, {}};
    pair.numbers = BoxNumbers::in_float;
    const double separation = largest_separation(pair.a, pair.b);
    const std::optional<BoxAnswer> answer = method.answer(pair);
    const bool touching = answer && (!needs_points || !answer->points.empty());
    wrong += std::abs(separation) > 1e-4 && touching != (separation < 0) ? 1 : 0;
  }
  return {wrong == 0, wrong == 0 ? "none wrong" : std::to_string(wrong) + " wrong"};
}

/// Which cases.
enum class CaseChoice
{
  all,
  telling, ///< those that tell most
  others,  ///< all but these
};

/// What the methods make of the cases.
std::vector<VerdictRow> verdict_rows(const VerdictPart& part, CaseChoice choice = CaseChoice::all);

} // namespace cookbook
