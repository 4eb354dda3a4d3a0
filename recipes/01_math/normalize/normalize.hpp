#pragma once

/// \file
/// \brief Ways to normalise a vector beside the recommended one, and what a unit vector is for.

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
  using std::sqrt;
  const Real length = sqrt(v.dot(v));
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

// [project]
/// The part of `a` along `n`, of any length but zero; M3.
template <class Real>
Vector3<Real> project(const Vector3<Real>& a, const Vector3<Real>& n)
{
  return n * (a.dot(n) / n.dot(n));
}

/// The part of `a` across `n`, of any length but zero; M3.
template <class Real>
Vector3<Real> reject(const Vector3<Real>& a, const Vector3<Real>& n)
{
  return a - project(a, n);
}
// [project]

// [reflect]
/// The mirror image of `v` in a plane with the unit normal `n`; M4.
///
/// A normal that is not of length one also changes the length of `v`.
template <class Real>
Vector3<Real> reflect(const Vector3<Real>& v, const Vector3<Real>& n)
{
  return v - n * (Real(2) * v.dot(n));
}
// [reflect]

} // namespace cookbook
