#pragma once

/// \file
/// \brief What a manifold of two boxes gets wrong: verdict, normal, depth and points.

#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_overlap_truth.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_pair.hpp"
#include "common/math/ulp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

namespace cookbook
{

/// The pair in the number type of a method: the floats themselves, or double with axes as
/// orthonormal as double can be.
template <class Real>
BoxPair<Real> pair_in(const BoxPair<float>& pair)
{
  if constexpr (std::is_same_v<Real, float>)
  {
    return pair;
  }
  else
  {
    return {orthonormal(pair.first), orthonormal(pair.second)};
  }
}

// [manifold_error]
/// What a manifold gets wrong; lengths in metres.
struct ManifoldError
{
  double size = 1;       ///< of the pair
  double depth = 0;      ///< the least overlap in truth; negative where the boxes are apart
  bool parallel = false; ///< whether a face of A and one of B are parallel within 1°
  bool answered = false; ///< whether the method says that they overlap
  bool finite = true;    ///< whether all numbers are, and there is a point
  double excess = 0;     ///< overlap along the normal less the least overlap
  double said = 0;       ///< how far the manifold's depth is from the overlap along its normal
  double outside = 0;    ///< how far a point is from either box, beyond half the manifold's depth

  /// Whether the verdict is wrong by more than a part of the pair's size.
  bool wrong(double part) const { return answered ? depth < -part * size : depth > part * size; }
};

/// Whether a manifold has a point and no number that is not finite.
template <class Real, std::size_t Capacity>
bool is_whole(const Manifold<Real, Capacity>& manifold)
{
  const auto finite = [](const ContactPoint<Real>& point)
  { return point.position.allFinite() && std::isfinite(point.depth); };
  return manifold.normal.allFinite() && std::isfinite(manifold.depth) && !manifold.points.empty() &&
         std::all_of(manifold.points.begin(), manifold.points.end(), finite);
}

/// How far a point is from the farther of two boxes, less what rounding its coordinates may add:
/// the spacing of numbers of type `Real` at its distance from the origin.
template <class Real>
double
outside_both(const Vector3<Real>& point, const Obb<Truer<Real>>& a, const Obb<Truer<Real>>& b)
{
  const Vector3<Truer<Real>> p = point.template cast<Truer<Real>>();
  const Truer<Real> farther = std::max(distance_to_box(a, p), distance_to_box(b, p));
  return static_cast<double>(farther - Truer<Real>(ulp(point.norm())));
}

/// What a method's answer gets wrong.
template <class Real, std::size_t Capacity>
ManifoldError
manifold_error(const BoxPair<Real>& pair, const std::optional<Manifold<Real, Capacity>>& answer)
{
  using True = Truer<Real>;
  const Obb<True> a = box_in<True>(pair.first), b = box_in<True>(pair.second);
  ManifoldError error;
  error.size = static_cast<double>(pair_size(a, b));
  const True least = true_depth(true_least_overlap(a, b));
  error.depth = static_cast<double>(least);
  error.parallel = has_parallel_faces(a, b);
  error.answered = answer.has_value();
  if (!answer)
  {
    return error;
  }
  error.finite = is_whole(*answer);
  const Vector3<True> normal = answer->normal.template cast<True>().normalized();
  const True along = overlap_along(a, b, normal);
  error.excess = static_cast<double>(along - least);
  error.said = static_cast<double>(True(answer->depth) - along);
  error.outside = -std::numeric_limits<double>::infinity();
  for (const ContactPoint<Real>& point : answer->points)
  {
    const double half = static_cast<double>(answer->depth) / 2;
    error.outside = std::max(error.outside, outside_both(point.position, a, b) - half);
  }
  return error;
}
// [manifold_error]

} // namespace cookbook
