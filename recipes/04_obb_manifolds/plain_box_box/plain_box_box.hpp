#pragma once

/// \file
/// \brief The manifold of two oriented boxes, plain: separating axes, then clipping.

#include "02_primitives/shape_bounds/box_radius.hpp"
#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "04_obb_manifolds/plain_box_box/box_preferences.hpp"

namespace cookbook
{

// [best_axis]
/// The axis that a manifold is built on.
template <class Real>
struct BestAxis
{
  Vector3<Real> normal; ///< [1], unit, from A to B
  Real depth;           ///< [m], by how much the projections overlap
  int index;            ///< 0 … 2: a_i, 3 … 5: b_j, 6 … 14: a_i × b_j
};

/// The separating axis test (SAT): the axis of least overlap, faces preferred; O1, O2, O7, O19.
template <class Real>
std::optional<BestAxis<Real>>
best_axis(const Obb<Real>& a, const Obb<Real>& b, Real margin, Real tolerance)
{
  const Vector3<Real> t = b.center - a.center;
  BestAxis<Real> face{t, std::numeric_limits<Real>::max(), 0}, edge = face;
  for (int i = 0; i < 15; ++i)
  {
    const Vector3<Real> a_i = a.axes.col(i < 6 ? i % 3 : i / 3 - 2), b_j = b.axes.col(i % 3);
    const Vector3<Real> axis = i < 3 ? a_i : i < 6 ? b_j : a_i.cross(b_j);
    if (axis.norm() > Real(1e-6)) // else two parallel edges, which span no new direction
    {
      const Vector3<Real> n = axis / (t.dot(axis) < 0 ? -axis.norm() : axis.norm());
      const Real overlap = box_radius(a, n) + box_radius(b, n) - t.dot(n);
      if (!(overlap >= 0))
      {
        return std::nullopt; // a separating axis, or no number
      }
      BestAxis<Real>& best = i < 6 ? face : edge;
      best = overlap < best.depth ? BestAxis<Real>{n, overlap, i} : best;
    }
  }
  const Matrix3<Real> cosines = a.axes.transpose() * b.axes;
  const bool parallel = cosines.cwiseAbs().maxCoeff() > parallel_cosine;
  const Real preference = parallel ? face_preference(face.depth, margin) : tolerance;
  return edge.depth < face.depth - preference ? edge : face;
}
// [best_axis]

// [clipped]
/// The part of a polygon where n · p ≤ o: Sutherland–Hodgman clipping; O11. Features number sides.
template <class Real>
ContactPoints<Real, 12> clipped(
    const ContactPoints<Real, 12>& polygon, const Vector3<Real>& n, Real o, unsigned side,
    Real tolerance)
{
  const auto outside = [&](const ContactPoint<Real>& corner)
  {
    const Real g = n.dot(corner.position) - o;
    return std::abs(g) <= tolerance ? Real(0) : g; // flush sides stay as they are
  };
  ContactPoints<Real, 12> inside;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const ContactPoint<Real>&from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const Real g_0 = outside(from), g_1 = outside(to);
    const unsigned next = g_1 > 0 ? side : from.feature;
    if (g_0 <= 0)
    {
      inside.push_back({from.position, 0, g_0 < 0 ? from.feature : next});
    }
    if (g_0 * g_1 < 0)
    {
      inside.push_back({point_at_plane(from.position, to.position, g_0, g_1), 0, next});
    }
  }
  return inside;
}
// [clipped]

