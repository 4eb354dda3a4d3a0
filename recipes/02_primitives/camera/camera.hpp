#pragma once

/// \file
/// \brief A camera: from the world to a pixel, from a pixel to the world, and the ray of a pixel.

#include "01_math/matrices/cofactors.hpp"
#include "01_math/transforms/transforms.hpp"
#include "02_primitives/camera/frustum.hpp"
#include "02_primitives/camera/look_at.hpp"
#include "02_primitives/camera/projection.hpp"
#include "02_primitives/shapes/shapes.hpp"
#include "common/math/norm.hpp"

#include <array>
#include <optional>

namespace cookbook
{

// [camera]
/// A camera: where it stands, what its lens does, and how large its picture is.
template <class Real>
struct Camera
{
  Isometry3<Real> pose; ///< from the camera to the world: x right, y up, −z ahead
  Matrix4<Real>
      projection;       ///< from the camera to clip space; rows 0 and 1 look at x or y, and z, w
  Vector<Real, 2> size; ///< [pixels], width and height
};
// [camera]

/// The matrix from the world to clip space.
template <class Real>
Matrix4<Real> clip_from_world(const Camera<Real>& camera)
{
  return camera.projection * rigid_inverse(camera.pose).matrix();
}

// [to_pixel]
/// A place in the picture.
template <class Real>
struct PixelDepth
{
  Vector<Real, 2> pixel; ///< [pixels] from the upper left corner, y down
  Real depth;            ///< [1] as the projection makes it
};

/// Where a point of the world is seen, in or beside the picture; nothing for what is not ahead.
template <class Real>
std::optional<PixelDepth<Real>> to_pixel(const Camera<Real>& camera, const Vector3<Real>& point)
{
  using V = Vector3<double>;
  const V local =
      to_local<double>(camera.pose.template cast<double>(), point.template cast<double>());
  const Vector<double, 4> clip = camera.projection.template cast<double>() * local.homogeneous();
  const V ndc = clip.head<3>() / (clip[3] > 0 ? clip[3] : 1);
  const double x = (1 + ndc.x()) / 2 * static_cast<double>(camera.size.x());
  const double y = (1 - ndc.y()) / 2 * static_cast<double>(camera.size.y());
  const Vector3<Real> seen = V(x, y, ndc.z()).template cast<Real>();
  if (!(clip[3] > 0) || !seen.allFinite())
  {
    return std::nullopt;
  }
  return PixelDepth<Real>{seen.template head<2>(), seen.z()};
}
// [to_pixel]

// [to_ndc]
/// A pixel as clip space has it after the division by w: −1…1 to the right and up.
template <class Real>
Vector<double, 2> to_ndc(const Camera<Real>& camera, const Vector<Real, 2>& pixel)
{
  const Vector<double, 2> fraction =
      pixel.template cast<double>().cwiseQuotient(camera.size.template cast<double>());
  return {2 * fraction.x() - 1, 1 - 2 * fraction.y()};
}
// [to_ndc]

// [local_at]
/// The point in the camera's coordinates that is seen at `ndc` and has this z.
template <class Real>
Vector3<double> local_at(const Camera<Real>& camera, const Vector<double, 2>& ndc, double z)
{
  const Matrix4<double> m = camera.projection.template cast<double>();
  const double w = m(3, 2) * z + m(3, 3);
  return {
      (ndc.x() * w - m(0, 2) * z - m(0, 3)) / m(0, 0),
      (ndc.y() * w - m(1, 2) * z - m(1, 3)) / m(1, 1), z};
}
// [local_at]

// [unproject]
/// The point of the world at a pixel and a depth; nothing where no point ahead has that depth.
template <class Real>
std::optional<Vector3<Real>> unproject(const Camera<Real>& camera, const PixelDepth<Real>& seen)
{
  const Matrix4<double> m = camera.projection.template cast<double>();
  // depth = (m22 z + m23) / (m32 z + m33), solved for z.
  const double depth = static_cast<double>(seen.depth), below = m(2, 2) - depth * m(3, 2);
  const double z = (depth * m(3, 3) - m(2, 3)) / (below != 0 ? below : 1);
  if (below == 0 || !(m(3, 2) * z + m(3, 3) > 0))
  {
    return std::nullopt;
  }
  const Vector3<double> local = local_at(camera, to_ndc(camera, seen.pixel), z);
  const Vector3<Real> world = (camera.pose.template cast<double>() * local).template cast<Real>();
  return world.allFinite() ? std::optional<Vector3<Real>>(world) : std::nullopt;
}
// [unproject]

// [picking_ray]
/// The ray of all points that are seen at a pixel: from the eye, or, without perspective, from
/// the camera's plane. Its direction is of length one.
template <class Real>
Ray<Real> picking_ray(const Camera<Real>& camera, const Vector<Real, 2>& pixel)
{
  const Isometry3<double> pose = camera.pose.template cast<double>();
  const Vector<double, 2> ndc = to_ndc(camera, pixel);
  const bool from_the_eye = camera.projection(3, 2) != Real(0);
  const Vector3<double> origin = from_the_eye ? Vector3<double>(0, 0, 0) : local_at(camera, ndc, 0);
  const Vector3<double> direction = local_at(camera, ndc, -1) - origin;
  const Vector3<double> unit = normalize<double>(Vector3<double>(pose.linear() * direction)).unit;
  return {(pose * origin).template cast<Real>(), unit.template cast<Real>()};
}
// [picking_ray]

// [view_corners]
/// The eight corners of what is in view: four at the depth `near_depth`, four at `far_depth`, such
/// as −1 and 1; nothing where one of them is at infinity.
template <class Real>
std::optional<std::array<Vector3<Real>, 8>>
view_corners(const Camera<Real>& camera, Real near_depth, Real far_depth)
{
  std::array<Vector3<Real>, 8> corners;
  for (unsigned i = 0; i < 8; ++i)
  {
    const Real x = i & 1U ? camera.size.x() : Real(0), y = i & 2U ? camera.size.y() : Real(0);
    const std::optional<Vector3<Real>> corner =
        unproject(camera, {Vector<Real, 2>(x, y), i & 4U ? far_depth : near_depth});
    if (!corner)
    {
      return std::nullopt;
    }
    corners[i] = *corner;
  }
  return corners;
}
// [view_corners]

} // namespace cookbook
