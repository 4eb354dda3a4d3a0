#pragma once

/// \file
/// \brief When a ray enters a box of a tree: never later than it meets anything inside.

#include "02_primitives/meshes/walk_volumes.hpp"
#include "02_primitives/shapes/shapes.hpp"
#include "common/math/wide.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace cookbook
{

// [ray_for_boxes]
/// What a ray needs for many boxes that all lie in one.
template <class Real>
struct RayForBoxes
{
  Vector3<Real> origin;     ///< [m], world
  Vector3<Real> inverse;    ///< [1], of the direction with its longest component taken as 1;
                            ///< infinite along an axis that it is perpendicular to
  Vector3<Real> little;     ///< [m], by which boxes are larger, so that rounding loses no triangle;
                            ///< negative along an axis that the direction goes down
  std::array<bool, 3> back; ///< whether it goes down an axis
};

/// Prepares a ray for boxes inside of `whole`.
template <class Real>
RayForBoxes<Real> ray_for_boxes(const Ray<Real>& ray, const Eigen::AlignedBox<Real, 3>& whole)
{
  const Real longest = ray.direction.cwiseAbs().maxCoeff();
  RayForBoxes<Real> prepared{ray.origin, longest / ray.direction.array(), {}, {}};
  const Real little = walk_rounding<Real>(whole, ray.origin);
  for (int i = 0; i < 3; ++i)
  {
    const bool back = std::signbit(ray.direction[i]);
    prepared.back[static_cast<std::size_t>(i)] = back;
    prepared.little[i] = back ? -little : little;
  }
  return prepared;
}
// [ray_for_boxes]

// [ray_enters_box]
/// How far [m] along its longest axis a ray goes until it enters a box, 0 from inside; infinite if
/// it misses the box.
///
/// Along an axis that the ray is perpendicular to, the quotients are infinite, with the right
/// signs. On the very edge they are no numbers, and no comparison takes them: that axis is not
/// asked.
template <class Real>
Real ray_enters_box(const RayForBoxes<Real>& ray, const Eigen::AlignedBox<Real, 3>& box)
{
  Real enter = 0, leave = std::numeric_limits<Real>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    const bool back = ray.back[static_cast<std::size_t>(i)];
    const Real near_side = back ? box.max()[i] : box.min()[i];
    const Real far_side = back ? box.min()[i] : box.max()[i];
    const Real entry = (near_side - ray.origin[i] - ray.little[i]) * ray.inverse[i];
    const Real exit = (far_side - ray.origin[i] + ray.little[i]) * ray.inverse[i];
    enter = entry > enter ? entry : enter;
    leave = exit < leave ? exit : leave;
  }
  return enter <= leave ? enter : std::numeric_limits<Real>::infinity();
}
// [ray_enters_box]

} // namespace cookbook
