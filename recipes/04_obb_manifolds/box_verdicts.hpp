#pragma once

/// \file
/// \brief The verdict on each method of testing two boxes at each case, and their table.

#include "04_obb_manifolds/box_cases.hpp"
#include "04_obb_manifolds/box_pitfalls.hpp"
#include "common/program/table.hpp"
#include "common/program/verdicts.hpp"

#include <functional>
#include <string>
#include <vector>

namespace cookbook
{

// [verdict]
/// What is right to within this [m] is right: far above rounding, far below every wrong answer.
inline constexpr double verdict_tolerance = 1e-6;

/// Right if the decision, the depth and, where there is only one, the normal are.
inline Verdict
verdict_on_overlap(const BoxCase& pair, const std::optional<LeastOverlap<double>>& answer)
{
  const bool apart = pair.depth < 0;
  if (apart || !answer)
  {
    return {apart == !answer, answer ? "overlap " + number(answer->depth) : "apart"};
  }
  if (!(std::abs(answer->depth - pair.depth) <= verdict_tolerance))
  {
    const double said = answer->depth < verdict_tolerance ? 0 : answer->depth;
    return {false, "depth " + number(said) + ", not " + number(pair.depth)};
  }
  const bool turned = !pair.normal.isZero() &&
                      (answer->normal - pair.normal).cwiseAbs().maxCoeff() > verdict_tolerance;
  return {!turned, turned ? "normal wrong" : "depth " + number(pair.depth)};
}

/// Right if every contact is found and no other; where any will do, if there is at least one.
inline Verdict verdict_on_points(const BoxCase& pair, const std::vector<Vector3<double>>& points)
{
  const auto is_found = [&](const Vector3<double>& contact)
  {
    return std::any_of(
        points.begin(), points.end(),
        [&](const Vector3<double>& point)
        { return (point - contact).norm() <= verdict_tolerance; });
  };
  const std::vector<Vector3<double>>& right = pair.contacts;
  const std::string count = number(static_cast<double>(points.size()));
  if (pair.depth < 0)
  {
    return {points.empty(), points.empty() ? "no points" : count + " points"};
  }
  const bool holds = right.empty() ? !points.empty()
                                   : points.size() == right.size() &&
                                         std::all_of(right.begin(), right.end(), is_found);
  const std::string wanted =
      holds || right.empty() ? "" : ", not " + number(static_cast<double>(right.size()));
  return {holds, count + (count == "1" ? " point" : " points") + wanted};
}
// [verdict]

/// A method by name.
struct BoxMethod
{
  std::string name;                               ///< of its function
  std::function<Verdict(const BoxCase&)> verdict; ///< on a case
};

/// A method that answers with the least overlap.
inline BoxMethod overlap_method(
    const std::string& name,
    std::optional<LeastOverlap<double>> (*method)(const Obb<double>&, const Obb<double>&))
{
  return {name, [method](const BoxCase& pair) {
            return verdict_on_overlap(pair, method(pair.a, pair.b));
          }};
}

/// The contact positions [m] of a manifold; none where the boxes are apart.
inline std::vector<Vector3<double>> clipped_points(const Obb<double>& a, const Obb<double>& b)
{
  std::vector<Vector3<double>> points;
  if (const auto manifold = edge_clipping(a, b))
  {
    for (const ContactPoint<double>& point : manifold->points)
    {
      points.push_back(point.position);
    }
  }
  return points;
}

/// All methods: those that decide, then those that find points.
inline std::vector<BoxMethod> box_methods()
{
  return {
      overlap_method("separating_axes", separating_axes<double>),
      overlap_method("six_axes", six_axes<double>),
      overlap_method("unnormalized_axes", unnormalized_axes<double>),
      overlap_method("short_reach_axes", short_reach_axes<double>),
      overlap_method("union_depth", union_depth<double>),
      {"edge_clipping",
       [](const BoxCase& pair) { return verdict_on_points(pair, clipped_points(pair.a, pair.b)); }},
      {"untolerant_points", [](const BoxCase& pair)
       { return verdict_on_points(pair, untolerant_points(pair.a, pair.b)); }}};
}

/// What all methods make of all cases; a neighbour such as G9b has no id of its own in the table.
inline std::vector<VerdictRow> box_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const BoxCase& pair : box_cases())
  {
    const bool neighbour = pair.id.back() == 'b';
    VerdictRow row{neighbour ? "" : pair.id, pair.scene, {}};
    for (const BoxMethod& method : box_methods())
    {
      row.verdicts.push_back(method.verdict(pair));
    }
    rows.push_back(row);
  }
  return rows;
}

/// The names of all methods, in the order of the verdicts.
inline std::vector<std::string> box_method_names()
{
  std::vector<std::string> names;
  for (const BoxMethod& method : box_methods())
  {
    names.push_back(method.name);
  }
  return names;
}

} // namespace cookbook
