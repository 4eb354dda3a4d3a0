#pragma once

/// \file
/// \brief Whether two oriented boxes overlap, by the axes that may part them.

#include "02_primitives/boxes_overlap/box_axes.hpp"

#include <limits>

namespace cookbook
{

// [boxes_overlap]
/// What rounding may do to the projections [m] of two boxes on an axis that is no longer than 1.
template <class Real>
Real projection_rounding(const RelativeBoxes<Real>& boxes)
{
  return 8 * Real(std::numeric_limits<Real>::epsilon()) *
         (boxes.offset.template lpNorm<1>() + boxes.half_a.sum() + boxes.half_b.sum());
}

/// Whether the projections of two boxes on an axis leave no gap that is more than rounding.
template <class Real>
bool projections_overlap(const AxisOverlap<Real>& on_axis, const Real& rounding)
{
  return on_axis.overlap >= -rounding;
}

/// Whether the faces of two boxes let them overlap: three axes of each. If not, they are apart.
template <class Real>
bool faces_overlap(const RelativeBoxes<Real>& boxes, const Real& rounding)
{
  for (int i = 0; i < 3; ++i)
  {
    if (!projections_overlap(face_axis_of_a(boxes, i), rounding) ||
        !projections_overlap(face_axis_of_b(boxes, i), rounding))
    {
      return false;
    }
  }
  return true;
}

/// The same for two boxes in the world.
template <class Real>
[[gnu::flatten]] bool faces_overlap(const Obb<Real>& a, const Obb<Real>& b)
{
  const RelativeBoxes<Real> boxes = relative_boxes(a, b);
  return faces_overlap(boxes, projection_rounding(boxes));
}

/// Whether the three axes that are perpendicular to an edge of B and to A's edge i let them
/// overlap.
template <class Real>
bool edges_overlap(const RelativeBoxes<Real>& boxes, int i, const Real& rounding)
{
  const Vector3<Real> triple = triple_products(boxes, i);
  return projections_overlap(edge_axis(boxes, i, 0, triple), rounding) &&
         projections_overlap(edge_axis(boxes, i, 1, triple), rounding) &&
         projections_overlap(edge_axis(boxes, i, 2, triple), rounding);
}

/// Whether two boxes overlap: by their faces, and by nine axes that are perpendicular to an edge of
/// each. Touching to rounding counts.
template <class Real>
[[gnu::flatten]] bool boxes_overlap(const Obb<Real>& a, const Obb<Real>& b)
{
  const RelativeBoxes<Real> boxes = relative_boxes(a, b);
  const Real rounding = projection_rounding(boxes);
  return faces_overlap(boxes, rounding) && edges_overlap(boxes, 0, rounding) &&
         edges_overlap(boxes, 1, rounding) && edges_overlap(boxes, 2, rounding);
}
// [boxes_overlap]

// [spheres_overlap]
/// Whether the spheres around two boxes overlap. If not, the boxes are apart.
template <class Real>
bool spheres_around_overlap(const Obb<Real>& a, const Obb<Real>& b)
{
  using std::sqrt;
  const Real radii = sqrt(a.half_extents.squaredNorm()) + sqrt(b.half_extents.squaredNorm());
  const Real tolerance = Real(1) + 8 * std::numeric_limits<Real>::epsilon();
  return (b.center - a.center).squaredNorm() <= radii * radii * tolerance;
}
// [spheres_overlap]

} // namespace cookbook
