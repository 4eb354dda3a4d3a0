#pragma once

/// \file
/// \brief Angles of any size wrapped to half a turn either way.

#include "common/math/trigonometry.hpp"

#include <cmath>

namespace cookbook
{

// [wrap_degrees]
/// The nearest whole number to `x`, of which |x| is below 2³⁰; of two, either.
template <class Real>
Real nearest_whole(Real x)
{
  return static_cast<Real>(static_cast<int>(x + std::copysign(Real(0.5), x)));
}

/// An angle [degrees] as the same direction in (−180, 180], exactly, for every finite number.
///
/// Infinite and NaN input gives NaN: no direction is known.
template <class Real>
Real wrap_degrees(Real degrees)
{
  const Real turn = 360, half = 180;
  Real rest = degrees;
  if (std::abs(degrees) < Real(1 << 24))
  {
    // The product is exact, and so is the difference: it has no finer digits than the angle.
    rest = degrees - nearest_whole(degrees / turn) * turn;
  }
  else
  {
    rest = std::remainder(degrees, turn);
  }
  return rest > half ? rest - turn : rest > -half ? rest : rest + turn;
}
// [wrap_degrees]

// [wrap_radians]
/// An angle [rad] as the same direction, from −π to π, for every finite number.
///
/// Off by at most an ulp of π [rad] from the exact angle, taking the input as exact. Infinite and
/// NaN input gives NaN: no direction is known.
template <class Real>
Real wrap_radians(Real angle)
{
  const double x = static_cast<double>(angle), half_turn = 3.14159265358979311600;
  const SineCosine<double> of = sine_cosine(x);
  return std::abs(x) <= half_turn ? angle : static_cast<Real>(arc_tangent(of.sine, of.cosine));
}
// [wrap_radians]

} // namespace cookbook
