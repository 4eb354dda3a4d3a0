#pragma once

/// \file
/// \brief The verdict on each method of testing two boxes at each case, and their tables.

#include "04_obb_manifolds/box_as_published/trial/box_as_published.hpp"
#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_failures/trial/box_failures.hpp"
#include "04_obb_manifolds/box_failures/trial/box_pitfalls.hpp"
#include "04_obb_manifolds/gjk_epa/gjk_epa.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace cookbook
{

/// What a method says of two boxes that overlap, in double.
struct BoxAnswer
{
  Vector3<double> normal;                   ///< [1]
  double depth;                             ///< [m]; not a number where only a yes is given
  std::vector<ContactPoint<double>> points; ///< world; none from methods that find no points
};

/// The least overlap, without points.
template <class Real>
BoxAnswer box_answer(const LeastOverlap<Real>& least)
{
  return {least.normal.template cast<double>(), double(least.depth), {}};
}

/// A whole manifold.
template <class Real, std::size_t Capacity>
BoxAnswer box_answer(const Manifold<Real, Capacity>& manifold)
{
  BoxAnswer answer{manifold.normal.template cast<double>(), double(manifold.depth), {}};
  for (const ContactPoint<Real>& point : manifold.points)
  {
    answer.points.push_back(
        {point.position.template cast<double>(), double(point.depth), point.feature});
  }
  return answer;
}

/// A box in another number type, seen from a point.
template <class Real>
Obb<Real> rounded(const Obb<double>& box, const Vector3<double>& from)
{
  return {(box.center - from).cast<Real>(), box.axes.cast<Real>(), box.half_extents.cast<Real>()};
}

/// A method by name.
struct BoxMethod
{
  std::string name;                                               ///< of its function
  std::function<std::optional<BoxAnswer>(const BoxCase&)> answer; ///< on a case
  bool in_float = false; ///< whether it answers in float, whatever it is given
};

/// A method that is called with two boxes of either number type.
template <class Call>
BoxMethod box_method(const std::string& name, const Call& call)
{
  const auto asked = [call](const auto& a, const auto& b)
  {
    const auto found = call(a, b);
    return found ? std::optional(box_answer(*found)) : std::nullopt;
  };
  return {
      name, [asked](const BoxCase& pair)
      {
        const bool from_a = pair.numbers == BoxNumbers::in_float_from_a;
        const Vector3<double> from = from_a ? pair.a.center : Vector3<double>::Zero();
        std::optional<BoxAnswer> answer =
            pair.numbers == BoxNumbers::in_double
                ? asked(pair.a, pair.b)
                : asked(rounded<float>(pair.a, from), rounded<float>(pair.b, from));
        for (std::size_t i = 0; answer && i < answer->points.size(); ++i)
        {
          answer->points[i].position += from;
        }
        return answer;
      }};
}

/// Right if the decision, the depth and, where there is only one, the normal are.
inline Verdict verdict_on_overlap(const BoxCase& pair, const std::optional<BoxAnswer>& answer)
{
  const bool apart = pair.depth < 0;
  if (apart || !answer || std::isnan(answer->depth))
  {
    const std::string depth = answer && !std::isnan(answer->depth) ? number(answer->depth) : "";
    return {apart == !answer, !answer ? "apart" : depth.empty() ? "overlap" : "overlap " + depth};
  }
  if (!(std::abs(answer->depth - pair.depth) <= pair.tolerance))
  {
    const double said = std::abs(answer->depth) < pair.tolerance ? 0 : answer->depth;
    return {false, "depth " + number(said) + ", not " + number(pair.depth)};
  }
  const bool turned =
      !pair.normal.isZero() && (answer->normal - pair.normal).cwiseAbs().maxCoeff() > 1e-6;
  return {!turned, turned ? "normal wrong" : "depth " + number(pair.depth)};
}

/// Right if every contact is found and no other, and its features where they are asked for; where
/// any contact will do, if there is at least one.
inline Verdict verdict_on_points(const BoxCase& pair, const std::optional<BoxAnswer>& answer)
{
  const std::vector<ContactPoint<double>> points =
      answer ? answer->points : std::vector<ContactPoint<double>>();
  const std::string count =
      points.empty() ? "no points"
                     : std::to_string(points.size()) + (points.size() == 1 ? " point" : " points");
  const std::vector<Vector3<double>>& right = pair.contacts;
  if (pair.depth < 0 || right.empty())
  {
    return {points.empty() == (pair.depth < 0), count};
  }
  if (points.size() != right.size())
  {
    return {false, count + ", not " + std::to_string(right.size())};
  }
  const auto is_found = [&](const Vector3<double>& contact)
  {
    return std::any_of(
        points.begin(), points.end(),
        [&](const ContactPoint<double>& point)
        { return (point.position - contact).norm() <= 2 * pair.tolerance; });
  };
  std::set<std::uint32_t> features;
  for (const ContactPoint<double>& point : points)
  {
    features.insert(point.feature);
  }
  const bool in_place = std::all_of(right.begin(), right.end(), is_found);
  const bool known = !pair.features || features.size() == points.size();
  return {in_place && known, count + (!in_place ? ", misplaced" : known ? "" : ", unknown")};
}

} // namespace cookbook
