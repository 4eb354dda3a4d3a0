#pragma once

/// \file
/// \brief The disc in which the surfaces of two overlapping spheres meet.

#include <algorithm>
#include <cmath>
#include <optional>

namespace cookbook
{

/// The disc in which the surfaces of two overlapping spheres meet.
template <class Real>
struct LensDisc
{
  Real offset; ///< [m], of its plane from A's centre, along the normal
  Real radius; ///< [m]
};

/// The disc of the lens that two spheres `distance` [m] apart have in common; S9.
///
/// Nothing where the surfaces do not meet: the spheres are apart, or one is inside the other.
template <class Real>
std::optional<LensDisc<Real>> lens_disc(Real distance, Real radius_a, Real radius_b)
{
  using std::abs, std::sqrt;
  if (distance > radius_a + radius_b || distance < abs(radius_a - radius_b) || distance == Real(0))
  {
    return std::nullopt;
  }
  const Real offset =
      (distance + (radius_a - radius_b) * ((radius_a + radius_b) / distance)) / Real(2);
  return LensDisc<Real>{offset, sqrt(std::max(Real(0), radius_a * radius_a - offset * offset))};
}

} // namespace cookbook
