#pragma once

/// \file
/// \brief The manifold of any two convex shapes: the gap by GJK or EPA, the points by clipping the
/// patches that face each other.

#include "06_world/shapes/common_patch.hpp"
#include "06_world/shapes/convex_gap.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace cookbook
{

// [convex_manifold]
/// The feature of the one point where two shapes are closest; those of patches are less.
inline constexpr std::uint32_t closest_feature = 1u << 16;

/// By what fraction of the smaller outer radius it is deeper than all points of a patch, or left
/// out: a drum on eight points of its rim may tip until it stands on the arc between two of them.
inline constexpr double closest_gain = 3e-5;

/// A manifold of points of a patch, and of the point where the shapes are closest, if it is deeper
/// than those by more than a tolerance [m]: where they meet at a corner, on a curve, or in between.
inline void
add_closest(Manifold<double>& manifold, const ContactPoint<double>& closest, double tolerance)
{
  ContactPoints<double, 8>& points = manifold.points;
  const auto shallower = [](const auto& one, const auto& other) { return one.depth < other.depth; };
  const auto deepest = std::max_element(points.begin(), points.end(), shallower);
  if (deepest != points.end() && deepest->depth + tolerance >= closest.depth)
  {
    return;
  }
  if (points.size() == 8)
  {
    *std::min_element(points.begin(), points.end(), shallower) = closest;
    return;
  }
  points.push_back(closest);
}

/// Puts the points that go around in another order, each beside the one across: a solver that goes
/// from point to point would otherwise tilt a body around with them, and never come to rest.
inline void alternate(ContactPoints<double, 8>& points)
{
  const ContactPoints<double, 8> round = points;
  const std::size_t half = (round.size() + 1) / 2;
  for (std::size_t i = 0; i < round.size(); ++i)
  {
    points[i] = round[i / 2 + (i % 2 == 0 ? 0 : half)];
  }
}

/// The manifold of two convex shapes that touch, or will within a margin [m]: a depth below zero is
/// a gap.
template <class A, class B>
std::optional<Manifold<double>>
convex_manifold(const Placed<A>& a, const Placed<B>& b, double margin)
{
  const ConvexGap found = convex_gap(a, b);
  const auto& [normal, length] = found.gap;
  if (length > margin)
  {
    return std::nullopt;
  }
  const double size = std::min(extent(a.shape).outer, extent(b.shape).outer);
  Manifold<double> manifold{normal, -length, {}};
  add_common_patch(
      manifold, facing_patch<A>(a, normal, a.pose.center),
      facing_patch<B>(b, -normal, a.pose.center), margin, patch_merge * size);
  const Vector3<double> midway = found.at.on_a - found.at.point / 2;
  add_closest(manifold, {midway, -length, closest_feature}, closest_gain * size);
  alternate(manifold.points);
  for (ContactPoint<double>& point : manifold.points)
  {
    point.position += a.pose.center;
  }
  return manifold;
}

/// The manifold of a plane and a convex shape: the patch that faces the plane, and the lowest
/// point.
template <class Shape>
std::optional<Manifold<double>>
convex_manifold(const Plane<double>& a, const Placed<Shape>& b, double margin)
{
  const Vector3<double> lowest = b.pose.center + support_arm(b, -a.normal);
  const double depth = -signed_distance(a, lowest);
  if (depth < -margin)
  {
    return std::nullopt;
  }
  Manifold<double> manifold{a.normal, depth, {}};
  const PatchPolygon patch = facing_patch<Shape>(b, -a.normal, Vector3<double>::Zero());
  const auto at = [&](const Vector3<double>& point, std::uint32_t feature)
  {
    const double sunk = -signed_distance(a, point);
    return ContactPoint<double>{point + sunk / 2 * a.normal, sunk, feature};
  };
  for (int i = 0; i < patch.size; ++i)
  {
    const ContactPoint<double> point = at(patch[i].point, std::uint32_t(1 + patch[i].edge));
    if (point.depth >= -margin)
    {
      manifold.points.push_back(point);
    }
  }
  alternate(manifold.points);
  add_closest(manifold, at(lowest, closest_feature), closest_gain * extent(b.shape).outer);
  return manifold;
}
// [convex_manifold]

} // namespace cookbook
