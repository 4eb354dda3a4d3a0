#pragma once

/// \file
/// \brief Two links that swing in a plane, by their two angles: Lagrange's equation written out.

#include "common/math/trigonometry.hpp"
#include "common/math/vector.hpp"

namespace cookbook
{

// [double_pendulum]
/// A link of a pendulum, which swings in a plane.
struct SwingingLink
{
  double mass;   ///< [kg], greater than zero
  double moment; ///< [kg m²], about its centre of mass; zero for a point
  double center; ///< [m], from its pivot to its centre of mass
  double length; ///< [m], from its pivot to the next one
};

/// Two links, the first on a hook, the second on the end of the first.
struct DoublePendulum
{
  SwingingLink first, second;
  double gravity = 9.81; ///< [m/s²]
};

/// The mass matrix [kg m²] at these angles [rad] from straight down; R50.
inline Matrix2<double> mass_matrix(const DoublePendulum& pendulum, const Vector2<double>& angles)
{
  const auto& [m1, i1, c1, l1] = pendulum.first;
  const auto& [m2, i2, c2, l2] = pendulum.second;
  const double coupling = m2 * l1 * c2 * cosine(angles.x() - angles.y());
  Matrix2<double> mass;
  mass << i1 + m1 * c1 * c1 + m2 * l1 * l1, coupling, coupling, i2 + m2 * c2 * c2;
  return mass;
}

/// The angular accelerations [rad/s²] at these angles [rad] and speeds [rad/s]; R50.
inline Vector2<double> angular_accelerations(
    const DoublePendulum& pendulum, const Vector2<double>& angles, const Vector2<double>& speeds)
{
  const auto& [m1, i1, c1, l1] = pendulum.first;
  const auto& [m2, i2, c2, l2] = pendulum.second;
  const double bend = m2 * l1 * c2 * sine(angles.x() - angles.y());
  const Vector2<double> torque(
      -bend * speeds.y() * speeds.y() - (m1 * c1 + m2 * l1) * pendulum.gravity * sine(angles.x()),
      bend * speeds.x() * speeds.x() - m2 * c2 * pendulum.gravity * sine(angles.y()));
  const Matrix2<double> mass = mass_matrix(pendulum, angles);
  const double determinant = mass(0, 0) * mass(1, 1) - mass(0, 1) * mass(1, 0);
  return Vector2<double>(
             mass(1, 1) * torque.x() - mass(0, 1) * torque.y(),
             mass(0, 0) * torque.y() - mass(1, 0) * torque.x()) /
         determinant;
}

/// Kinetic and potential energy [J]; zero at rest with both links at the height of the hook.
inline double
energy(const DoublePendulum& pendulum, const Vector2<double>& angles, const Vector2<double>& speeds)
{
  const auto& [m1, i1, c1, l1] = pendulum.first;
  const double height = -(m1 * c1 + pendulum.second.mass * l1) * cosine(angles.x()) -
                        pendulum.second.mass * pendulum.second.center * cosine(angles.y());
  return speeds.dot(mass_matrix(pendulum, angles) * speeds) / 2 + pendulum.gravity * height;
}
// [double_pendulum]

} // namespace cookbook
