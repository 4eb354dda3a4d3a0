#pragma once

/// \file
/// \brief Shapes that only this chapter needs, as plain data.

#include "02_primitives/shapes/shapes.hpp"

namespace cookbook
{

// [more_shapes]
/// A solid with four corners.
template <class Real>
struct Tetrahedron
{
  Vector3<Real> a; ///< [m], world
  Vector3<Real> b; ///< [m], world
  Vector3<Real> c; ///< [m], world
  Vector3<Real> d; ///< [m], world
};

/// A box whose edges lie along the world's axes: Eigen's own, from its corner min() to max().
template <class Real>
using Aabb = Eigen::AlignedBox<Real, 3>;
// [more_shapes]

} // namespace cookbook
