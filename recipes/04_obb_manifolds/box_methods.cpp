/// \file
/// \brief The methods that the table of failing cases compares, compiled once for the program and
/// its test.

#include "04_obb_manifolds/box_methods.hpp"
#include "04_obb_manifolds/box_as_published.hpp"
#include "04_obb_manifolds/box_box.hpp"
#include "04_obb_manifolds/box_pitfalls.hpp"
#include "04_obb_manifolds/gjk_epa.hpp"

#include <limits>
#include <type_traits>

namespace cookbook
{
namespace
{

// [box_methods]
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
          "short_reach_axes", [](const auto& a, const auto& b) { return short_reach_axes(a, b); }),
      box_method("union_depth", [](const auto& a, const auto& b) { return union_depth(a, b); })};
}

/// Whole answers, by their decision, depth and normal.
std::vector<BoxMethod> manifold_methods()
{
  const auto yes_or_no = [](const auto& a, const auto& b)
  {
    using Real = typename std::decay_t<decltype(a.center)>::Scalar;
    const LeastOverlap<Real> yes{{0, 0, 0}, std::numeric_limits<Real>::quiet_NaN(), 0};
    return overlap_as_published(a, b) ? std::optional(yes) : std::nullopt;
  };
  return {
      box_method("overlap_as_published", yes_or_no),
      box_method(
          "box_as_published", [](const auto& a, const auto& b) { return box_as_published(a, b); }),
      box_method("gjk_epa", [](const auto& a, const auto& b) { return gjk_epa(a, b); }),
      box_method("box_box", [](const auto& a, const auto& b) { return box_box(a, b); })};
}

/// Ways to find points.
std::vector<BoxMethod> point_methods()
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
      box_method(
          "box_as_published", [](const auto& a, const auto& b) { return box_as_published(a, b); }),
      box_method("edge_clipping", [](const auto& a, const auto& b) { return edge_clipping(a, b); }),
      box_method("gjk_epa", [](const auto& a, const auto& b) { return gjk_epa(a, b); }),
      box_method("box_box", [](const auto& a, const auto& b) { return box_box(a, b); })};
}
// [box_methods]

} // namespace

std::vector<VerdictPart> verdict_parts()
{
  return {
      {"box_failures", "Ways to find the least overlap", axis_methods(), verdict_on_overlap},
      {"box_failures_manifolds", "Whole answers: decision, depth and normal", manifold_methods(),
       verdict_on_overlap},
      {"box_failures_points", "Ways to find contact points", point_methods(), verdict_on_points}};
}

} // namespace cookbook
