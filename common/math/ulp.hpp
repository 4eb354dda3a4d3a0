#pragma once

/// \file
/// \brief The unit in the last place: the distance between neighbouring floating-point numbers.

#include <cmath>
#include <limits>

namespace cookbook
{

/// Distance from |x| to the next larger number of its type.
template <class Real>
Real ulp(Real x)
{
  const Real size = std::abs(x);
  return std::nextafter(size, std::numeric_limits<Real>::infinity()) - size;
}

} // namespace cookbook
