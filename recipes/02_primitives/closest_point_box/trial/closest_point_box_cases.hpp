#pragma once

/// \file
/// \brief Points and boxes that break some way of answering, and how far an answer is from the
/// truth.

#include "02_primitives/closest_point_box/trial/closest_point_box_pitfalls.hpp"
#include "common/math/rotation.hpp"
#include "tools/exact/exact.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to answer, by name.
struct PointBoxMethod
{
  std::string name; ///< as on the page
  /// Direction out of the box and signed distance, in the box's coordinates.
  Direction<double> (*answer)(const Vector3<double>&, const Vector3<double>&);
};

/// The ways that compete, the recommended one last.
inline std::array<PointBoxMethod, 4> point_box_methods()
{
  return {
      {{"mixed bounds", distance_mixed_bounds<double>},
       {"unguarded", distance_unguarded<double>},
       {"shell", distance_shell<double>},
       {"recommended", signed_distance_box<double>}}};
}

/// A point in a box's coordinates and its true signed distance, known by hand.
struct PointTruth
{
  Vector3<double> point; ///< [m]
  double distance;       ///< [m], negative inside
};

// [point_box_cases]
/// Points around a box that some way to answer may get wrong.
struct PointBoxCase
{
  std::string id;                 ///< in the book; empty for a neighbour of the case above
  std::string what;               ///< box and points, as text
  Vector3<double> half_extents;   ///< [m]
  std::vector<PointTruth> points; ///< with their truth
};

/// Points that sink through the top of a box whose half height is 0.5, from 1 mm above it.
inline std::vector<PointTruth> sinking_points()
{
  std::vector<PointTruth> points;
  for (int i = 0; i <= 200; ++i)
  {
    const double distance = 1e-3 - 1e-5 * i;
    points.push_back({{9, 0.5 + distance, 0}, distance});
  }
  return points;
}

/// The boxes and points to try.
inline std::vector<PointBoxCase> point_box_cases()
{
  const Vector3<double> floor(10, 0.5, 10);
  const Vector3<double> cube(1, 1, 1);
  const Vector3<double> small(0.004, 0.004, 0.004);
  return {
      {"D1", "floor, inside", floor, {{{9, 0.45, 0}, -0.05}}},
      {"D2", "floor, its centre", floor, {{{0, 0, 0}, -0.5}}},
      {"D3", "floor, sinking in", floor, sinking_points()},
      {"D4", "cube, its corner", cube, {{{1, 1, 1}, 0}}},
      {"D8", "beam, 4 m above", {10, 1, 1}, {{{0, 5, 0}, 4}}},
      {"", "cube, 4 m above", cube, {{{0, 5, 0}, 4}}},
      {"", "cube, inside its edge", cube, {{{0.9, 0.9, 0}, -0.1}}},
      {"", "4 mm, 0.2 mm off", small, {{{0.0042, 0, 0}, 0.0002}}}};
}
// [point_box_cases]

// [point_box_verdict]
/// Whether an answer is right: its direction has length one, its distance is the true one, and a
/// plane perpendicular to the direction at that distance has the whole box behind it.
inline Verdict point_box_verdict(
    const Direction<double>& answer, const Vector3<double>& half_extents, PointTruth truth)
{
  const double rounding = 1e-12; // [m], a few roundings of numbers up to 10
  if (!answer.unit.allFinite() || std::abs(answer.unit.squaredNorm() - 1) > rounding)
  {
    return {false, "no direction"};
  }
  if (std::abs(answer.length - truth.distance) > rounding)
  {
    return {false, "distance " + number(answer.length) + ", not " + number(truth.distance)};
  }
  const double radius = half_extents.dot(answer.unit.cwiseAbs());
  const bool behind = truth.point.dot(answer.unit) - radius >= truth.distance - rounding;
  return {behind, behind ? "right" : "wrong direction"};
}
// [point_box_verdict]

/// The verdicts on all ways, case by case; a way fails a case at the first point it gets wrong.
inline std::vector<VerdictRow> point_box_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const PointBoxCase& one : point_box_cases())
  {
    rows.push_back({one.id, one.what, {}});
    for (const PointBoxMethod& method : point_box_methods())
    {
      Verdict verdict{true, "right"};
      for (std::size_t i = 0; i < one.points.size() && verdict.holds; ++i)
      {
        const PointTruth& truth = one.points[i];
        verdict = point_box_verdict(
            method.answer(truth.point, one.half_extents), one.half_extents, truth);
      }
      rows.back().verdicts.push_back(verdict);
    }
  }
  return rows;
}

// [axes_error]
/// Error [m] of the closest point of an oriented box whose axes are rounded to `Real`, to a point
/// 15 `scale` [m] in front of the middle of each face; the truth is exact. The worst of three
/// faces.
template <class Real>
double axes_error(double scale)
{
  const Vector3<Rational> half(Rational(1), Rational(1, 2), Rational(1, 4));
  const Matrix3<Rational> exact_axes = rational_rotation<Rational>(1, 2, 3, 4);
  const Obb<Real> box{
      Vector3<Real>::Zero(), rational_rotation<Real>(1, 2, 3, 4), half.template cast<Real>()};
  Rational worst = 0;
  for (int i = 0; i < 3; ++i)
  {
    // Fifteen axes have whole components: a power of ten times them has no rounding.
    const Vector3<Rational> axis = exact_axes.col(i);
    const Vector3<Rational> point = axis * Rational(15 * scale);
    const Vector3<Real> answer = closest_point<Real>(box, point.template cast<Real>());
    const Vector3<Rational> error = exact<Rational>(answer) - axis * half[i];
    worst = std::max<Rational>(worst, error.cwiseAbs().maxCoeff());
  }
  return static_cast<double>(worst);
}
// [axes_error]

} // namespace cookbook
