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
  Vector3<Wide<Real>> origin; ///< [m], world
  Vector3<Wide<Real>>
      inverse;              ///< [1], of the direction; infinite along an axis that it is square to
  std::array<bool, 3> back; ///< whether the direction goes down an axis
  Wide<Real> little;        ///< [m], by which boxes are larger, so that rounding loses no triangle
};

/// Prepares a ray for boxes inside of `whole`.
template <class Real>
RayForBoxes<Real> ray_for_boxes(const Ray<Real>& ray, const Eigen::AlignedBox<Real, 3>& whole)
{
  const Vector3<Wide<Real>> d = widen(ray.direction);
  return {
      widen(ray.origin),
      d.cwiseInverse(),
      {std::signbit(d.x()), std::signbit(d.y()), std::signbit(d.z())},
      walk_rounding(whole, ray.origin)};
}
// [ray_for_boxes]

// [ray_enters_box]
/// The t at which a ray enters a box, 0 from inside; infinite if it misses the box.
///
/// Along an axis that the ray is square to, the quotients are infinite, with the right signs. On
/// the very edge they are no numbers, and no comparison takes them: that axis is not asked.
template <class Real>
Wide<Real> ray_enters_box(const RayForBoxes<Real>& ray, const Eigen::AlignedBox<Real, 3>& box)
{
  using W = Wide<Real>;
  W enter = 0, leave = std::numeric_limits<W>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    const W low = (W(box.min()[i]) - ray.origin[i] - ray.little) * ray.inverse[i];
    const W high = (W(box.max()[i]) - ray.origin[i] + ray.little) * ray.inverse[i];
    const bool back = ray.back[static_cast<std::size_t>(i)];
    const W near = back ? high : low, far = back ? low : high;
    enter = near > enter ? near : enter;
    leave = far < leave ? far : leave;
  }
  return enter <= leave ? enter : std::numeric_limits<W>::infinity();
}
// [ray_enters_box]

} // namespace cookbook
