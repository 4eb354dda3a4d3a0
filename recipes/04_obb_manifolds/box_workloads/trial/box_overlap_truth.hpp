#pragma once

/// \file
/// \brief What is true of two boxes, straight from the definitions: slow, wide, and not ours to
/// tune.

#include "02_primitives/shapes/shapes.hpp"
#include "common/math/vector.hpp"

#include <array>
#include <cmath>
#include <type_traits>

namespace cookbook
{

/// The number type in which the truth about boxes of `Real` is computed.
template <class Real>
using Truer = std::conditional_t<std::is_same_v<Real, float>, double, long double>;

/// The same numbers in another type.
///
/// Axes of float are at right angles and of length one only to about 1e-7. The truth takes them as
/// they are: a box is all points c + Σ xᵢ aᵢ with |xᵢ| ≤ hᵢ, skewed by that little. Its edges run
/// along its axes; its faces are perpendicular to the cross products of two of them.
template <class To, class From>
Obb<To> box_in(const Obb<From>& box)
{
  return {
      box.center.template cast<To>(), box.axes.template cast<To>(),
      box.half_extents.template cast<To>()};
}

/// A box in double whose axes are orthonormal to double's rounding, next to a box in float.
inline Obb<double> orthonormal(const Obb<float>& box)
{
  Obb<double> straight = box_in<double>(box);
  const Vector3<double> x = straight.axes.col(0).normalized();
  const Vector3<double> y = (straight.axes.col(1) - x.dot(straight.axes.col(1)) * x).normalized();
  straight.axes << x, y, x.cross(y);
  return straight;
}

/// The size of a pair [m]: the longest half extent of the two.
template <class Real>
Real pair_size(const Obb<Real>& a, const Obb<Real>& b)
{
  using std::max;
  return max(a.half_extents.maxCoeff(), b.half_extents.maxCoeff());
}

// [overlap_along]
/// How far B must move along a unit vector [m] until no point of it is behind A's front; O6.
///
/// From A to B it is the overlap along the normal; the wrong way round it is the way through.
template <class Real>
Real overlap_along(const Obb<Real>& a, const Obb<Real>& b, const Vector3<Real>& normal)
{
  const Real radius_a = (a.axes.transpose() * normal).cwiseAbs().dot(a.half_extents);
  const Real radius_b = (b.axes.transpose() * normal).cwiseAbs().dot(b.half_extents);
  return radius_a + radius_b - normal.dot(b.center - a.center);
}
// [overlap_along]

// [true_overlap]
/// The direction of least overlap, or of the largest gap, without a square root.
template <class Real>
struct TrueLeast
{
  Vector3<Real> axis; ///< of any length, world, from A to B or against it
  Real signed_square; ///< [m²], of the overlap along it; less than zero: the boxes are apart
};

/// The least overlap of all pairs of the six edge directions; O1. Exact in fractions.
template <class Real>
TrueLeast<Real> true_least_overlap(const Obb<Real>& a, const Obb<Real>& b)
{
  using std::abs;
  std::array<Vector3<Real>, 6> edges;
  for (std::size_t i = 0; i < 3; ++i)
  {
    edges[i] = a.axes.col(int(i)) * a.half_extents[int(i)];
    edges[i + 3] = b.axes.col(int(i)) * b.half_extents[int(i)];
  }
  const Vector3<Real> offset = b.center - a.center;
  TrueLeast<Real> least{Vector3<Real>::Zero(), Real(0)};
  for (std::size_t i = 0; i < 6; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const Vector3<Real> axis = edges[i].cross(edges[j]);
      if (axis.isZero(0))
      {
        continue;
      }
      Real overlap = -abs(axis.dot(offset));
      for (const Vector3<Real>& edge : edges)
      {
        overlap += abs(axis.dot(edge));
      }
      const Real signed_square = overlap * abs(overlap) / axis.squaredNorm();
      if (least.axis.isZero(0) || signed_square < least.signed_square)
      {
        least = {axis, signed_square};
      }
    }
  }
  return least;
}

/// The least overlap [m]; where the boxes are apart, minus the largest gap.
template <class Real>
Real true_depth(const TrueLeast<Real>& least)
{
  using std::abs, std::sqrt;
  const Real depth = sqrt(abs(least.signed_square));
  return least.signed_square < Real(0) ? Real(-depth) : depth;
}
// [true_overlap]

/// Whether a face of A and a face of B are parallel to within 1°; then edges of both are, too.
template <class Real>
bool has_parallel_faces(const Obb<Real>& a, const Obb<Real>& b)
{
  return (a.axes.transpose() * b.axes).cwiseAbs().maxCoeff() > Real(0.99984769515639124); // cos 1°
}

/// The distance [m] of a point from a box; zero inside.
template <class Real>
Real distance_to_box(const Obb<Real>& box, const Vector3<Real>& point)
{
  const Vector3<Real> local = box.axes.inverse() * (point - box.center);
  const Vector3<Real> inside = local.cwiseMax(-box.half_extents).cwiseMin(box.half_extents);
  return (box.axes * (local - inside)).norm();
}

} // namespace cookbook
