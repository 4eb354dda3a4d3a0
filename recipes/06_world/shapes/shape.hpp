#pragma once

/// \file
/// \brief The shape of a body: one that the world knows, or any that has six functions.

#include "06_world/shapes/convex_shape.hpp"

#include <variant>

namespace cookbook
{

// [shape]
/// A solid box about the body's centre of mass.
struct BoxShape
{
  Vector3<double> half_extents; ///< [m], greater than zero
};

/// A solid sphere about the body's centre of mass.
struct SphereShape
{
  double radius; ///< [m], greater than zero
};

/// All that lies below a plane; only a fixed body can have this shape. It is where it is, whatever
/// the pose of its body, and has no bounds, so that no point of it is farthest in a direction:
/// whatever meets a plane is asked for its own farthest point.
struct PlaneShape
{
  Vector3<double> normal; ///< [1], unit, world, out of the solid
  double offset;          ///< [m], of the plane from the origin, along the normal
};

/// How a body collides: a box, a sphere, a plane, or any convex shape that has six functions.
using Shape = std::variant<BoxShape, SphereShape, PlaneShape, ConvexShape>;
// [shape]

} // namespace cookbook
