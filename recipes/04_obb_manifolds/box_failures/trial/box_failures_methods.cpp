/// \file
/// \brief The methods that the table of failing cases compares, compiled once for the program and
/// its test.

#include "04_obb_manifolds/box_failures/trial/box_failures_methods.hpp"
#include "04_obb_manifolds/box_as_published/trial/box_as_published.hpp"
#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_failures/trial/box_pitfalls.hpp"
#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"
#include "04_obb_manifolds/box_pairs/box_pairs.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_overlap_truth.hpp"
#include "04_obb_manifolds/face_clipping/face_clipping.hpp"
#include "04_obb_manifolds/gjk_epa/gjk_epa.hpp"

#include <limits>
#include <type_traits>

namespace cookbook
{
namespace
{

/// Ways to find the axis of least overlap.
std::vector<BoxMethod> axis_methods()
{
  return {
      box_method(
          "separating_axes", [](const auto& a, const auto& b) { return separating_axes(a, b); }),
      box_method("six_axes", [](const auto& a, const auto& b) { return six_axes(a, b); }),
      box_method(
          "unnormalized_axes",
          [](const auto& a, const auto& b) { return unnormalized_axes(a, b); }),
      box_method(
          "short_radius_axes",
          [](const auto& a, const auto& b) { return short_radius_axes(a, b); }),
      box_method("union_depth", [](const auto& a, const auto& b) { return union_depth(a, b); })};
}

/// The manifold of a batch of one pair; always in float.
template <class Real>
std::optional<Manifold<float>> as_batch(const Obb<Real>& a, const Obb<Real>& b)
{
  const std::pair<Obb<float>, Obb<float>> pair(box_in<float>(a), box_in<float>(b));
  return box_pairs_in_order({&pair, 1})[0];
}

/// The batch, a pair at a time.
BoxMethod batch_method()
{
  BoxMethod method =
      box_method("box_pairs", [](const auto& a, const auto& b) { return as_batch(a, b); });
  method.in_float = true;
  return method;
}

/// The methods that are checked by their depth and by their points, compiled once for both.
struct WholeAnswers
{
  BoxMethod as_published = box_method(
      "box_as_published", [](const auto& a, const auto& b) { return box_as_published(a, b); });
  BoxMethod general =
      box_method("gjk_epa", [](const auto& a, const auto& b) { return gjk_epa(a, b); });
  BoxMethod edges =
      box_method("edge_clipping", [](const auto& a, const auto& b) { return edge_clipping(a, b); });
  BoxMethod faces =
      box_method("face_clipping", [](const auto& a, const auto& b) { return face_clipping(a, b); });
  BoxMethod recommended =
      box_method("box_box", [](const auto& a, const auto& b) { return box_box(a, b); });
  BoxMethod batch = batch_method();
};

/// Whole answers, by their decision, depth and normal.
std::vector<BoxMethod> manifold_methods(const WholeAnswers& whole)
{
  const auto yes_or_no = [](const auto& a, const auto& b)
  {
    using Real = typename std::decay_t<decltype(a.center)>::Scalar;
    const LeastOverlap<Real> yes{{0, 0, 0}, std::numeric_limits<Real>::quiet_NaN(), 0};
    return overlap_as_published(a, b) ? std::optional(yes) : std::nullopt;
  };
  return {
      box_method("overlap_as_published", yes_or_no),
      whole.as_published,
      whole.general,
      whole.edges,
      whole.faces,
      whole.recommended,
      whole.batch};
}

/// Ways to find points.
std::vector<BoxMethod> point_methods(const WholeAnswers& whole)
{
  const auto untolerant = [](const auto& a, const auto& b)
  {
    using Real = typename std::decay_t<decltype(a.center)>::Scalar;
    Manifold<Real, most_crossings> found{{0, 0, 0}, 0, {}};
    for (const Vector3<Real>& position : untolerant_points(a, b))
    {
      found.points.push_back({position, 0, 0});
    }
    return std::optional(found);
  };
  return {
      box_method("untolerant_points", untolerant),
      whole.as_published,
      whole.edges,
      whole.general,
      whole.faces,
      whole.recommended,
      whole.batch};
}

/// A row of the verdicts that `oracle` gives for each method.
template <class Oracle>
VerdictRow row_of(
    const VerdictPart& part, const std::string& id, const std::string& scene, const Oracle& oracle)
{
  VerdictRow row{id, scene, {}};
  for (const BoxMethod& method : part.methods)
  {
    row.verdicts.push_back(oracle(method));
  }
  return row;
}

/// A pair of boxes.
VerdictRow pair_row(const VerdictPart& part, const BoxCase& pair)
{
  return row_of(
      part, id_in_tables(pair), pair.scene,
      [&](const BoxMethod& method) { return verdict_of(part, method, pair); });
}

/// K1: no pair of boxes at all.
VerdictRow capsule_row(const VerdictPart& part)
{
  return row_of(
      part, "K1", "a capsule deep in a box",
      [](const BoxMethod&) { return does_not_apply("takes boxes only"); });
}

/// K4: many pairs.
VerdictRow cubes_row(const VerdictPart& part)
{
  return row_of(
      part, "K4", "hit or not: " + std::to_string(decided_cubes) + " pairs of cubes, float",
      [&](const BoxMethod& method)
      { return verdict_on_decisions(method, part.verdict == verdict_on_points); });
}

} // namespace

std::vector<VerdictRow> verdict_rows(const VerdictPart& part, CaseChoice choice)
{
  std::vector<VerdictRow> rows;
  const auto add = [&](const std::string& id, const auto& row)
  {
    if (choice == CaseChoice::all ||
        (choice == CaseChoice::telling) == (part.telling.count(id) > 0))
    {
      rows.push_back(row());
    }
  };
  for (const BoxCase& pair : all_box_cases())
  {
    if (pair.id == "K2")
    {
      add("K1", [&] { return capsule_row(part); });
    }
    add(pair.id, [&] { return pair_row(part, pair); });
    if (pair.id == "K3-b")
    {
      add("K4", [&] { return cubes_row(part); });
    }
  }
  return rows;
}

std::vector<VerdictPart> verdict_parts()
{
  const WholeAnswers whole;
  return {
      {"box_failures",
       "Ways to find the least overlap",
       axis_methods(),
       verdict_on_overlap,
       {"G1", "G2", "G3", "G6", "G9", "G9b", "G11", "G13", "G13-10-A-b", "G14"}},
      {"box_failures_manifolds",
       "Whole answers: decision, depth and normal",
       manifold_methods(whole),
       verdict_on_overlap,
       {"G1", "G3", "G6", "G9", "G13", "G13-10-A-b", "K3", "K4", "X09", "X14"}},
      {"box_failures_points",
       "Ways to find contact points",
       point_methods(whole),
       verdict_on_points,
       {"G2", "G4", "G6", "G8", "G9", "G9b", "G16", "X15", "X16", "X17"}}};
}

} // namespace cookbook