// [face_contact]
/// The corners of the incident face, of `other`, over the reference face of `box`, whose outward
/// normal n is plus or minus its axis k; O10, O12, O20.
template <class Real>
ContactPoints<Real, 8> face_contact(
    const Obb<Real>& box, const Obb<Real>& other, int k, const Vector3<Real>& n, Real kept,
    Real tolerance)
{
  const Vector3<Real> seen = other.axes.transpose() * n;
  int m = 0;
  seen.cwiseAbs().maxCoeff(&m);
  const Matrix3<Real> half = other.axes * other.half_extents.asDiagonal();
  const Vector3<Real> x = half.col((m + 1) % 3), y = half.col((m + 2) % 3);
  const Vector3<Real> middle = other.center - half.col(m) * Real(seen[m] < 0 ? -1 : 1);
  ContactPoints<Real, 12> polygon;
  polygon.push_back({middle - x - y, 0, 0});
  polygon.push_back({middle + x - y, 0, 1});
  polygon.push_back({middle + x + y, 0, 2});
  polygon.push_back({middle - x + y, 0, 3});
  for (unsigned side = 4; side < 8; ++side)
  {
    const int u = (k + (side < 6 ? 1 : 2)) % 3;
    const Vector3<Real> out = box.axes.col(u) * Real(side % 2 == 0 ? 1 : -1);
    polygon = clipped(polygon, out, out.dot(box.center) + box.half_extents[u], side, tolerance);
  }
  ContactPoints<Real, 8> points;
  for (std::size_t i = 0; i < polygon.size() && points.size() < 8; ++i)
  {
    const ContactPoint<Real>&before = polygon[i > 0 ? i - 1 : polygon.size() - 1], &at = polygon[i];
    const Real d = box.half_extents[k] - n.dot(at.position - box.center);
    if (d >= -kept)
    {
      points.push_back({at.position + n * (d / 2), d, 8 * before.feature + at.feature});
    }
  }
  return points;
}
// [face_contact]

// [edge_contact]
/// The middle of the edge along axis k that lies farthest along a direction; feature: which of
/// four.
template <class Real>
ContactPoint<Real> support_edge(const Obb<Real>& box, int k, const Vector3<Real>& direction)
{
  Vector3<Real> arm = (box.axes.transpose() * direction).cwiseSign().cwiseProduct(box.half_extents);
  arm[k] = 0;
  const unsigned number = (arm[(k + 1) % 3] > 0 ? 1 : 0) + (arm[(k + 2) % 3] > 0 ? 2 : 0);
  return {box.center + box.axes * arm, 0, number};
}

/// The point midway between an edge of A along axis i and one of B along axis j; O13.
template <class Real>
ContactPoints<Real, 8> edge_contact(
    const Obb<Real>& a, const Obb<Real>& b, int i, int j, const Vector3<Real>& n, Real depth)
{
  const ContactPoint<Real> edge_a = support_edge(a, i, n), edge_b = support_edge<Real>(b, j, -n);
  const Vector3<Real> e_a = a.axes.col(i), e_b = b.axes.col(j);
  const Vector3<Real> q = edge_b.position - edge_a.position;
  const Vector3<Real> on_a = edge_a.position + closest_on_line(q, e_a, e_b) * e_a;
  const Vector3<Real> on_b = edge_b.position + closest_on_line<Real>(-q, e_b, e_a) * e_b;
  return ContactPoint<Real>{(on_a + on_b) / 2, depth, 4 * edge_a.feature + edge_b.feature};
}
// [edge_contact]

// [plain_box_box]
/// The manifold of two oriented boxes: nothing where they are apart, depth 0 where they touch.
///
/// For a room: a millimetre to a kilometre. Half extents are greater than zero, axes orthonormal. A
/// point's feature tells the axis, and which sides of the two faces meet in the point.
template <class Real>
std::optional<Manifold<Real>> plain_box_box(const Obb<Real>& world_a, const Obb<Real>& world_b)
{
  const Obb<Real> a{Vector3<Real>::Zero(), world_a.axes, world_a.half_extents}; // seen from A
  const Obb<Real> b{world_b.center - world_a.center, world_b.axes, world_b.half_extents};
  const Real sum_a = a.half_extents.sum(), sum_b = b.half_extents.sum();
  const Real margin = contact_margin(sum_a, sum_b);
  const Real tolerance = 4 * std::numeric_limits<Real>::epsilon() * (sum_a + sum_b);
  const std::optional<BestAxis<Real>> best = best_axis(a, b, margin, tolerance);
  if (!best)
  {
    return std::nullopt;
  }
  const auto& [n, depth, i] = *best;
  const Real kept = kept_separation(depth, margin, tolerance);
  Manifold<Real> manifold{n, depth, {}};
  manifold.points = i < 3   ? face_contact(a, b, i, n, kept, tolerance)
                    : i < 6 ? face_contact<Real>(b, a, i - 3, -n, kept, tolerance)
                            : edge_contact(a, b, i / 3 - 2, i % 3, n, depth);
  for (ContactPoint<Real>& point : manifold.points)
  {
    point.position += world_a.center;
    point.feature += 64 * static_cast<unsigned>(i);
  }
  return manifold;
}
// [plain_box_box]

} // namespace cookbook
