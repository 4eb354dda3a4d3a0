#pragma once

/// \file
/// \brief The flat or straight part of a convex shape that faces a direction, by its support
/// function.

#include "04_obb_manifolds/face_clipping/clipped_face.hpp"
#include "06_world/shapes/placed_convex.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace cookbook
{

// [facing_patch]
/// The corners of a patch, or of what two patches have in common.
using PatchPolygon = FacePolygon<double, 16>;

/// How many directions about a normal are asked for the corners of a patch.
inline constexpr int patch_directions = 8;

/// How far [1] these lean away from the normal: a face that is out of level by less is found whole.
inline constexpr double patch_lean = 0.02;

/// Corners closer together than this fraction of a shape's outer radius are one; a corner farther
/// off the shape than a tenth of that is none.
inline constexpr double patch_merge = 1e-4;

/// A basis with a unit normal, in a shape's own frame, as its third column, that turns as little as
/// can be when the shape rolls: the first is across the y axis, or the x axis where the normal is
/// close to y.
inline Matrix3<double> patch_basis(const Vector3<double>& normal)
{
  const bool is_end = std::abs(normal.y()) > 0.8;
  const Vector3<double> axis = is_end ? Vector3<double>::UnitX() : Vector3<double>::UnitY();
  const Vector3<double> u = normal.cross(axis).normalized();
  Matrix3<double> basis;
  basis << u, normal.cross(u), normal;
  return basis;
}

/// The support points along a normal that leans a whole and a half patch_lean towards a direction.
template <class Shape>
std::array<Vector3<double>, 2>
leaning_support(const Shape& shape, const Vector3<double>& normal, const Vector3<double>& toward)
{
  return {
      support(shape, normal + patch_lean * toward),
      support(shape, normal + patch_lean / 2 * toward)};
}

/// A corner of a patch: where the support point goes as the direction leans less and less.
///
/// On a face, at a corner or an end of an edge it stays where it is. On a curved part it moves
/// along with the lean, evenly, and falls back from the highest place as its square: two leans, one
/// half of the other, say where it ends.
template <class Shape>
Vector3<double>
patch_corner(const Shape& shape, const Vector3<double>& normal, const Vector3<double>& toward)
{
  const auto [whole, half] = leaning_support(shape, normal, toward);
  const double height = (4 * normal.dot(half) - normal.dot(whole)) / 3;
  const Vector3<double> corner = 2 * half - whole;
  return corner + (height - normal.dot(corner)) * normal;
}

/// The axis of a shape that is within patch_lean of a unit normal, both in its own frame, or the
/// normal itself. A face across an axis, even a round one, keeps its corners about it.
inline Vector3<double> axis_near(const Vector3<double>& normal)
{
  int most = 0;
  normal.cwiseAbs().maxCoeff(&most);
  const Vector3<double> axis = Vector3<double>::Unit(most) * (normal[most] < 0 ? -1 : 1);
  return (axis - normal).norm() < patch_lean ? axis : normal;
}

/// The corners of the part of a shape that faces a unit direction, world, one after the other
/// around it: one of a sphere, two of a cylinder that lies, eight of one that stands. They are
/// given from a point [m], world; each knows by `edge` which of the eight directions it is farthest
/// in.
template <class Shape>
PatchPolygon facing_patch(
    const Placed<Shape>& placed, const Vector3<double>& direction, const Vector3<double>& from)
{
  const auto& [center, axes] = placed.pose;
  const Vector3<double> normal = axes.transpose() * direction;
  const Matrix3<double> basis = patch_basis(axis_near(normal));
  const double merge = patch_merge * extent(placed.shape).outer;
  PatchPolygon patch;
  for (int k = 0; k < patch_directions; ++k)
  {
    const double angle = (k + 0.5) * 2 * std::numbers::pi / patch_directions;
    const Vector3<double> toward = std::cos(angle) * basis.col(0) + std::sin(angle) * basis.col(1);
    const auto [whole, half] = leaning_support<Shape>(placed.shape, basis.col(2), toward);
    const bool stays = (whole - half).norm() < patch_merge * merge;
    const Vector3<double> corner =
        stays ? whole : patch_corner<Shape>(placed.shape, normal, toward);
    bool is_new = std::abs(distance(placed.shape, corner).length) < merge / 10;
    const Vector3<double> point = (center - from) + axes * corner;
    for (int i = 0; i < patch.size; ++i)
    {
      is_new = is_new && (patch[i].point - point).norm() > merge;
    }
    if (is_new)
    {
      patch.add({point, k});
    }
  }
  return patch;
}
// [facing_patch]

} // namespace cookbook
