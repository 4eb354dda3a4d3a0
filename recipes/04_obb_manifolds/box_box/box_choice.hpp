#pragma once

/// \file
/// \brief Which of the fifteen axes the manifold of two boxes is built on.

#include "04_obb_manifolds/box_box/box_overlaps.hpp"
#include "04_obb_manifolds/plain_box_box/box_preferences.hpp"

#include <algorithm>
#include <cmath>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

// [tolerances]
/// Lengths that decide between answers which are nearly equally right.
template <class Real>
struct Tolerances
{
  Real size;   ///< [m], all half extents together
  Real length; ///< [m], what rounding can make of equal lengths
  Real margin; ///< [m], a hundredth of the smaller box
};

/// The tolerances of two boxes.
template <class Real>
Tolerances<Real> tolerances_of(const Obb<Real>& a, const Obb<Real>& b)
{
  using Limits = std::numeric_limits<typename PartOf<Real>::type>;
  const auto sum = [](const Vector3<Real>& half) { return half[0] + half[1] + half[2]; };
  const Real of_a = sum(a.half_extents), of_b = sum(b.half_extents), size = of_a + of_b;
  return {size, size * Real(4 * Limits::epsilon()), contact_margin(of_a, of_b)};
}

/// Whether boxes of this size [m] have squares that fit into numbers, not too large, not too small.
template <class Real>
auto has_moderate_size(const Real& size)
{
  return (Real(0x1p-40f) < size) & (size < Real(0x1p40f));
}
// [tolerances]

// [least_face]
/// The face axis of least overlap.
template <class Real>
struct LeastFace
{
  Real depth;        ///< [m]
  Index<Real> index; ///< 0, 1, 2 for A's axes, 3, 4, 5 for B's
};

/// The least number of a row.
template <class Row>
typename Row::Number least_of(const Row& row)
{
  using std::min;
  return min(row[0], min(row[1], row[2]));
}

/// The first of the six least overlaps.
template <class Row>
LeastFace<typename Row::Number> least_face(const Row& face_a, const Row& face_b)
{
  const typename Row::Number depth = least_of(min(face_a, face_b));
  return {depth, first_set({face_a <= Row(depth), face_b <= Row(depth)})};
}
// [least_face]

// [edge_threshold]
/// The overlap [m] that an edge axis must stay under to be taken instead of a face; O19.
///
/// The face's less a tolerance: rounding alone must not decide. Where two faces are parallel, a
/// twentieth less, or half the margin: a face keeps all its points, and the next frame's.
template <class Row, class Real>
Real edge_threshold(
    const BoxesInRows<Row>& boxes, const Real& face_depth, const Tolerances<Real>& tolerances)
{
  using std::max;
  const Row largest = max(max(abs(boxes.rows[0]), abs(boxes.rows[1])), abs(boxes.rows[2]));
  const auto parallel = (Row(Real(parallel_cosine)) < largest).any();
  const Real preference = face_preference(face_depth, tolerances.margin);
  return max(face_depth - select(parallel, preference, tolerances.length), Real(0));
}
// [edge_threshold]

// [least_edge]
/// The edge axis of least overlap.
template <class Real>
struct LeastEdge
{
  Real squared_depth; ///< [m²]; `none` where no edge axis stays under the threshold
  Index<Real> index;  ///< 3 i + j for a_i × b_j

  static constexpr float none = std::numeric_limits<float>::max(); ///< [m²], for no axis

  auto found() const { return squared_depth < Real(none); } ///< whether there is one
};

/// The edge axes whose overlap stays under a threshold, and which of them has the least.
///
/// Squares are compared: s² < threshold² |L|² needs no root. Axes shorter than ε are left out.
template <class Row>
LeastEdge<typename Row::Number>
least_edge(const EdgeOverlaps<Row> (&edges)[3], const typename Row::Number& threshold)
{
  using Real = typename Row::Number;
  constexpr float epsilon = std::numeric_limits<float>::epsilon();
  const Real none(LeastEdge<Real>::none);
  Row square[3];
  typename Row::Mask under[3];
  for (int i = 0; i < 3; ++i)
  {
    square[i] = edges[i].overlap * edges[i].overlap;
    under[i] = (square[i] < Row(threshold * threshold) * edges[i].squared) &
               (Row(Real(epsilon * epsilon)) < edges[i].squared);
  }
  if (!any((under[0] | under[1] | under[2]).any()))
  {
    return {none, index<Real>(0)};
  }
  Row squared_depth[3];
  for (int i = 0; i < 3; ++i)
  {
    squared_depth[i] = select(under[i], square[i] / edges[i].squared, Row(none));
  }
  const Real least = least_of(min(min(squared_depth[0], squared_depth[1]), squared_depth[2]));
  return {
      least, first_set(
                 {squared_depth[0] <= Row(least), squared_depth[1] <= Row(least),
                  squared_depth[2] <= Row(least)})};
}
// [least_edge]

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
