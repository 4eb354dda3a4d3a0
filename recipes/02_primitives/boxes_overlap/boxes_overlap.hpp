#pragma once

/// \file
/// \brief Whether two turned boxes overlap, by the axes that may part them.

#include "02_primitives/boxes_overlap/box_axes.hpp"

#include <limits>

namespace cookbook
{

// [boxes_overlap]
/// What rounding may do to the shadows [m] of two boxes on an axis that is no longer than 1.
template <class Real>
Real shadow_rounding(const RelativeBoxes<Real>& boxes)
{
  return 8 * Real(std::numeric_limits<Real>::epsilon()) *
         (boxes.offset.template lpNorm<1>() + boxes.half_a.sum() + boxes.half_b.sum());
}

/// Whether the shadows of two boxes on an axis leave no gap that is more than rounding.
template <class Real>
bool shadows_overlap(const AxisOverlap<Real>& on_axis, const Real& rounding)
{
  return on_axis.overlap >= -rounding;
}

/// Whether the faces of two boxes let them overlap: three axes of each. If not, they are apart.
template <class Real>
bool faces_overlap(const RelativeBoxes<Real>& boxes, const Real& rounding)
{
  for (int i = 0; i < 3; ++i)
  {
    if (!shadows_overlap(face_axis_of_a(boxes, i), rounding) ||
        !shadows_overlap(face_axis_of_b(boxes, i), rounding))
    {
      return false;
    }
  }
  return true;
}

/// The same for two boxes in the world.
template <class Real>
bool faces_overlap(const Obb<Real>& a, const Obb<Real>& b)
{
  const RelativeBoxes<Real> boxes = relative_boxes(a, b);
  return faces_overlap(boxes, shadow_rounding(boxes));
}

/// Whether two boxes overlap: by their faces, and by nine axes that are square to an edge of each.
/// Touching to rounding counts.
template <class Real>
bool boxes_overlap(const Obb<Real>& a, const Obb<Real>& b)
{
  const RelativeBoxes<Real> boxes = relative_boxes(a, b);
  const Real rounding = shadow_rounding(boxes);
  if (!faces_overlap(boxes, rounding))
  {
    return false;
  }
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      if (!shadows_overlap(edge_axis(boxes, i, j), rounding))
      {
        return false;
      }
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
