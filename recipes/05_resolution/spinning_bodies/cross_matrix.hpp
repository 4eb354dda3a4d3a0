#pragma once

/// \file
/// \brief A cross product as the product with a matrix.

#include "common/math/vector.hpp"

namespace cookbook
{

// [cross_matrix]
/// The matrix that a vector multiplies another with from the left, as a cross product.
template <class Real>
Matrix3<Real> cross_matrix(const Vector3<Real>& v)
{
  Matrix3<Real> matrix;
  matrix << Real(0), -v.z(), v.y(), v.z(), Real(0), -v.x(), -v.y(), v.x(), Real(0);
  return matrix;
}
// [cross_matrix]

} // namespace cookbook
