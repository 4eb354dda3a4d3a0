#pragma once

/// \file
/// \brief What the six functions of a shape are asked with, and what they answer.

#include "02_primitives/shapes/answers.hpp"
#include "02_primitives/shapes/shapes.hpp"
#include "05_resolution/mass_properties/solid_mass.hpp"
#include "common/math/norm.hpp"

#include <Eigen/Geometry>

#include <optional>

namespace cookbook
{

// [shape_answers]
/// Where a shape is, and how it is turned.
struct Pose
{
  Vector3<double> center; ///< [m], world
  Matrix3<double> axes;   ///< [1], columns are the shape's own unit axes in the world
};

/// How far a shape reaches from its centre.
struct Extent
{
  double inner; ///< [m], the radius of a ball about the centre that it holds
  double outer; ///< [m], the radius of one that holds it
};

/// Where a ray first meets a shape; nothing where it does not.
using ShapeHit = std::optional<Hit<double, 3>>;
// [shape_answers]

} // namespace cookbook
