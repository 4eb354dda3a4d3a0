#pragma once

/// \file
/// \brief The verdict on each way to keep four contact points of eight, and their table.

#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "04_obb_manifolds/contact_reduction/steady_reduction.hpp"
#include "04_obb_manifolds/contact_reduction/trial/contact_reduction_pitfalls.hpp"
#include "04_obb_manifolds/contact_reduction/trial/contact_reduction_truth.hpp"
#include "04_obb_manifolds/contact_reduction/trial/contact_support.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <functional>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to keep four points, by name.
struct ReductionMethod
{
  std::string name;                                                         ///< of its function
  std::function<Manifold<double, most_kept>(const Manifold<double>&)> keep; ///< four of all
};

/// A cube of 2 m on another, turned by 45° about the height and leaning by an angle [rad] about x.
inline Manifold<double> octagon_of_cubes(double angle)
{
  const Vector3<double> one(1, 1, 1), up(0, 1, 0), right(1, 0, 0);
  const Matrix3<double> axes = turned(angle, right) * turned(std::atan(1.0), up);
  return *box_box(upright({0, 0, 0}, one), Obb<double>{{0, 1.99, 0}, axes, one});
}

/// All ways; those that know where the weight is are told its middle, and the
/// one that knows the frame before had the boxes lean the other way there.
inline std::vector<ReductionMethod> reduction_methods()
{
  using All = Manifold<double>;
  return {
      {"four_deepest", [](const All& all) { return four_deepest(all); }},
      {"reduced", [](const All& all) { return reduced(all); }},
      {"reduced_over",
       [](const All& all) {
         return reduced_over(all, {0, 1, 0});
       }},
      {"steadily_reduced",
       [](const All& all) { return steadily_reduced(all, reduced(octagon_of_cubes(-1e-3))); }}};
}

/// Right if a point as deep as the deepest is kept, and the area is no more than a hundredth below
/// the best of all choices of four.
inline Verdict verdict_on_reduction(const ReductionMethod& method, const Manifold<double>& all)
{
  const Manifold<double, most_kept> few = method.keep(all);
  const double spanned = area(support(few)), best = area(support(best_four(all)));
  double deepest = 0;
  for (const ContactPoint<double>& point : few.points)
  {
    deepest = std::max(deepest, point.depth);
  }
  const std::string what = number(spanned) + " of " + number(best) + " m²";
  const bool keeps_deepest = deepest >= all.depth - 1e-9;
  return {keeps_deepest && spanned >= 0.99 * best, what + (keeps_deepest ? "" : ", deepest lost")};
}

/// What all ways make of all cases.
inline std::vector<VerdictRow> reduction_verdicts()
{
  std::vector<VerdictRow> rows{
      {"G19", "a cube on a cube, turned by 45°: an octagon", {}},
      {"", "the same, leaning by 1e-3", {}}};
  for (const ReductionMethod& method : reduction_methods())
  {
    rows[0].verdicts.push_back(verdict_on_reduction(method, octagon_of_cubes(0)));
    rows[1].verdicts.push_back(verdict_on_reduction(method, octagon_of_cubes(1e-3)));
  }
  return rows;
}

} // namespace cookbook
