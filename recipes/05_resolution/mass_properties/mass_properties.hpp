#pragma once

/// \file
/// \brief Mass and moments of inertia of solids, and of several solids that hold together.

#include "02_primitives/shapes/shapes.hpp"

#include <string>

namespace cookbook
{

// [mass_properties]
/// How hard a solid is to push, and to turn about each of its own axes.
template <class Real>
struct MassProperties
{
  Real mass;             ///< [kg], greater than zero
  Vector3<Real> moments; ///< [kg m²], about the centre of mass, along the body's axes; above zero
};

/// A solid ball of even density: mass [kg], radius [m]; R26.
template <class Real>
MassProperties<Real> solid_sphere(Real mass, Real radius)
{
  const Real moment = Real(2) / Real(5) * mass * radius * radius;
  return {mass, Vector3<Real>::Constant(moment)};
}

/// A solid box of even density: mass [kg], half extents [m]; R26.
template <class Real>
MassProperties<Real> solid_box(Real mass, const Vector3<Real>& half_extents)
{
  const Vector3<Real> along = half_extents.cwiseProduct(half_extents * (mass / Real(3)));
  return {mass, {along.y() + along.z(), along.z() + along.x(), along.x() + along.y()}};
}
// [mass_properties]

// [capsule]
/// A solid capsule of even density along the body's y axis: mass [kg], length [m] of its segment,
/// radius [m], greater than zero; R26.
///
/// A length of zero makes a ball.
template <class Real>
MassProperties<Real> solid_capsule(Real mass, Real length, Real radius)
{
  const Real middle = mass * (length / (length + Real(4) / Real(3) * radius));
  const Real ends = mass - middle;
  const Real along = radius * (radius * (middle / Real(2) + ends * Real(2) / Real(5)));
  const Real round = radius * (radius * (middle / Real(4) + ends * Real(2) / Real(5)));
  const Real across = round + length * (length * (middle / Real(12) + ends / Real(4))) +
                      radius * (length * ends * Real(3) / Real(8));
  return {mass, Vector3<Real>(across, along, across)};
}
// [capsule]

// [world_inertia]
/// The inertia [kg m²] in the world of a body whose axes are the columns of a matrix; M12.
template <class Real>
Matrix3<Real> world_inertia(const Vector3<Real>& moments, const Matrix3<Real>& axes)
{
  return axes * moments.asDiagonal() * axes.transpose();
}
// [world_inertia]

// [checked_mass]
/// The mass properties themselves, or InvalidShape: mass and moments must be finite and greater
/// than zero, and no moment larger than the two others together.
///
/// x² + y² summed over a solid is never more than (y² + z²) + (z² + x²). Numbers typed by hand may
/// miss that by 1e-4 of the largest.
template <class Real>
const MassProperties<Real>& checked(const MassProperties<Real>& properties)
{
  const auto check = [](const std::string& member, Real value)
  {
    check_finite(member, value);
    if (!(value > Real(0)))
    {
      throw InvalidShape(member, "greater than zero", text_of(value));
    }
  };
  check("mass", properties.mass);
  const char* const names[] = {"moments.x", "moments.y", "moments.z"};
  for (int i = 0; i < 3; ++i)
  {
    check(names[i], properties.moments[i]);
  }
  for (int i = 0; i < 3; ++i)
  {
    const Real others = properties.moments[(i + 1) % 3] + properties.moments[(i + 2) % 3];
    if (properties.moments[i] * Real(1 - 1e-4) > others)
    {
      throw InvalidShape(
          names[i], "at most the two others together, " + text_of(others),
          text_of(properties.moments[i]));
    }
  }
  return properties;
}
// [checked_mass]

} // namespace cookbook
