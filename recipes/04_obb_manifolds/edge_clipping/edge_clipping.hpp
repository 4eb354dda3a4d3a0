#pragma once

/// \file
/// \brief The manifold of two boxes from the points where edges of one pass faces of the other.

#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "04_obb_manifolds/edge_clipping/edge_face_points.hpp"
#include "04_obb_manifolds/separating_axes/separating_axes.hpp"

#include <algorithm>
#include <cmath>

namespace cookbook
{

// [contained_point]
/// The point of a box farthest along a direction; the middle of all such where it is a face.
template <class Real>
Vector3<Real> farthest_middle(const Vector3<Real>& direction, const Vector3<Real>& half_extents)
{
  const Real level = Real(32) * std::numeric_limits<Real>::epsilon();
  const auto sign = [&](Real x) { return Real(side_of_face(x, level)); };
  return half_extents.cwiseProduct(direction.unaryExpr(sign));
}

/// A point for boxes no edge of which passes a face: the deepest of the one inside the other.
template <class Real>
Vector3<Real> contained_point(const RelativeBoxes<Real>& boxes, const Vector3<Real>& normal)
{
  const Real tolerance = rounding_tolerance(boxes);
  const Vector3<Real> back = boxes.rotation.transpose() * -normal;
  const Vector3<Real> of_b = boxes.offset + boxes.rotation * farthest_middle(back, boxes.half_b);
  const bool b_in_a = (of_b.cwiseAbs() - boxes.half_a).maxCoeff() <= tolerance;
  return b_in_a ? of_b : farthest_middle(normal, boxes.half_a);
}
// [contained_point]

// [crossing_points]
/// The most points that edge_clipping() finds: 24 edges that pass two faces each.
inline constexpr std::size_t most_crossings = 48;

/// Points closer together than this part [1] of the boxes' half extents are one point.
template <class Real>
Real same_point()
{
  return std::sqrt(std::numeric_limits<Real>::epsilon());
}

/// Contact points on a plane: each point that is given to it, moved there along the normal, once.
template <class Real>
struct ContactsOnPlane
{
  Plane<Real> plane;                          ///< in A's frame
  Real depth;                                 ///< [m], of every point
  Real same;                                  ///< [m], points closer than this are one
  ContactPoints<Real, most_crossings> points; ///< in A's frame

  /// Adds a point unless it is there already.
  void add(const Vector3<Real>& point, std::uint32_t feature)
  {
    const Vector3<Real> moved = point + (plane.distance - plane.normal.dot(point)) * plane.normal;
    const auto is_same = [&](const ContactPoint<Real>& other)
    { return (other.position - moved).norm() <= same; };
    if (std::none_of(points.begin(), points.end(), is_same))
    {
      points.push_back({moved, depth, feature});
    }
  }
};

/// No contacts yet, on the plane midway between A's farthest point along the normal and B's.
template <class Real>
ContactsOnPlane<Real>
contacts_on_middle_plane(const RelativeBoxes<Real>& boxes, const Vector3<Real>& normal, Real depth)
{
  const Real middle = normal.cwiseAbs().dot(boxes.half_a) - depth / Real(2);
  const Real same = same_point<Real>() * (boxes.half_a.sum() + boxes.half_b.sum());
  return {{normal, middle}, depth, same, {}};
}

/// Adds the points where A's edges pass B's faces, then those where B's edges pass A's.
template <class Real>
void add_crossings(const RelativeBoxes<Real>& boxes, ContactsOnPlane<Real>& contacts)
{
  const Matrix3<Real>& c = boxes.rotation;
  const Real tolerance = rounding_tolerance(boxes);
  each_crossing<Real>(
      {c.transpose(), c.transpose() * -boxes.offset, boxes.half_a, boxes.half_b}, tolerance,
      [&](const Vector3<Real>& point, std::uint32_t number)
      { contacts.add(boxes.offset + c * point, 1 + number); });
  each_crossing<Real>(
      {c, boxes.offset, boxes.half_b, boxes.half_a}, tolerance,
      [&](const Vector3<Real>& point, std::uint32_t number)
      { contacts.add(point, 1 + edge_face_pairs + number); });
}
// [crossing_points]

// [edge_clipping]
/// The manifold of two boxes: the least overlap, and a point for each edge that passes a face; O16.
///
/// Each crossing is moved along the normal to the plane midway between A's farthest point and
/// B's, and has the depth of the whole manifold, the only one that this method knows. A point's
/// feature is 1 + 6 edge + face for A's edges, 73 + 6 edge + face for B's, edges numbered 0 … 11,
/// faces 0 … 5. A box inside the other has no such edge: its deepest point is the answer, with
/// feature 0. What separating_axes() says of ties and touching holds here too.
template <class Real>
std::optional<Manifold<Real, most_crossings>> edge_clipping(const Obb<Real>& a, const Obb<Real>& b)
{
  const std::optional<LeastOverlap<Real>> least = separating_axes(a, b);
  if (!least)
  {
    return std::nullopt;
  }
  const RelativeBoxes<Real> boxes = relative_boxes(a, b);
  const Vector3<Real> normal = a.axes.transpose() * least->normal;
  ContactsOnPlane<Real> contacts = contacts_on_middle_plane(boxes, normal, least->depth);
  add_crossings(boxes, contacts);
  if (contacts.points.empty())
  {
    contacts.add(contained_point(boxes, normal), 0);
  }
  for (ContactPoint<Real>& point : contacts.points)
  {
    point.position = a.center + a.axes * point.position;
  }
  return Manifold<Real, most_crossings>{least->normal, least->depth, contacts.points};
}
// [edge_clipping]

} // namespace cookbook
