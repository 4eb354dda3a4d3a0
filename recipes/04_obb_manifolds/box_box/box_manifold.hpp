#pragma once

/// \file
/// \brief The manifold of two boxes on an axis that is already chosen.

#include "02_primitives/closest_point_box/closest_point_box.hpp"
#include "03_sphere_manifolds/manifold/build.hpp"
#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "04_obb_manifolds/box_box/box_choice.hpp"
#include "04_obb_manifolds/box_box/box_contacts.hpp"

#include <cstdint>
#include <optional>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

/// The three numbers of a row as a vector.
template <class Row>
Vector3<typename Row::Number> vector_of(const Row& row)
{
  return {row[0], row[1], row[2]};
}

// [edge_manifold]
/// The manifold on the axis of two edges, 3 i + j for a_i × b_j, along which the boxes overlap by
/// `depth` [m]: one point.
template <class Row, class Real>
std::optional<Manifold<Real>>
edge_manifold(const Obb<Real>& a, const BoxesInRows<Row>& boxes, int edges, const Real& depth)
{
  const auto built = [&]
  {
    const int i = edges / 3, j = edges % 3;
    const EdgeContact<Row> contact = edge_contact(a, boxes, i, j);
    Manifold<Real> manifold;
    manifold.normal = vector_of(contact.normal);
    manifold.depth = depth;
    manifold.points.push_back(
        {vector_of(contact.position), depth, static_cast<std::uint32_t>(64 * (6 + edges))});
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

// [touching_corners]
/// Adds the one or two ends of what boxes have in common that touch along edges or at a corner: the
/// corners of each that lie in the other within a few tolerances [m], none of them twice. Features
/// only count them.
template <class Real>
[[gnu::noinline]] void add_touching_corners(
    Manifold<Real>& manifold, const Obb<Real>& box, const Obb<Real>& other, const Real& tolerance,
    std::uint32_t feature)
{
  const Real several_tolerances = 8 * tolerance;
  Vector3<Real> first = Vector3<Real>::Zero();
  for (int i = 0; i < 16 && manifold.points.size() < 2; ++i)
  {
    const Obb<Real>&from = i < 8 ? other : box, &to = i < 8 ? box : other;
    const Vector3<Real> signs(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    const Vector3<Real> corner = from.axes * from.half_extents.cwiseProduct(signs);
    const Vector3<Real> place = (from.center - box.center) + corner;
    const Vector3<Real> seen = to.axes.transpose() * (place - (to.center - box.center));
    const bool is_common = (seen.cwiseAbs() - to.half_extents).maxCoeff() <= several_tolerances;
    const bool is_new = manifold.points.empty() || (place - first).norm() > several_tolerances;
    if (is_common && is_new)
    {
      const auto number = static_cast<std::uint32_t>(manifold.points.size());
      manifold.points.push_back({box.center + place, manifold.depth, feature + number});
      first = place;
    }
  }
}
// [touching_corners]

// [face_manifold]
/// The manifold on the axis of a face: the corners of the polygon in which two faces overlap, with
/// gaps up to `widest_separation` [m]; lengths within `tolerance` [m] are equal.
template <class Row, class Real>
std::optional<Manifold<Real>> face_manifold(
    const Obb<Real>& a, const Obb<Real>& b, const BoxesInRows<Row>& boxes,
    const LeastFace<Real>& face, const Real& widest_separation, const Real& tolerance)
{
  const bool of_a = face.index < 3;
  const Obb<Real>& box = of_a ? a : b;
  const Obb<Real>& other = of_a ? b : a;
  const auto built = [&]
  {
    const FaceContact<Row> contact = face_contact(
        box, other, of_a ? boxes.rows : boxes.columns, of_a ? boxes.offset_a : boxes.offset_b,
        of_a ? face.index : face.index - 3, widest_separation, tolerance);
    Manifold<Real> manifold;
    manifold.normal = contact.normal * (of_a ? Real(1) : Real(-1));
    manifold.depth = face.depth;
    const auto feature = static_cast<std::uint32_t>(64 * face.index + 8 * contact.incident);
    for (std::uint32_t part = 0; part < 2; ++part)
    {
      typename Row::Four points[] = {
          contact.position[part][0], contact.position[part][1], contact.position[part][2],
          contact.depth[part]};
      transpose(points);
      const std::uint32_t kept = contact.kept[part].bits();
      for (std::uint32_t i = 0; i < 4; ++i)
      {
        const typename Row::Four& from = points[i];
        manifold.points.emplace_back_if(
            kept >> i & 1,
            [&](ContactPoint<Real>& point) {
              point = {{from[0], from[1], from[2]}, from[3], feature + 4 * part + i};
            });
      }
    }
    if (manifold.points.empty() && face.depth <= tolerance)
    {
      add_touching_corners(manifold, box, other, tolerance, feature);
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

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
