#pragma once

/// \file
/// \brief What two patches that face each other have in common, as contact points.

#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "06_world/shapes/flat_patch.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace cookbook
{

// [common_patch]
/// The part of a polygon that lies over a patch, which is not thin: cut at one side after the
/// other.
inline PatchPolygon cut_to_patch(PatchPolygon polygon, const FlatPatch& patch, double tolerance)
{
  const double turn = patch.area < 0 ? -1 : 1;
  for (int side = 0; side < patch.polygon.size; ++side)
  {
    const Vector3<double>& from = patch.polygon[side].point;
    const Vector3<double> edge = patch.polygon[side + 1].point - from;
    const Vector3<double> out = turn * Vector3<double>(edge.y(), -edge.x(), 0).normalized();
    const auto distance = [&](const PolygonCorner<double>& corner)
    { return out.dot(corner.point - from); };
    polygon =
        cut_at_line(polygon, distance, patch_directions + patch.polygon[side].edge, tolerance);
  }
  return polygon;
}

/// The part of a thin patch that lies along another: none where they cross, which is at one point.
inline PatchPolygon cut_to_segment(const FlatPatch& thin, const FlatPatch& other, double tolerance)
{
  const Vector3<double> along = other.along(), way = thin.along();
  const Vector3<double> beside = thin.middle - other.middle;
  const double parallel = patch_lean * other.length;
  const bool crosses = std::abs(along.cross(way).z()) > parallel * thin.length ||
                       std::abs(along.cross(beside).z()) > parallel * other.length;
  PatchPolygon segment;
  if (crosses || !(other.length > 0) || !(thin.length > 0))
  {
    return segment;
  }
  segment.add(thin.polygon[thin.ends.first]);
  segment.add(thin.polygon[thin.ends.second]);
  for (const int end : {other.ends.first, other.ends.second})
  {
    const double sign = end == other.ends.second ? 1 : -1;
    const auto distance = [&](const PolygonCorner<double>& corner)
    { return sign * along.dot(corner.point - other.polygon[end].point) / other.length; };
    segment = cut_at_line(segment, distance, patch_directions + other.polygon[end].edge, tolerance);
  }
  return segment;
}

/// Of more than eight corners those farthest in eight directions.
inline PatchPolygon widest_eight(const PatchPolygon& polygon)
{
  if (polygon.size <= 8)
  {
    return polygon;
  }
  std::array<bool, 16> kept{};
  for (int k = 0; k < 8; ++k)
  {
    const double angle = k * std::numbers::pi / 4;
    const Vector3<double> toward(std::cos(angle), std::sin(angle), 0);
    int best = 0;
    for (int i = 1; i < polygon.size; ++i)
    {
      best = toward.dot(polygon[i].point - polygon[best].point) > 0 ? i : best;
    }
    kept[std::size_t(best)] = true;
  }
  PatchPolygon few;
  for (int i = 0; i < polygon.size; ++i)
  {
    if (kept[std::size_t(i)])
    {
      few.add(polygon[i]);
    }
  }
  return few;
}

/// Adds what two patches have in common to a manifold, where they are no farther apart than a
/// margin [m]; lengths below the tolerance [m] are equal.
///
/// The smaller patch is cut to the larger one, B's unless A's is smaller by a hundredth. A corner's
/// feature is the two edges that meet there, and which patch was cut.
inline void add_common_patch(
    Manifold<double>& manifold, const PatchPolygon& patch_a, const PatchPolygon& patch_b,
    double margin, double tolerance)
{
  if (patch_a.size == 0 || patch_b.size == 0)
  {
    return;
  }
  const Matrix3<double> basis = patch_basis(manifold.normal);
  const FlatPatch a(in_basis(patch_a, basis)), b(in_basis(patch_b, basis));
  const bool thin = a.is_thin() && b.is_thin();
  const bool cuts_a =
      thin ? 1.01 * a.length < b.length : 1.01 * std::abs(a.area) < std::abs(b.area);
  const FlatPatch &cut = cuts_a ? a : b, &whole = cuts_a ? b : a;
  const PatchPolygon common =
      thin ? cut_to_segment(cut, whole, tolerance) : cut_to_patch(cut.polygon, whole, tolerance);
  const PatchPolygon few = widest_eight(common);
  for (int i = 0; i < few.size; ++i)
  {
    const Vector3<double>& point = few[i].point;
    const double height = height_at(whole, point);
    const double depth = cuts_a ? point.z() - height : height - point.z();
    if (depth >= -margin)
    {
      const int feature = 1 + few[i].edge + 16 * few[i - 1].edge + (cuts_a ? 256 : 0);
      const Vector3<double> midway(point.x(), point.y(), (point.z() + height) / 2);
      manifold.points.push_back({basis * midway, depth, std::uint32_t(feature)});
    }
  }
}
// [common_patch]

} // namespace cookbook
