#pragma once

/// \file
/// \brief The names of vectors, matrices and quaternions: Eigen's own types.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace cookbook
{

/// A vector or point of `Size` components.
template <class Real, int Size>
using Vector = Eigen::Matrix<Real, Size, 1>;

/// A vector or point in a plane.
template <class Real>
using Vector2 = Eigen::Matrix<Real, 2, 1>;

/// A vector or point in space.
template <class Real>
using Vector3 = Eigen::Matrix<Real, 3, 1>;

/// A 2 by 2 matrix.
template <class Real>
using Matrix2 = Eigen::Matrix<Real, 2, 2>;

/// A 3 by 3 matrix; as a rotation, its columns are the body's axes in the world.
template <class Real>
using Matrix3 = Eigen::Matrix<Real, 3, 3>;

/// A quaternion, written in the order w, x, y, z.
template <class Real>
using Quaternion = Eigen::Quaternion<Real>;

} // namespace cookbook
