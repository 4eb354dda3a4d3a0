#pragma once

/// \file
/// \brief Whether a method's answer for a sphere is right, and in what way it is not.

#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace cookbook
{

/// A manifold by any method, in double.
struct Found
{
  Vector3<double> normal; ///< [1]
  double depth;           ///< [m]
};

/// What a method found, in double; nothing stays nothing.
template <class Real>
std::optional<Found> found(const std::optional<Manifold<Real>>& manifold)
{
  return manifold ? std::optional<Found>(
                        {manifold->normal.template cast<double>(), double(manifold->depth)})
                  : std::nullopt;
}

/// What is right, and how far from it an answer may be.
struct Right
{
  double depth;           ///< [m]; negative where the shapes are apart
  Vector3<double> normal; ///< [1], from A to B; zero where every unit vector is right
  double tolerance;       ///< [m] for the depth, and [rad] for the normal
};

/// The right answer as the table shows it.
inline std::string right_value(const Right& right)
{
  return right.depth < 0 ? "apart" : number(right.depth);
}

// [verdict_of]
/// Whether an answer is right, and what to say of it.
inline Verdict verdict_of(const std::optional<Found>& answer, const Right& right)
{
  if (!answer)
  {
    return right.depth < 0 ? Verdict{true, "apart"} : Verdict{false, "no contact"};
  }
  if (right.depth < 0)
  {
    return {false, "contact, though apart"};
  }
  if (!answer->normal.allFinite() || !std::isfinite(answer->depth))
  {
    return {false, "not a number"};
  }
  if (std::abs(answer->normal.norm() - 1) > right.tolerance)
  {
    return {false, "normal not of length 1"};
  }
  const double off = std::abs(answer->depth - right.depth);
  if (off > right.tolerance)
  {
    return {false, "depth off by " + number(off)};
  }
  const double angle =
      std::atan2(answer->normal.cross(right.normal).norm(), answer->normal.dot(right.normal));
  if (!right.normal.isZero(0) && angle > right.tolerance)
  {
    return {false, "normal " + number(std::round(angle * 180 / std::numbers::pi)) + "° off"};
  }
  return {true, "holds"};
}
// [verdict_of]

/// The verdict of every answer.
inline std::vector<Verdict>
verdicts_of(const std::vector<std::optional<Found>>& answers, const Right& right)
{
  std::vector<Verdict> verdicts;
  for (const std::optional<Found>& answer : answers)
  {
    verdicts.push_back(verdict_of(answer, right));
  }
  return verdicts;
}

} // namespace cookbook
