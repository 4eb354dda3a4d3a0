#pragma once

/// \file
/// \brief A body's bounds, as trees and lists of pairs know them.

#include "common/math/vector.hpp"

namespace cookbook
{

// [bounds]
/// A body's bounds in the world.
struct Bounds
{
  Eigen::AlignedBox<double, 3> box; ///< [m], world; infinite for a plane
  int body;                         ///< its number
  int place = 0;                    ///< in the list that a tree was built of
};
// [bounds]

} // namespace cookbook
