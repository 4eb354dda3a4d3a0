#pragma once

/// \file
/// \brief The face or the edge of a box that lies farthest along a direction.

#include "02_primitives/shapes/shapes.hpp"

#include <array>

namespace cookbook
{

// [box_with_numbers]
/// The number of edges of a box.
inline constexpr int box_edges = 12;

/// A box, and the number of the first of its edges: A's are 0 … 11, B's 12 … 23.
template <class Real>
struct NumberedBox
{
  Obb<Real> box;  ///< in any frame
  int first_edge; ///< 0 for A, 12 for B

  /// The number of the edge along axis k on given sides, −1 or 1, of the box's two other axes.
  int edge(int k, const Vector3<Real>& sides) const
  {
    const auto bit = [&](int axis) { return sides[axis] > Real(0) ? 1 : 0; };
    return first_edge + 4 * k + bit((k + 1) % 3) + 2 * bit((k + 2) % 3);
  }
};
// [box_with_numbers]

// [face_along]
/// A face of a box; its sides are counted counter-clockwise, as seen from outside.
template <class Real>
struct BoxFace
{
  Vector3<Real> center;       ///< [m]
  Matrix3<Real> axes;         ///< [1], columns x along side 0, y along side 1, z outwards
  Vector<Real, 2> half_sides; ///< [m], along x and y
  std::array<int, 4> edges;   ///< the numbers of the box's edges at −y, +x, +y, −x
};

/// The face whose outward normal is most along a direction, which must not be zero; O10.
///
/// Of faces that are equally so it is the first, in the order x, y, z.
template <class Real>
BoxFace<Real> face_along(const NumberedBox<Real>& numbered, const Vector3<Real>& direction)
{
  const Obb<Real>& box = numbered.box;
  const Vector3<Real> along = box.axes.transpose() * direction;
  int k = 0;
  along.cwiseAbs().maxCoeff(&k);
  const bool positive = along[k] > Real(0);
  const int x = (k + (positive ? 1 : 2)) % 3, y = 3 - k - x;
  const Real sign = positive ? Real(1) : Real(-1);
  const Vector3<Real> outward = sign * box.axes.col(k);
  BoxFace<Real> face;
  face.center = box.center + box.half_extents[k] * outward;
  face.axes << box.axes.col(x), box.axes.col(y), outward;
  face.half_sides << box.half_extents[x], box.half_extents[y];
  const auto edge = [&](int axis, Real side)
  {
    Vector3<Real> sides = Vector3<Real>::Constant(side);
    sides[k] = sign;
    return numbered.edge(axis, sides);
  };
  face.edges = {edge(x, Real(-1)), edge(y, Real(1)), edge(x, Real(1)), edge(y, Real(-1))};
  return face;
}
// [face_along]

// [edge_along]
/// An edge of a box.
template <class Real>
struct BoxEdge
{
  Vector3<Real> middle;    ///< [m]
  Vector3<Real> direction; ///< [1], unit
  Real half_length;        ///< [m]
  int number;              ///< 0 … 23
};

/// Of the four edges along axis k the one that lies farthest along a direction.
template <class Real>
BoxEdge<Real> edge_along(const NumberedBox<Real>& numbered, int k, const Vector3<Real>& direction)
{
  const Obb<Real>& box = numbered.box;
  const Vector3<Real> along = box.axes.transpose() * direction;
  const Vector3<Real> sides =
      along.unaryExpr([](const Real& x) { return x < Real(0) ? Real(-1) : Real(1); });
  Vector3<Real> middle = sides.cwiseProduct(box.half_extents);
  middle[k] = Real(0);
  return {
      box.center + box.axes * middle, box.axes.col(k), box.half_extents[k],
      numbered.edge(k, sides)};
}
// [edge_along]

} // namespace cookbook
