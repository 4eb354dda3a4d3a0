#pragma once

/// \file
/// \brief The manifold of two oriented boxes: the chapter's answer.

#include "02_primitives/closest_point_box.hpp"
#include "03_sphere_manifolds/any_size.hpp"
#include "03_sphere_manifolds/manifold.hpp"
#include "04_obb_manifolds/box_choice.hpp"
#include "04_obb_manifolds/box_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

/// The three numbers of a group as a vector.
template <class Real>
Vector3<Real> vector_of(const Group<Real, 3>& group)
{
  return {group[0], group[1], group[2]};
}

// [edge_manifold]
/// The manifold on the axis of two edges, 3 i + j for a_i × b_j, along which the boxes overlap by
/// `depth` [m]: one point.
template <class Real>
std::optional<Manifold<Real>>
edge_manifold(const Obb<Real>& a, const BoxesInRows<Real>& boxes, int edges, const Real& depth)
{
  const auto built = [&]
  {
    const int i = edges / 3, j = edges % 3;
    const EdgeContact<Real> contact = edge_contact<Real>(a, boxes, i, j);
    Manifold<Real> manifold;
    manifold.normal = vector_of<Real>(contact.normal);
    manifold.depth = depth;
    manifold.points.push_back(
        {vector_of<Real>(contact.position), depth, static_cast<std::uint32_t>(64 * (6 + edges))});
    return manifold;
  };
  return std::optional<Manifold<Real>>(std::in_place, Build(built));
}
// [edge_manifold]

// [deepest_point]
/// The corner of `other` that reaches deepest through a box's face, halfway back to it: for faces
/// whose overlap rounding has left without a corner.
template <class Real>
[[gnu::noinline]] ContactPoint<Real> deepest_point(
    const Obb<Real>& box, const Obb<Real>& other, const Vector3<Real>& normal, const Real& depth,
    std::uint32_t feature)
{
  const Vector3<Real> along = other.axes.transpose() * normal;
  const Vector3<Real> corner = along.binaryExpr(
      other.half_extents, [](Real way, Real half) { return way < 0 ? half : -half; });
  const Vector3<Real> between = other.center + (other.axes * corner + normal * (depth / Real(2)));
  return {closest_point(box, between), depth, feature};
}
// [deepest_point]

// [face_manifold]
/// Writes a contact point from its x, y, z and depth in one group.
template <class Real>
void write_point(ContactPoint<Real>& point, const Group<Real, 4>& numbers, std::uint32_t feature)
{
  static_assert(offsetof(ContactPoint<Real>, depth) == 3 * sizeof(Real));
  std::memcpy(static_cast<void*>(&point), &numbers, sizeof(numbers));
  point.feature = feature;
}

/// The manifold on the axis of a face: the corners of the polygon in which two faces overlap, with
/// gaps up to `widest_gap` [m]; a hair [m] decides no corner.
template <class Real>
std::optional<Manifold<Real>> face_manifold(
    const Obb<Real>& a, const Obb<Real>& b, const BoxesInRows<Real>& boxes,
    const LeastFace<Real>& face, const Real& widest_gap, const Real& hair)
{
  const bool of_a = face.index < 3;
  const Obb<Real>& box = of_a ? a : b;
  const Obb<Real>& other = of_a ? b : a;
  const auto built = [&]
  {
    const FaceContact<Real> contact = face_contact<Real>(
        box, other, of_a ? boxes.rows : boxes.columns, of_a ? boxes.offset_a : boxes.offset_b,
        of_a ? face.index : face.index - 3, widest_gap, hair);
    Manifold<Real> manifold;
    manifold.normal = contact.normal * (of_a ? Real(1) : Real(-1));
    manifold.depth = face.depth;
    const auto feature = static_cast<std::uint32_t>(64 * face.index + 8 * contact.incident);
    for (std::uint32_t part = 0; part < 2; ++part)
    {
      Group<Real, 4> rows[] = {
          contact.position[part][0], contact.position[part][1], contact.position[part][2],
          contact.depth[part]};
      transpose(rows[0], rows[1], rows[2], rows[3]);
      const std::uint32_t kept = bits_of(contact.kept[part]);
      for (std::uint32_t i = 0; i < 4; ++i)
      {
        manifold.points.emplace_back_if(
            kept >> i & 1, [&](ContactPoint<Real>& point)
            { write_point(point, rows[i], feature + 4 * part + i); });
      }
    }
    if (manifold.points.empty())
    {
      manifold.points.push_back(deepest_point(box, other, contact.normal, face.depth, feature));
    }
    return manifold;
  };
  return std::optional<Manifold<Real>>(std::in_place, Build(built));
}
// [face_manifold]

// [box_choice]
/// What the manifold of two boxes is built on: the edges, if they were found, or the face.
template <class Real>
struct BoxChoice
{
  LeastFace<Real> face;
  LeastEdge<Real> edge;
};

