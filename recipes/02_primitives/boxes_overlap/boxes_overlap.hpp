#pragma once

/// \file
/// \brief Whether two turned boxes overlap, by the axes that may part them.

#include "02_primitives/shape_bounds/box_shadow.hpp"

#include <limits>

namespace cookbook
{

// [boxes_overlap]
/// Whether the shadows of two boxes on an axis leave no gap that is more than rounding.
///
/// The axis may have any length up to 1: all shadows shrink with it. What rounding may do does not:
/// of nearly parallel edges, the cross product is little but rounding, and must not part boxes.
template <class Real>
bool shadows_overlap(const Obb<Real>& a, const Obb<Real>& b, const Vector3<Real>& axis)
{
  using std::abs;
  const Vector3<Real> offset = b.center - a.center;
  const Real sizes = offset.template lpNorm<1>() + a.half_extents.sum() + b.half_extents.sum();
  const Real rounding = 8 * Real(std::numeric_limits<Real>::epsilon()) * sizes;
  return abs(offset.dot(axis)) <= box_radius(a, axis) + box_radius(b, axis) + rounding;
}

/// Whether the faces of two boxes let them overlap: three axes of each. If not, they are apart.
template <class Real>
bool faces_overlap(const Obb<Real>& a, const Obb<Real>& b)
{
  for (int i = 0; i < 3; ++i)
  {
    if (!shadows_overlap<Real>(a, b, a.axes.col(i)) || !shadows_overlap<Real>(a, b, b.axes.col(i)))
    {
      return false;
    }
  }
  return true;
}

/// Whether two boxes overlap: by their faces, and by nine axes that are square to an edge of each.
/// Touching to rounding counts.
template <class Real>
bool boxes_overlap(const Obb<Real>& a, const Obb<Real>& b)
{
  if (!faces_overlap(a, b))
  {
    return false;
  }
  for (int i = 0; i < 9; ++i)
  {
    if (!shadows_overlap<Real>(a, b, a.axes.col(i / 3).cross(b.axes.col(i % 3))))
    {
      return false;
    }
  }
  return true;
}
// [boxes_overlap]

// [spheres_overlap]
/// Whether the spheres around two boxes overlap. If not, the boxes are apart.
template <class Real>
bool spheres_around_overlap(const Obb<Real>& a, const Obb<Real>& b)
{
  using std::sqrt;
  const Real radii = sqrt(a.half_extents.squaredNorm()) + sqrt(b.half_extents.squaredNorm());
  const Real slack = Real(1) + 8 * std::numeric_limits<Real>::epsilon();
  return (b.center - a.center).squaredNorm() <= radii * radii * slack;
}
// [spheres_overlap]

} // namespace cookbook
