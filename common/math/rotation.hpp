#pragma once

/// \file
/// \brief Rotations: exact ones from whole-number quaternions, and the check that one is one.

#include "common/math/vector.hpp"

#include <cmath>

namespace cookbook
{

// [rational_rotation]
/// The rotation matrix of the quaternion w + xi + yj + zk, which need not have length one; M16.
///
/// Whole numbers w, x, y, z give a matrix of fractions with the denominator w²+x²+y²+z²: exact
/// in `Rational`, and correctly rounded once it is cast to a float. The zero quaternion is not a
/// rotation; it divides by zero.
template <class Real>
Matrix3<Real> rational_rotation(int w, int x, int y, int z)
{
  Matrix3<Real> numerator;
  numerator << Real(w * w + x * x - y * y - z * z), Real(2 * (x * y - w * z)),
      Real(2 * (x * z + w * y)), Real(2 * (x * y + w * z)), Real(w * w - x * x + y * y - z * z),
      Real(2 * (y * z - w * x)), Real(2 * (x * z - w * y)), Real(2 * (y * z + w * x)),
      Real(w * w - x * x - y * y + z * z);
  return numerator / Real(w * w + x * x + y * y + z * z);
}
// [rational_rotation]

/// How far a matrix is from a rotation: the largest entry of |RᵀR − 1|, or 2 if it mirrors; M7.
template <class Real>
Real rotation_error(const Matrix3<Real>& r)
{
  const Matrix3<Real> product = r.transpose() * r;
  const Real error = (product - Matrix3<Real>::Identity()).cwiseAbs().maxCoeff();
  return r.determinant() < Real(0) ? Real(2) : error;
}

} // namespace cookbook
