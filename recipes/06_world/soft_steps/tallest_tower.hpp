#pragma once

/// \file
/// \brief How high a tower on soft contacts may be before it bends under its own weight.

#include <cmath>

namespace cookbook
{

// [tallest_tower]
/// How many equal cubes with edges [m] stand on each other, each corner on a spring of a frequency
/// [Hz], under gravity [m/s²]: a higher tower leans, and falls; R35. All are greater than zero.
///
/// Source: Greenhill 1881, the height at which a rod buckles under its own weight; its number is
/// 9/4 of the square of the first zero of the Bessel function J of order -1/3.
template <class Real>
Real tallest_tower(const Real& edge, const Real& frequency, const Real& gravity)
{
  using std::cbrt;
  const Real turns = Real(6.283185307179586);     // 2 pi
  const Real greenhill = Real(7.837347438943483); // 9/4 of the square of a zero of J
  const Real in_radians = turns * frequency;
  return cbrt(greenhill / Real(8) * in_radians * in_radians * edge / gravity);
}
// [tallest_tower]

} // namespace cookbook
