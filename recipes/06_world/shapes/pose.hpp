#pragma once

/// \file
/// \brief Where a shape is, and how it is turned.

#include "common/math/vector.hpp"

namespace cookbook
{

/// Where a shape is, and how it is turned.
struct Pose
{
  Vector3<double> center; ///< [m], world
  Matrix3<double> axes;   ///< [1], columns are the shape's own unit axes in the world
};

} // namespace cookbook
