#pragma once

/// \file
/// \brief A patch seen along a normal: its area, its ends, its height above any place.

#include "06_world/shapes/facing_patch.hpp"

#include <cmath>
#include <utility>

namespace cookbook
{

// [flat_patch]
/// A patch in the axes of a basis: x and y are across its third column, z along it.
inline PatchPolygon in_basis(const PatchPolygon& patch, const Matrix3<double>& basis)
{
  PatchPolygon flat = patch;
  for (int i = 0; i < patch.size; ++i)
  {
    flat.corners[std::size_t(i)].point = basis.transpose() * patch[i].point;
  }
  return flat;
}

/// What is known of a patch in a basis.
struct FlatPatch
{
  PatchPolygon polygon;       ///< in the basis
  double area = 0;            ///< [m²], doubled; negative where the corners go clockwise
  Vector3<double> middle;     ///< [m], the mean of its corners
  std::pair<int, int> ends{}; ///< the two corners farthest apart
  double length = 0;          ///< [m], how far

  explicit FlatPatch(const PatchPolygon& flat) : polygon(flat), middle(0, 0, 0)
  {
    for (int i = 0; i < flat.size; ++i)
    {
      const Vector3<double>&p = flat[i].point, &q = flat[i + 1].point;
      area += p.x() * q.y() - p.y() * q.x();
      middle += p / flat.size;
      for (int j = 0; j < i; ++j)
      {
        if (const double apart = (p - flat[j].point).norm(); apart > length)
        {
          length = apart;
          ends = {j, i};
        }
      }
    }
  }

  /// Whether it is a point or a segment, but for a hundred-thousandth.
  bool is_thin() const { return std::abs(area) <= 1e-5 * length * length; }

  /// From the one end to the other, without height [m].
  Vector3<double> along() const
  {
    const Vector3<double> way = polygon[ends.second].point - polygon[ends.first].point;
    return {way.x(), way.y(), 0};
  }
};

/// The height of a patch above any place, by the plane that fits its corners best; level across a
/// thin one.
inline double height_at(const FlatPatch& patch, const Vector3<double>& place)
{
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  Eigen::Vector2d rises = Eigen::Vector2d::Zero();
  for (int i = 0; i < patch.polygon.size; ++i)
  {
    const Vector3<double> arm = patch.polygon[i].point - patch.middle;
    squares += arm.head<2>() * arm.head<2>().transpose();
    rises += arm.z() * arm.head<2>();
  }
  const Eigen::Vector2d from_middle = (place - patch.middle).head<2>();
  if (patch.is_thin())
  {
    const double whole = squares.trace();
    const Eigen::Vector2d along = patch.along().head<2>();
    const double part = whole > 0 ? from_middle.dot(along) / whole : 0;
    return patch.middle.z() + (whole > 0 ? part * rises.dot(along) / along.squaredNorm() : 0);
  }
  return patch.middle.z() + from_middle.dot(squares.inverse() * rises);
}
// [flat_patch]

} // namespace cookbook
