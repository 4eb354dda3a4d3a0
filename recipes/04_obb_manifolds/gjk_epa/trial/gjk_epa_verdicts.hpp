#pragma once

/// \file
/// \brief The verdict on each way to run GJK and EPA at each case, and their table.

#include "04_obb_manifolds/gjk_epa/trial/gjk_epa_box_cases.hpp"
#include "04_obb_manifolds/gjk_epa/trial/gjk_epa_cases.hpp"
#include "04_obb_manifolds/gjk_epa/trial/gjk_epa_pitfalls.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

namespace cookbook
{

/// A method by name, in both number types: the depth [m], or nothing where the shapes are apart.
struct ConvexMethod
{
  std::string name;                                                          ///< of its function
  std::function<std::optional<float>(const ConvexPair<float>&)> in_float;    ///< in float
  std::function<std::optional<double>(const ConvexPair<double>&)> in_double; ///< in double
};

/// A method from a function object that is called with a support, a direction and a tolerance.
template <class Method>
ConvexMethod convex_method(const std::string& name, const Method& method)
{
  const auto on_pair = [method](const auto& pair)
  { return method(pair.support, pair.start, tolerance_of(pair)); };
  return {name, on_pair, on_pair};
}

/// All methods: ours first.
inline std::vector<ConvexMethod> convex_methods()
{
  return {
      convex_method("gjk_epa", [](const auto&... given) { return convex_depth(given...); }),
      convex_method(
          "absolute_tolerance", [](const auto&... given) { return absolute_tolerance(given...); }),
      convex_method("no_rebuild", [](const auto&... given) { return no_rebuild(given...); }),
      convex_method(
          "two_tolerances", [](const auto&... given) { return two_tolerances(given...); })};
}

/// Right if the shapes are found apart, where `depth` [m] is negative, or as deep as that.
inline Verdict verdict_on_depth(const std::optional<double>& answer, double depth, double tolerance)
{
  const auto told = [](const std::optional<double>& x)
  { return x ? "depth " + number(*x) : "apart"; };
  const bool holds = depth < 0 ? !answer : answer && std::abs(*answer - depth) <= tolerance;
  const std::string right = told(depth < 0 ? std::nullopt : std::optional(depth));
  return {holds, told(answer) + (holds ? "" : ", not " + right)};
}

/// How many random pairs of cubes [1] a method is asked about for the table.
inline constexpr int random_cubes = 50'000;

/// Right if no pair of random cubes whose gap or depth is more than 0.1 mm is decided wrongly, or
/// has a depth that is off by as much, in float.
inline Verdict verdict_on_cubes(const ConvexMethod& method, int pairs)
{
  RandomCubes draw(1);
  int wrong = 0;
  for (int i = 0; i < pairs; ++i)
  {
    const Obb<double> a = draw.next(), b = draw.next();
    const double separation = largest_separation(a, b);
    const auto answer = method.in_float(convex_pair(to_float(a), to_float(b)));
    const bool right =
        separation > 0 ? !answer : answer && std::abs(double(*answer) + separation) <= 1e-4;
    wrong += !right && std::abs(separation) > 1e-4 ? 1 : 0;
  }
  const std::string of = " of " + std::to_string(pairs) + " wrong";
  return {wrong == 0, wrong == 0 ? "none wrong" : std::to_string(wrong) + of};
}

/// A case: its id, its scene, and the verdict on a method.
struct ConvexCase
{
  std::string id;                                      ///< as in [case:K1]
  std::string scene;                                   ///< one line
  std::function<Verdict(const ConvexMethod&)> verdict; ///< on a method
};

/// Two boxes, in double.
inline ConvexCase boxes_case(const BoxCase& pair)
{
  const auto verdict = [=](const ConvexMethod& method)
  {
    return verdict_on_depth(
        method.in_double(convex_pair(pair.a, pair.b)), pair.depth, pair.tolerance);
  };
  return {pair.id, pair.scene, verdict};
}

/// All cases; a neighbour such as K2-b has no id of its own in the table.
inline std::vector<ConvexCase> convex_cases()
{
  const auto capsule = [](const ConvexMethod& method)
  { return verdict_on_depth(method.in_float(capsule_in_box()), capsule_in_box_depth, 1e-3); };
  const auto spheres = [](const ConvexMethod& method)
  { return verdict_on_depth(method.in_double(two_spheres()), two_spheres_depth, 1e-3); };
  const auto cubes = [](const ConvexMethod& method)
  { return verdict_on_cubes(method, random_cubes); };
  std::vector<ConvexCase> cases{
      boxes_case(case_of(size_cases(), "G14")),
      boxes_case(case_of(face_cases(), "G15")),
      {"K1", "a capsule deep in a box, in float", capsule},
      {"K1-b", "two spheres, deep", spheres}};
  for (const BoxCase& pair : level_cases())
  {
    cases.push_back(boxes_case(pair));
  }
  cases.push_back({"K4", "random cubes, in float", cubes});
  return cases;
}

/// What all methods make of all cases.
inline std::vector<VerdictRow> convex_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const ConvexCase& one : convex_cases())
  {
    VerdictRow row{one.id.back() == 'b' ? "" : one.id, one.scene, {}};
    for (const ConvexMethod& method : convex_methods())
    {
      row.verdicts.push_back(one.verdict(method));
    }
    rows.push_back(row);
  }
  return rows;
}

} // namespace cookbook
