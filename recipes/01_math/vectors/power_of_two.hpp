#pragma once

/// \file
/// \brief Vectors of any size, brought to ordinary size by a power of two, which changes no digit.

#include "common/math/norm.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

namespace cookbook
{

/// A vector `v` times 2^`exponent`.
template <class Real>
struct Scaled
{
  Vector3<Real> v; ///< the largest component is from 1 to 2, or all are 0
  int exponent;    ///< of the power of two that was taken out
};

/// A vector times 2^`exponent`: exact, but for what leaves the range of the number type.
template <class Real>
Vector3<Real> times_power_of_two(const Vector3<Real>& v, int exponent)
{
  using std::ldexp;
  return {ldexp(v.x(), exponent), ldexp(v.y(), exponent), ldexp(v.z(), exponent)};
}

/// Takes the power of two out of a vector; what is not finite, or zero, stays as it is.
template <class Real>
Scaled<Real> scaled(const Vector3<Real>& v)
{
  const Real largest = v.cwiseAbs().maxCoeff();
  const bool ordinary = largest > Real(0) && largest <= std::numeric_limits<Real>::max();
  const int exponent = ordinary ? std::ilogb(largest) : 0;
  return {times_power_of_two<Real>(v, -exponent), exponent};
}

/// A double vector times a power of two, so that its largest component lies between 2⁴⁰⁰ and 2⁴⁰¹:
/// then products keep the digits of the smallest components. Zero stays as it is.
inline Vector3<double> enlarged(const Vector3<double>& v)
{
  return v.isZero(0) ? v : times_power_of_two<double>(v, 400 - scaled<double>(v).exponent);
}

/// Whether a number is so far from both ends of its type's range that the product or quotient of
/// two such numbers is, too. A fraction, whose range has no ends, only must not be zero.
template <class Real>
bool is_ordinary(const Real& x)
{
  if constexpr (std::is_floating_point_v<Real>)
  {
    const Real least = std::numeric_limits<Real>::epsilon() * std::numeric_limits<Real>::epsilon();
    return x >= least && x <= Real(1) / least;
  }
  return x != Real(0);
}

/// The length of a vector of any size; infinite only where it is too large for the number type.
template <class Real>
Real length(const Vector3<Real>& v)
{
  const Real squared = v.squaredNorm();
  if (squared >= SafeSquares<Real>::least && squared <= SafeSquares<Real>::most)
  {
    return std::sqrt(squared);
  }
  const Scaled<Real> ordinary = scaled<Real>(v);
  return std::ldexp(ordinary.v.norm(), ordinary.exponent);
}

} // namespace cookbook
