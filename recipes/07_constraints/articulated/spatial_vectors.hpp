#pragma once

/// \file
/// \brief Motions, forces and inertias as six numbers: spatial vectors.

#include "05_resolution/spinning_bodies/cross_matrix.hpp"

namespace cookbook
{

// [spatial_vectors]
/// A motion (ω, v) [rad/s, m/s] or a force (n, f) [N m, N]: the part that turns comes first.
using SpatialVector = Vector<double, 6>;
/// What takes a spatial motion to a spatial force.
using SpatialMatrix = Eigen::Matrix<double, 6, 6>;

/// A spatial vector of the part that turns and the part that moves along.
inline SpatialVector spatial(const Vector3<double>& turning, const Vector3<double>& along)
{
  SpatialVector both;
  both << turning, along;
  return both;
}

/// The motion of a rigid body at a point `arm` [m] further on: X v; R51.
inline SpatialVector shifted_motion(const SpatialVector& motion, const Vector3<double>& arm)
{
  const Vector3<double> turning = motion.head<3>(), along = motion.tail<3>();
  return spatial(turning, along + turning.cross(arm));
}

/// A force at a point `arm` [m] further on, as it acts here: Xᵀ f; R51.
inline SpatialVector shifted_force(const SpatialVector& force, const Vector3<double>& arm)
{
  const Vector3<double> moment = force.head<3>(), along = force.tail<3>();
  return spatial(moment + arm.cross(along), along);
}

/// An inertia at a point `arm` [m] further on, as it is felt here: Xᵀ I X; R51.
inline SpatialMatrix shifted_inertia(const SpatialMatrix& inertia, const Vector3<double>& arm)
{
  const Matrix3<double> r = cross_matrix(arm), mass = inertia.bottomRightCorner<3, 3>();
  const Matrix3<double> r_mass = r * mass, coupling = inertia.topRightCorner<3, 3>();
  const Matrix3<double> r_coupling = r * coupling.transpose();
  SpatialMatrix shifted;
  shifted.topLeftCorner<3, 3>() =
      inertia.topLeftCorner<3, 3>() + r_coupling + r_coupling.transpose() - r_mass * r;
  shifted.topRightCorner<3, 3>() = coupling + r_mass;
  shifted.bottomLeftCorner<3, 3>() = shifted.topRightCorner<3, 3>().transpose();
  shifted.bottomRightCorner<3, 3>() = mass;
  return shifted;
}

/// The inertia of a rigid body at its centre of mass [kg m², kg]: turning and moving are apart.
inline SpatialMatrix
rigid_inertia(double mass, const Vector3<double>& moments, const Matrix3<double>& axes)
{
  SpatialMatrix inertia = SpatialMatrix::Zero();
  inertia.topLeftCorner<3, 3>() = axes * moments.asDiagonal() * axes.transpose();
  inertia.bottomRightCorner<3, 3>().diagonal().setConstant(mass);
  return inertia;
}
// [spatial_vectors]

} // namespace cookbook
