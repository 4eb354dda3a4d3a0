#pragma once

/// \file
/// \brief The six planes of what a matrix keeps, and what may be in view.

#include "01_math/matrices/cofactors.hpp"
#include "02_primitives/camera/projection.hpp"
#include "02_primitives/shape_bounds/box_radius.hpp"
#include "02_primitives/shapes/shapes.hpp"
#include "common/math/norm.hpp"
#include "common/math/wide.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace cookbook
{

// [frustum]
/// All points behind six planes: left, right, bottom, top, near, far; their normals point out.
template <class Real>
struct Frustum
{
  std::array<Plane<Real>, 6> planes; ///< world, if the matrix came from the world
};
// [frustum]

// [kept_half]
/// The half-space of all x with row · (x, 1) ≥ 0.
///
/// A row without a direction keeps everything or nothing: its plane is as far up, or down, as
/// numbers go.
template <class Real>
Plane<Real> kept_half(const Vector<double, 4>& row)
{
  const double most = static_cast<double>(std::numeric_limits<Real>::max());
  const Direction<double> out = normalize<double>(Vector3<double>(-row.head<3>()));
  if (out.length == 0)
  {
    return {Vector3<Real>::UnitY(), static_cast<Real>(row[3] < 0 ? -most : most)};
  }
  const double distance = std::clamp(row[3] / out.length, -most, most);
  return {out.unit.template cast<Real>(), static_cast<Real>(distance)};
}
// [kept_half]

// [frustum_planes]
/// The planes of what the matrix keeps, in the coordinates that it takes; P18.
///
/// Where depth runs from 1 to 0, the plane called near is the far one, and the other way round.
template <class Real>
Frustum<Real> frustum_planes(const Matrix4<Real>& matrix, DepthRange depths)
{
  using Row = Vector<double, 4>;
  const auto row = [&](int i) -> Row { return matrix.row(i).transpose().template cast<double>(); };
  const Row w = row(3);
  const Row nearest = depths == DepthRange::zero_to_one ? row(2) : Row(w + row(2));
  return {
      {kept_half<Real>(w + row(0)), kept_half<Real>(w - row(0)), kept_half<Real>(w + row(1)),
       kept_half<Real>(w - row(1)), kept_half<Real>(nearest), kept_half<Real>(w - row(2))}};
}
// [frustum_planes]

// [may_see]
/// False only if the sphere is all on the outer side of one plane; touching may be seen.
template <class Real>
bool may_see(const Frustum<Real>& frustum, const Sphere<Real>& sphere)
{
  using W = Wide<Real>;
  const Vector3<W> center = widen(sphere.center);
  return std::all_of(
      frustum.planes.begin(), frustum.planes.end(),
      [&](const Plane<Real>& plane)
      { return widen(plane.normal).dot(center) <= W(plane.distance) + W(sphere.radius); });
}

/// False only if the box is empty or all on the outer side of one plane; touching may be seen.
template <class Real>
bool may_see(const Frustum<Real>& frustum, const Eigen::AlignedBox<Real, 3>& box)
{
  const auto inmost_is_inside = [&](const Plane<Real>& plane)
  {
    Wide<Real> inmost = 0;
    for (int i = 0; i < 3; ++i)
    {
      const Real n = plane.normal[i];
      inmost += Wide<Real>(n) * Wide<Real>(n > Real(0) ? box.min()[i] : box.max()[i]);
    }
    return inmost <= Wide<Real>(plane.distance);
  };
  return !box.isEmpty() &&
         std::all_of(frustum.planes.begin(), frustum.planes.end(), inmost_is_inside);
}
// [may_see]

/// False only if the oriented box is all on the outer side of one plane; touching may be seen.
template <class Real>
bool may_see(const Frustum<Real>& frustum, const Obb<Real>& box)
{
  using W = Wide<Real>;
  const Obb<W> wide{widen(box.center), widen(box.axes), widen(box.half_extents)};
  return std::all_of(
      frustum.planes.begin(), frustum.planes.end(),
      [&](const Plane<Real>& plane)
      {
        const Vector3<W> n = widen(plane.normal);
        return n.dot(wide.center) - box_radius<W>(wide, n) <= W(plane.distance);
      });
}

// [may_see_corners]
/// The same, asked both ways: false also if the view's eight corners are all on the outer side of
/// one face of the box.
///
/// It is right about more boxes than the planes alone; it is not right about all.
template <class Real>
bool may_see(
    const Frustum<Real>& frustum, const std::array<Vector3<Real>, 8>& corners,
    const Eigen::AlignedBox<Real, 3>& box)
{
  Eigen::AlignedBox<Real, 3> around;
  for (const Vector3<Real>& corner : corners)
  {
    around.extend(corner);
  }
  return may_see(frustum, box) && around.intersects(box);
}
// [may_see_corners]

} // namespace cookbook
