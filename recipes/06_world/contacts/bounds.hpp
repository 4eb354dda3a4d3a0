#pragma once

/// \file
/// \brief A body's bounds, where it is, and as trees and lists of pairs know them.

#include "06_world/contacts/rigid_body.hpp"
#include "common/math/vector.hpp"

#include <limits>
#include <variant>

namespace cookbook
{

// [bounds]
/// A body's bounds in the world.
struct Bounds
{
  Eigen::AlignedBox<double, 3> box; ///< [m], world; infinite for a plane
  int body;                         ///< its number
  int index = 0;                    ///< in the list that a tree was built of
};
// [bounds]

/// How far [m] a body reaches from its centre along the axes of the world; `axes()` are its own.
template <class Axes>
struct AxisExtents
{
  const Axes& axes;

  Vector3<double> operator()(const BoxShape& box) const
  {
    return axes().cwiseAbs() * box.half_extents;
  }
  Vector3<double> operator()(const SphereShape& sphere) const
  {
    return Vector3<double>::Constant(sphere.radius);
  }
  Vector3<double> operator()(const PlaneShape&) const
  {
    return Vector3<double>::Constant(std::numeric_limits<double>::infinity());
  }
};

/// The bounds of a shape at a place [m], wider by a margin [m]; `axes()` are the shape's own.
template <class Axes>
Eigen::AlignedBox<double, 3>
bounds_at(const Vector3<double>& center, const Axes& axes, const Shape& shape, double margin)
{
  const Vector3<double> extents =
      std::visit(AxisExtents<Axes>{axes}, shape) + Vector3<double>::Constant(margin);
  return {center - extents, center + extents};
}

/// The bounds of a shape where its body is, wider by a margin [m].
inline Eigen::AlignedBox<double, 3>
bounds_of(const RigidBody& body, const Shape& shape, double margin)
{
  const auto axes = [&]() -> const Matrix3<double>& { return body.axes; };
  return bounds_at(body.motion.center, axes, shape, margin);
}

} // namespace cookbook
