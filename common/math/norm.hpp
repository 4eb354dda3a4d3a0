#pragma once

/// \file
/// \brief Length and direction of a vector, right for every finite vector.

#include "common/math/vector.hpp"

#include <cmath>
#include <limits>

namespace cookbook
{

/// A vector split into where it points and how far.
template <class Real>
struct Direction
{
  Vector3<Real> unit; ///< [1] length one
  Real length;        ///< [unit of the vector] zero if and only if the vector was zero
};

/// Squared lengths in this range lose nothing to underflow or overflow.
///
/// Below `least`, a component's square may round to zero that still counts against the others;
/// above `most`, the sum of squares may be infinite.
template <class Real>
struct SafeSquares
{
  using Limits = std::numeric_limits<Real>;
  static inline const Real least = Limits::min() / (Limits::epsilon() * Limits::epsilon());
  static inline const Real most = Limits::max() / 4;
};

// [split]
/// Splits a vector whose squared length lies in the safe range, without a test.
///
/// One division and three products: as good as three divisions to one unit in the last place.
template <class Real>
Direction<Real> split(const Vector3<Real>& v, const Real& squared)
{
  using std::sqrt;
  const Real length = sqrt(squared);
  return {v * (Real(1) / length), length};
}

/// Splits a vector that is not zero, with a power of two in between where squares would not fit.
///
/// The power is exact: the result has the same rounding as a vector of ordinary size.
template <class Real>
Direction<Real> split_scaled(const Vector3<Real>& v)
{
  using std::ilogb, std::ldexp;
  const int exponent = ilogb(v.cwiseAbs().maxCoeff());
  const Vector3<Real> scaled(
      ldexp(v.x(), -exponent), ldexp(v.y(), -exponent), ldexp(v.z(), -exponent));
  const Direction<Real> direction = split<Real>(scaled, scaled.squaredNorm());
  return {direction.unit, ldexp(direction.length, exponent)};
}

/// Splits a vector into unit direction and length.
///
/// The zero vector has length zero and the direction `fallback`. Works for every finite vector
/// whose length is finite, also where the squares of its components are not.
template <class Real>
Direction<Real> normalize(const Vector3<Real>& v, const Vector3<Real>& fallback)
{
  const Real squared = v.squaredNorm();
  // Not a number is neither less nor more: it comes out as it went in.
  if (!(squared < SafeSquares<Real>::least) && !(squared > SafeSquares<Real>::most))
  {
    return split<Real>(v, squared);
  }
  return v.isZero(0) ? Direction<Real>{fallback, Real(0)} : split_scaled(v);
}
// [split]

/// Splits a vector; the zero vector points up, along +y.
template <class Real>
Direction<Real> normalize(const Vector3<Real>& v)
{
  return normalize<Real>(v, Vector3<Real>::UnitY());
}

} // namespace cookbook
