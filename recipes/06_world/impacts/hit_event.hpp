#pragma once

/// \file
/// \brief What a world tells of two bodies that have hit each other.

#include "common/math/vector.hpp"

namespace cookbook
{

// [hit_event]
/// Two bodies that have hit each other in a step.
struct Impact
{
  int a;                  ///< the point of body A in the world's lists
  int b;                  ///< that of body B, greater than a
  Vector3<double> point;  ///< [m], world, where they met
  Vector3<double> normal; ///< [1], unit, world, from A to B
  double speed;           ///< [m/s], at which they closed there, along the normal
};
// [hit_event]

} // namespace cookbook
