#pragma once

/// \file
/// \brief The check that a mass and its moments of inertia can be a solid's.

#include "02_primitives/shapes/checked_shapes.hpp"
#include "05_resolution/mass_properties/mass_properties.hpp"

#include <string>

namespace cookbook
{

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
