#pragma once

/// \file
/// \brief Two boxes that lean on each other, edge along edge: a normal between their faces.

#include "02_primitives/shapes/shapes.hpp"
#include "03_sphere_manifolds/manifold/manifold.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace cookbook
{

// [leaning_edges]
/// Two edges that lie along each other, one on a face of A, the other on a face of B.
struct LeaningEdges
{
  Vector3<double> along;    ///< [1], unit, along both edges, world
  Vector3<double> normal_a; ///< [1], unit, of A's face, outwards, world
  Vector3<double> normal_b; ///< [1], unit, of B's face, inwards, world
  Vector3<double> edge_a;   ///< [m], on the line of A's edge, level with A's centre, world
  Vector3<double> edge_b;   ///< [m], the same of B's
  double on_a;              ///< [m], how far B's edge lies on A's face
  double on_b;              ///< [m], how far A's edge lies on B's face
  double begin, end;        ///< [m], along both edges from A's centre, where they overlap
};

/// The sine of the least angle between two faces that touch along an edge; below it they touch all
/// over.
inline constexpr double min_leaning_sine = 0.02;

/// The axis of a box that lies along a direction, to within a length [m] over another [m]; −1 if
/// none does.
inline int
axis_along(const Obb<double>& box, const Vector3<double>& direction, double length, double within)
{
  int axis = 0;
  const double cosine = (box.axes.transpose() * direction).cwiseAbs().maxCoeff(&axis);
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return sine * (length + box.half_extents[axis]) <= within ? axis : -1;
}

/// The edge along A's axis i, at its face along axis k with this normal, and B's edge along its
/// axis j.
inline LeaningEdges edges_along(
    const Obb<double>& a, const Obb<double>& b, const Vector3<double>& normal, int i, int k, int j)
{
  const auto facing = [](const Vector3<double>& axis, const Vector3<double>& way) -> Vector3<double>
  { return std::copysign(1.0, axis.dot(way)) * axis; };
  const int p = (j + 1) % 3, q = (j + 2) % 3, side = 3 - i - k;
  const Vector3<double> along = a.axes.col(i), offset = b.center - a.center;
  const Vector3<double> in_p = facing(b.axes.col(p), normal), in_q = facing(b.axes.col(q), normal);
  const double middle = offset.dot(along);
  const Vector3<double> edge_b =
      b.center - b.half_extents[p] * in_p - b.half_extents[q] * in_q - middle * along;
  const Vector3<double> out = facing(a.axes.col(side), edge_b - a.center);
  const Vector3<double> edge_a = a.center + a.half_extents[k] * normal + a.half_extents[side] * out;
  const bool by_p = in_p.dot(out) > in_q.dot(out);
  const Vector3<double> between = edge_a - edge_b;
  return {
      along,
      normal,
      by_p ? in_p : in_q,
      edge_a,
      edge_b,
      between.dot(out),
      between.dot(by_p ? in_q : in_p),
      std::max(-a.half_extents[i], middle - b.half_extents[j]),
      std::min(a.half_extents[i], middle + b.half_extents[j])};
}

/// The edges with which two boxes lean on each other at A's face along its axis k: those that are
/// parallel to within a length [m], and less than that on each other's faces. Nothing where they
/// touch in another way.
inline std::optional<LeaningEdges>
leaning_edges(const Obb<double>& a, const Obb<double>& b, int k, double width)
{
  const Vector3<double> axis = a.axes.col(k);
  const Vector3<double> slant = (b.axes.transpose() * axis).cwiseAbs();
  if (slant.sum() - slant.maxCoeff() - slant.minCoeff() < min_leaning_sine)
  {
    return std::nullopt; // face on face
  }
  const Vector3<double> normal = std::copysign(1.0, axis.dot(b.center - a.center)) * axis;
  for (const int i : {(k + 1) % 3, (k + 2) % 3})
  {
    const int j = axis_along(b, a.axes.col(i), a.half_extents[i], width);
    if (j >= 0)
    {
      const LeaningEdges edges = edges_along(a, b, normal, i, k, j);
      const bool meet = std::abs(edges.on_a - edges.on_b) < width && edges.begin < edges.end;
      return meet ? std::optional(edges) : std::nullopt;
    }
  }
  return std::nullopt;
}

/// The manifold of two boxes that lean on each other at A's face along its axis k, with a gap of no
/// more than a margin [m]; nothing where they touch in another way.
///
/// Of all normals between those of the two faces each parts the boxes. Where neither edge lies on
/// the other's face, it is the one in the middle, as symmetry asks; an edge that lies by a width
/// [m] on a face has that face's normal.
inline std::optional<Manifold<double>>
leaning_manifold(const Obb<double>& a, const Obb<double>& b, int k, double width, double margin)
{
  const std::optional<LeaningEdges> edges = leaning_edges(a, b, k, width);
  if (!edges)
  {
    return std::nullopt;
  }
  const double of_a = (1 + (edges->on_a - edges->on_b) / width) / 2;
  const Vector3<double> normal =
      (of_a * edges->normal_a + (1 - of_a) * edges->normal_b).normalized();
  const double depth = normal.dot(edges->edge_a - edges->edge_b);
  if (depth < -margin)
  {
    return std::nullopt;
  }
  Manifold<double> manifold{normal, depth, {}};
  const Vector3<double> middle = (edges->edge_a + edges->edge_b) / 2;
  for (const double place : {edges->begin, edges->end})
  {
    manifold.points.push_back({middle + place * edges->along, depth, 0});
  }
  return manifold;
}
// [leaning_edges]

} // namespace cookbook