/// The choice for two boxes whose squares fit; nothing where they are apart.
template <class Real>
std::optional<BoxChoice<Real>>
box_choice(const BoxesInRows<Real>& boxes, const Tolerances<Real>& tolerances)
{
  using Row = Group<Real, 3>;
  const Row face_a = face_overlaps(boxes.half_a, boxes.columns, boxes.half_b, boxes.offset_a);
  const Row face_b = face_overlaps(boxes.half_b, boxes.rows, boxes.half_a, boxes.offset_b);
  if (!all((Row(0) <= face_a) & (Row(0) <= face_b))) // boxes too far apart for numbers are NaN
  {
    return std::nullopt;
  }
  const EdgeOverlaps<Real> edges[] = {
      edge_overlaps(boxes, 0), edge_overlaps(boxes, 1), edge_overlaps(boxes, 2)};
  if (any(min(min(edges[0].overlap, edges[1].overlap), edges[2].overlap) < Row(0)))
  {
    return std::nullopt;
  }
  const LeastFace<Real> face = least_face<Real>(face_a, face_b);
  return BoxChoice<Real>{face, least_edge(edges, edge_bar(boxes, face.depth, tolerances))};
}
// [box_choice]

// [box_manifold]
/// The manifold of two boxes whose squares fit.
template <class Real>
std::optional<Manifold<Real>> box_manifold(
    const Obb<Real>& a, const Obb<Real>& b, const BoxesInRows<Real>& boxes,
    const Tolerances<Real>& tolerances)
{
  const std::optional<BoxChoice<Real>> choice = box_choice(boxes, tolerances);
  if (!choice)
  {
    return std::nullopt;
  }
  const auto& [face, edge] = *choice;
  return edge.found()
             ? edge_manifold<Real>(a, boxes, edge.index, std::sqrt(edge.squared_depth))
             : face_manifold(a, b, boxes, face, kept_gap(face, tolerances), tolerances.hair);
}
// [box_manifold]

// [at_unit_size]
/// The manifold of two boxes of any finite size: seen from A, and made of size one by a power of
/// two, which is exact.
template <class Real>
[[gnu::noinline]] std::optional<Manifold<Real>>
box_box_at_unit_size(const Obb<Real>& a, const Obb<Real>& b)
{
  const Real size = a.half_extents.cwiseMax(b.half_extents).maxCoeff();
  const Vector3<Real> quarter = b.center / Real(4) - a.center / Real(4);
  if (!(quarter.cwiseAbs().maxCoeff() <= size))
  {
    return std::nullopt;
  }
  const int exponent = size > 0 ? std::ilogb(size) : 0;
  const Obb<Real> near{{0, 0, 0}, a.axes, scaled(a.half_extents, -exponent)};
  const Obb<Real> other{scaled(quarter, 2 - exponent), b.axes, scaled(b.half_extents, -exponent)};
  const auto found =
      box_manifold(near, other, boxes_in_rows(near, other), tolerances_of(near, other));
  return found ? translated(std::optional(scaled(*found, exponent)), a.center) : std::nullopt;
}
// [at_unit_size]

// [box_box]
/// The manifold of two oriented boxes; nothing where they are apart.
///
/// Boxes that only touch have a manifold of depth zero. A face meets a face in all corners of their
/// overlap, each midway between the two surfaces with a depth of its own; corners with a gap are
/// kept while it is less than the depth and than a hundredth of the smaller box. Edges meet in one
/// point. A point's feature tells the axis by 64s, see axis_of_feature().
/// Half extents are zero or more, axes orthonormal, all numbers finite. O2–O4, O9, O10–O14.
template <class Real>
[[gnu::flatten]] std::optional<Manifold<Real>> box_box(const Obb<Real>& a, const Obb<Real>& b)
{
  const BoxesInRows<Real> boxes = boxes_in_rows(a, b);
  const Tolerances<Real> tolerances = tolerances_of(a, b);
  if (!has_moderate_size(tolerances.size))
  {
    return box_box_at_unit_size(a, b);
  }
  return box_manifold(a, b, boxes, tolerances);
}
// [box_box]

// [box_axis]
/// The axis, 0 … 14, on which box_box() builds its manifold, and the overlap [m] along it; nothing
/// where the boxes are apart.
template <class Real>
[[gnu::flatten]] std::optional<std::pair<int, Real>>
box_axis(const Obb<Real>& a, const Obb<Real>& b)
{
  const BoxesInRows<Real> boxes = boxes_in_rows(a, b);
  const Tolerances<Real> tolerances = tolerances_of(a, b);
  if (!has_moderate_size(tolerances.size))
  {
    const std::optional<Manifold<Real>> found = box_box_at_unit_size(a, b);
    return found ? std::optional(
                       std::pair(static_cast<int>(found->points[0].feature / 64), found->depth))
                 : std::nullopt;
  }
  const std::optional<BoxChoice<Real>> choice = box_choice(boxes, tolerances);
  if (!choice)
  {
    return std::nullopt;
  }
  const auto& [face, edge] = *choice;
  return edge.found() ? std::pair(6 + edge.index, Real(std::sqrt(edge.squared_depth)))
                      : std::pair(face.index, face.depth);
}
// [box_axis]

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
