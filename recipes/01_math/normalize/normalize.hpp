#pragma once

/// \file
/// \brief Ways to normalise a vector beside the recommended one.

#include "01_math/plain_vectors/plain_vectors.hpp"
#include "common/math/norm.hpp"
#include "common/math/wide.hpp"

#include <cmath>

namespace cookbook
{

// [normalize_naive]
/// Divides by √(v·v): wrong where squares overflow or underflow, NaN for the zero vector.
template <class Real>
Direction<Real> normalize_naive(const Vector3<Real>& v)
{
  const Real length = plain::length(v);
  return {v / length, length};
}
// [normalize_naive]

// [normalize_threshold]
/// Takes what is shorter than 1e-6 [unit of the vector] for zero, whatever unit that is.
///
/// Such a vector gets the length zero and points along +y; large vectors fare as in the naive way.
template <class Real>
Direction<Real> normalize_threshold(const Vector3<Real>& v)
{
  const Real smallest = Real(1e-6);
  const Direction<Real> naive = normalize_naive(v);
  return naive.length < smallest ? Direction<Real>{Vector3<Real>::UnitY(), Real(0)} : naive;
}
// [normalize_threshold]

// [normalize_wide]
/// Squares in the wider type: a float's squares fit a double, a double's have nowhere to go.
///
/// The zero vector points along +y.
template <class Real>
Direction<Real> normalize_wide(const Vector3<Real>& v)
{
  using std::sqrt;
  const Vector3<Wide<Real>> wide = widen(v);
  const Wide<Real> length = sqrt(wide.dot(wide));
  if (length == Wide<Real>(0))
  {
    return {Vector3<Real>::UnitY(), Real(0)};
  }
  return {(wide / length).template cast<Real>(), static_cast<Real>(length)};
}
// [normalize_wide]

/// Divides by the library's `hypot`: its length is right, but tiny vectors divide by one that has
/// no digits left. Not a number for the zero vector.
template <class Real>
Direction<Real> normalize_hypot(const Vector3<Real>& v)
{
  const Real length = std::hypot(v.x(), v.y(), v.z());
  return {v / length, length};
}

} // namespace cookbook
