#pragma once

/// \file
/// \brief Poses and their inverse, points to local coordinates, normals: the formulas as they
/// stand.

#include "01_math/matrices/cofactors.hpp"
#include "01_math/plain_vectors/plain_vectors.hpp"

#include <Eigen/Geometry>

namespace cookbook
{

// [aliases]
/// A turn and a move: distances and angles stay. Eigen's own type.
template <class Real>
using Isometry3 = Eigen::Transform<Real, 3, Eigen::Isometry>;

/// Any 3 by 3 matrix and a move: straight lines stay straight. Eigen's own type.
template <class Real>
using Affine3 = Eigen::Transform<Real, 3, Eigen::Affine>;

/// The plane of all x with normal · x + offset = 0. Eigen's own type.
template <class Real>
using Hyperplane3 = Eigen::Hyperplane<Real, 3>;
// [aliases]

/// The pose that first turns by `rotation` and then moves by `move`.
template <class Real>
Isometry3<Real> pose(const Matrix3<Real>& rotation, const Vector3<Real>& move)
{
  Isometry3<Real> t = Isometry3<Real>::Identity();
  t.linear() = rotation;
  t.translation() = move;
  return t;
}

// [rigid_inverse]
/// The inverse of a pose: the transpose, and the move turned back; M15.
///
/// The turn must be a rotation; moves are right up to half the largest number of the type.
template <class Real>
Isometry3<Real> rigid_inverse(const Isometry3<Real>& t)
{
  const Matrix3<Real> back = t.linear().transpose();
  return pose<Real>(back, -(back * t.translation()));
}
// [rigid_inverse]

// [to_local]
/// A point of the world as the body sees it: subtract first, then turn back.
template <class Real>
Vector3<Real> to_local(const Isometry3<Real>& t, const Vector3<Real>& point)
{
  return t.linear().transpose() * (point - t.translation());
}
// [to_local]

namespace plain
{

// [plain_normal]
/// The unit normal of a surface after the matrix `m`: along M⁻ᵀ n, M14, by the cofactors of `m`.
///
/// A normal that has no image, for the matrix squashes what is perpendicular to it, gets +y.
template <class Real>
Vector3<Real> transformed_normal(const Matrix3<Real>& m, const Vector3<Real>& n)
{
  const Vector3<Real> along = cofactors<Real>(m) * n;
  return normalize<Real>(m.determinant() < Real(0) ? Vector3<Real>(-along) : along);
}
// [plain_normal]

} // namespace plain

} // namespace cookbook
