#pragma once

/// \file
/// \brief A body's bounds, where it is, and as trees and lists of pairs know them.

#include "06_world/contacts/start_body.hpp"
#include "common/math/vector.hpp"

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

/// The bounds of a shape at a place, wider by a margin [m].
inline Eigen::AlignedBox<double, 3> bounds_at(const Pose& pose, const Shape& shape, double margin)
{
  const Eigen::AlignedBox<double, 3> box =
      std::visit([&](const auto& one) { return bounds(one, pose); }, shape);
  const Vector3<double> wider = Vector3<double>::Constant(margin);
  return {box.min() - wider, box.max() + wider};
}

/// The bounds of a shape where its body is, wider by a margin [m].
inline Eigen::AlignedBox<double, 3>
bounds_of(const RigidBody& body, const Shape& shape, double margin)
{
  return bounds_at(pose_of(body), shape, margin);
}

} // namespace cookbook
