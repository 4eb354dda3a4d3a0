#pragma once

/// \file
/// \brief Checks a method's manifold of two boxes against the truth, and sums checks up.

#include "04_obb_manifolds/box_oracles/trial/resting_steadiness.hpp"
#include "04_obb_manifolds/separating_axes/separating_axes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace cookbook
{

/// Whether one box rests on the other: a face of each, parallel to within 1.5e-4 rad, with an area
/// in common along the least overlap of all faces.
inline bool rests(const Obb<double>& a, const Obb<double>& b)
{
  const std::optional<LeastOverlap<double>> least = least_overlap(a, b, 6);
  if (!least)
  {
    return false;
  }
  const auto tilt = [&](const Obb<double>& box)
  {
    const Face face = face_towards(box, least->normal);
    return face.u.cross(face.v).normalized().cross(least->normal).norm();
  };
  const double size = pair_size(a, b);
  return tilt(a) + tilt(b) <= 1.5e-4 &&
         std::abs(area(true_face_overlap(a, b, least->normal))) > 1e-4 * size * size;
}

// [manifold_check]
/// How one answer of a method stands to the truth.
struct ManifoldCheck
{
  bool wrong = false;       ///< the verdict, by more than 1e-5 of the pair's size
  bool finite = true;       ///< all numbers, and there is a point
  bool compared = false;    ///< whether there is a depth to compare
  double depth_error = 0;   ///< [1], of the depth, as part of the pair's size
  bool rests = false;       ///< whether one box rests on the other
  bool points_lost = false; ///< of those: the points span less than 99 % of the faces' overlap
};

/// The least overlap of the six faces [m]: what a method may say where faces are nearly parallel,
/// for the sake of its points.
template <class Real>
Real true_face_depth(const Obb<Real>& a, const Obb<Real>& b)
{
  const Vector3<Real> offset = b.center - a.center;
  Real least = std::numeric_limits<Real>::infinity();
  for (const Obb<Real>* const box : {&a, &b})
  {
    for (int i = 0; i < 3; ++i)
    {
      const Vector3<Real> axis = box->axes.col(i).normalized();
      const Vector3<Real> normal = axis.dot(offset) < 0 ? Vector3<Real>(-axis) : axis;
      least = std::min(least, overlap_along(a, b, normal));
    }
  }
  return least;
}

/// Checks one answer.
template <class Real, std::size_t Capacity>
ManifoldCheck
manifold_check(const BoxPair<Real>& pair, const std::optional<Manifold<Real, Capacity>>& answer)
{
  using True = Truer<Real>;
  const ManifoldError error = manifold_error(pair, answer);
  ManifoldCheck check;
  check.wrong = error.wrong(1e-5);
  check.finite = error.finite;
  check.compared = answer && error.finite && error.depth >= 0;
  if (check.compared)
  {
    const True depth = True(answer->depth);
    const Obb<True> a = box_in<True>(pair.first), b = box_in<True>(pair.second);
    const True off = std::abs(depth - True(error.depth));
    const True face_off = error.parallel ? std::abs(depth - true_face_depth(a, b)) : off;
    check.depth_error = static_cast<double>(std::min(off, face_off)) / error.size;
  }
  const Obb<double> a = box_in<double>(pair.first), b = box_in<double>(pair.second);
  check.rests = rests(a, b);
  const bool has_points = answer && error.finite;
  check.points_lost =
      check.rests && !(has_points && area_fraction(a, b, in_double(*answer)) >= 0.99);
  return check;
}
// [manifold_check]

/// How good a method is on some pairs.
struct BoxAccuracy
{
  std::size_t wrong = 0;       ///< verdicts
  std::size_t not_finite = 0;  ///< answers
  std::size_t compared = 0;    ///< depths
  double depth_p99 = 0;        ///< [1], of the pair's size
  double depth_max = 0;        ///< [1], of the pair's size
  std::size_t rest = 0;        ///< pairs that rest
  std::size_t points_lost = 0; ///< of those

  /// Whether the method is useless here: wrong about overlap, or not a number.
  bool fails() const { return wrong > 0 || not_finite > 0; }
};

/// Sums checks up.
inline BoxAccuracy box_accuracy(const std::vector<ManifoldCheck>& checks)
{
  BoxAccuracy sum;
  std::vector<double> errors;
  for (const ManifoldCheck& check : checks)
  {
    sum.wrong += check.wrong ? 1 : 0;
    sum.not_finite += check.finite ? 0 : 1;
    sum.rest += check.rests ? 1 : 0;
    sum.points_lost += check.points_lost ? 1 : 0;
    if (check.compared)
    {
      errors.push_back(check.depth_error);
    }
  }
  sum.compared = errors.size();
  if (!errors.empty())
  {
    const measure::ErrorStatistics statistics = measure::error_statistics(errors);
    sum.depth_p99 = statistics.p99;
    sum.depth_max = statistics.maximum;
  }
  return sum;
}

} // namespace cookbook
