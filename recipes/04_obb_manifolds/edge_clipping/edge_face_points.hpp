#pragma once

/// \file
/// \brief The points where the edges of one box pass the faces of another.

#include "04_obb_manifolds/separating_axes/side_of_face.hpp"
#include "common/math/vector.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace cookbook
{

// [clip_edge]
/// The piece of an edge that lies in a box, and the faces that cut it off; O11.
template <class Real>
struct ClippedEdge
{
  Real enter = Real(0); ///< [1], 0 … 1 from the edge's start to its end
  Real leave = Real(1); ///< [1], 0 … 1
  int enter_face = -1; ///< 0 … 5 for +x, −x, +y, −y, +z, −z; −1 where the edge starts inside
  int leave_face = -1; ///< the same for the other end
};

/// Cuts an edge at the six faces of the box [−h, h]; nothing where no piece lies in it.
template <class Real>
std::optional<ClippedEdge<Real>> clip_edge(
    const Vector3<Real>& start, const Vector3<Real>& end, const Vector3<Real>& half_extents,
    Real tolerance)
{
  ClippedEdge<Real> piece;
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2;
    const Real sign = face % 2 == 0 ? Real(1) : Real(-1);
    const Real d_start = sign * start[axis] - half_extents[axis];
    const Real d_end = sign * end[axis] - half_extents[axis];
    const int side_start = side_of_face(d_start, tolerance),
              side_end = side_of_face(d_end, tolerance);
    if (side_start > 0 && side_end > 0)
    {
      return std::nullopt;
    }
    if (side_start == side_end)
    {
      continue;
    }
    const Real cut = std::clamp(d_start / (d_start - d_end), Real(0), Real(1));
    if (side_start > side_end && cut >= piece.enter)
    {
      piece.enter = cut;
      piece.enter_face = face;
    }
    if (side_start < side_end && cut <= piece.leave)
    {
      piece.leave = cut;
      piece.leave_face = face;
    }
  }
  const bool empty = (piece.enter - piece.leave) * (end - start).norm() > tolerance;
  return empty ? std::nullopt : std::optional(piece);
}
// [clip_edge]

// [each_crossing]
/// One box as the other sees it: the box with the edges in the frame of the box with the faces.
template <class Real>
struct EdgesAndFaces
{
  Matrix3<Real> axes;       ///< [1], columns are the edges' directions
  Vector3<Real> center;     ///< [m], of the box with the edges
  Vector3<Real> half_edges; ///< [m], half extents of the box with the edges
  Vector3<Real> half_faces; ///< [m], half extents of the box with the faces
};

/// The number of pairs of an edge of one box and a face of the other.
inline constexpr std::uint32_t edge_face_pairs = 12 * 6;

/// Calls `found(point, 6 edge + face)` where an edge of one box passes a face of the other.
template <class Real, class Found>
void each_crossing(const EdgesAndFaces<Real>& boxes, Real tolerance, const Found& found)
{
  for (int edge = 0; edge < 12; ++edge)
  {
    const int k = edge / 4, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
    const Real side_1 = edge % 2 == 0 ? Real(-1) : Real(1);
    const Real side_2 = edge % 4 < 2 ? Real(-1) : Real(1);
    const Vector3<Real> along = boxes.half_edges[k] * boxes.axes.col(k);
    const Vector3<Real> middle = boxes.center + side_1 * boxes.half_edges[k1] * boxes.axes.col(k1) +
                                 side_2 * boxes.half_edges[k2] * boxes.axes.col(k2);
    const Vector3<Real> start = middle - along, end = middle + along;
    const auto piece = clip_edge<Real>(start, end, boxes.half_faces, tolerance);
    const auto report = [&](int face, Real cut)
    { found(start + cut * (end - start), static_cast<std::uint32_t>(6 * edge + face)); };
    if (piece && piece->enter_face >= 0)
    {
      report(piece->enter_face, piece->enter);
    }
    if (piece && piece->leave_face >= 0)
    {
      report(piece->leave_face, piece->leave);
    }
  }
}
// [each_crossing]

} // namespace cookbook
