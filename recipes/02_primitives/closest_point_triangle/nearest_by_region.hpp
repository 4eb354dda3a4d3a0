#pragma once

/// \file
/// \brief The point of a triangle that is closest to the origin, by the region the origin lies in.

#include "02_primitives/closest_point_triangle/closest_point_triangle.hpp"

namespace cookbook
{

// [nearest_by_region]
/// A point counts as near if its squared way is below this fraction of ab² + ac².
template <class Real>
inline const Real near_squared_ratio = Real(1) / Real(1000);

/// The point of a triangle that is closest to the origin, also where that is near.
template <class Real>
[[gnu::noinline, gnu::cold]] Nearest<Real>
nearest_with_care(const Vector3<Real>& a, const Vector3<Real>& b, const Vector3<Real>& c)
{
  const Vector3<Real> corners[] = {a, b, c};
  return nearest_on_triangle(corners, 0, 1, 2);
}

/// The barycentric coordinates of the point of a triangle that is closest to the origin; P11, P13.
///
/// By the region in which the origin lies, told by dot products. All are 0 over a narrow face, and
/// where rounding leaves no region: there this way has too few digits.
template <class Real>
Vector3<Real>
barycentric_by_region(const Vector3<Real>& a, const Vector3<Real>& b, const Vector3<Real>& c)
{
  const Real zero(0), one(1);
  const Vector3<Real> ab = b - a, ac = c - a;
  const Real ab_ab = ab.squaredNorm(), ac_ac = ac.squaredNorm(), ab_ac = ab.dot(ac);
  // How far the origin lies along the edges: from a to b, from a to c, from b to c, from c to b.
  const Real on_ab = -a.dot(ab), on_ac = -a.dot(ac);
  const Real on_bc = on_ac - ab_ac - (on_ab - ab_ab), on_cb = on_ab - ab_ac - (on_ac - ac_ac);
  // Each share at the foot, times the squared length of the normal.
  const Real squared = ab_ab * ac_ac - ab_ac * ab_ac;
  const Real for_b = ac_ac * on_ab - ab_ac * on_ac, for_c = ab_ab * on_ac - ab_ac * on_ab;
  const Real for_a = squared - for_b - for_c;
  if (on_ab <= zero && on_ac <= zero)
  {
    return {one, zero, zero};
  }
  if (on_ab >= ab_ab && on_bc <= zero)
  {
    return {zero, one, zero};
  }
  if (on_ac >= ac_ac && on_cb <= zero)
  {
    return {zero, zero, one};
  }
  if (for_c <= zero && on_ab >= zero && on_ab < ab_ab)
  {
    const Real fraction = on_ab / ab_ab;
    return {one - fraction, fraction, zero};
  }
  if (for_b <= zero && on_ac >= zero && on_ac < ac_ac)
  {
    const Real fraction = on_ac / ac_ac;
    return {one - fraction, zero, fraction};
  }
  if (for_a <= zero && on_bc > zero && on_cb > zero)
  {
    const Real fraction = on_bc / (on_bc + on_cb);
    return {zero, one - fraction, fraction};
  }
  const Real size = ab_ab + ac_ac;
  const bool is_wide = squared > narrow_squared_ratio<Real> * size * size;
  const Vector3<Real> at_foot(for_a, for_b, for_c);
  const Real per_whole = is_wide && is_over_face(at_foot) ? Real(one / squared) : zero;
  return at_foot * per_whole;
}

/// The point of a triangle of corners [m] that is closest to the origin; P13. Sizes from 1e-70 to
/// 1e70 in double.
///
/// By its region, unless it is near: there the way is a small difference of large numbers.
template <class Real>
Nearest<Real>
nearest_by_region(const Vector3<Real>& a, const Vector3<Real>& b, const Vector3<Real>& c)
{
  const Vector3<Real> weights = barycentric_by_region(a, b, c);
  const Nearest<Real> nearest{
      {weights.x(), weights.y(), weights.z(), Real(0)},
      weights.x() * a + weights.y() * b + weights.z() * c};
  const Real size = (b - a).squaredNorm() + (c - a).squaredNorm();
  const bool is_far = nearest.point.squaredNorm() > near_squared_ratio<Real> * size;
  return is_far ? nearest : nearest_with_care(a, b, c);
}
// [nearest_by_region]

} // namespace cookbook
