#pragma once

/// \file
/// \brief What is truly in view, by all separating axes, and how many random boxes each way draws.

#include "02_primitives/camera/camera.hpp"

#include <array>
#include <random>
#include <vector>

namespace cookbook
{

/// Whether the two sets of corners have a gap along the axis.
template <class CornersA, class CornersB>
bool separated_along(const Vector3<double>& axis, const CornersA& a, const CornersB& b)
{
  double most_a = -1e300, least_a = 1e300, most_b = -1e300, least_b = 1e300;
  for (const Vector3<double>& x : a)
  {
    most_a = std::max(most_a, axis.dot(x));
    least_a = std::min(least_a, axis.dot(x));
  }
  for (const Vector3<double>& x : b)
  {
    most_b = std::max(most_b, axis.dot(x));
    least_b = std::min(least_b, axis.dot(x));
  }
  return most_a < least_b || most_b < least_a;
}

/// The eight corners of a box.
inline std::array<Vector3<double>, 8> corners_of(const Eigen::AlignedBox<double, 3>& box)
{
  std::array<Vector3<double>, 8> corners;
  for (unsigned i = 0; i < 8; ++i)
  {
    corners[i] = box.corner(static_cast<Eigen::AlignedBox<double, 3>::CornerType>(i));
  }
  return corners;
}

/// Whether view and box truly share a point, but for rounding: no face of either and no pair of
/// edges separates them.
inline bool truly_in_view(
    const Frustum<double>& planes, const std::array<Vector3<double>, 8>& corners,
    const Eigen::AlignedBox<double, 3>& box)
{
  std::vector<Vector3<double>> axes;
  for (const Plane<double>& plane : planes.planes)
  {
    axes.push_back(plane.normal);
  }
  const std::array<Vector3<double>, 6> edges{corners[1] - corners[0], corners[2] - corners[0],
                                             corners[4] - corners[0], corners[5] - corners[1],
                                             corners[6] - corners[2], corners[7] - corners[3]};
  for (int i = 0; i < 3; ++i)
  {
    axes.push_back(Vector3<double>::Unit(i));
    for (const Vector3<double>& edge : edges)
    {
      axes.push_back(edge.cross(Vector3<double>::Unit(i)));
    }
  }
  const std::array<Vector3<double>, 8> of_box = corners_of(box);
  return std::none_of(
      axes.begin(), axes.end(),
      [&](const Vector3<double>& axis) { return separated_along(axis, corners, of_box); });
}

/// How many boxes each way draws.
struct DrawnBoxes
{
  int all = 0, by_planes = 0, by_corners = 0, seen = 0; ///< and how many there are, and are seen
  int lost = 0;                                         ///< seen, but not drawn
};

/// Turned cameras that see 1 to 10 m ahead, and boxes up to `largest` [m] wide around them.
inline DrawnBoxes drawn_boxes(int count, double largest)
{
  std::mt19937 random(18);
  const auto draw = [&](double least, double most)
  { return least + (most - least) * static_cast<double>(random()) * 0x1p-32; };
  const auto point = [&](double most) -> Vector3<double>
  {
    const double x = draw(-most, most), y = draw(-most, most), z = draw(-most, most);
    return {x, y, z};
  };
  const Matrix4<double> lens = *perspective(1.0, 1.5, 1.0, 10.0);
  DrawnBoxes drawn;
  for (int i = 0; i < count; ++i)
  {
    const Vector3<double> eye = point(3), target = point(3), center = point(12);
    const Camera<double> camera{look_at<double>(eye, target, {0, 1, 0}), lens, {150, 100}};
    const Vector3<double> half = point(largest / 2).cwiseAbs(); // of every size up to the largest
    const Eigen::AlignedBox<double, 3> box(center - half, center + half);
    const Frustum<double> planes =
        frustum_planes<double>(clip_from_world(camera), DepthRange::minus_one_to_one);
    const std::array<Vector3<double>, 8> corners = *view_corners<double>(camera, -1, 1);
    const bool seen = truly_in_view(planes, corners, box);
    const bool by_planes = may_see(planes, box), by_corners = may_see(planes, corners, box);
    drawn.all += 1;
    drawn.by_planes += by_planes;
    drawn.by_corners += by_corners;
    drawn.seen += seen;
    drawn.lost += seen && !by_corners;
  }
  return drawn;
}

} // namespace cookbook
