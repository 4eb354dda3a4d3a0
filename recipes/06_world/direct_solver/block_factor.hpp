#pragma once

/// \file
/// \brief The factor of a single block: six numbers of one body by six.

#include "06_world/constraints/constraint_row.hpp"

#include <Eigen/Core>

#include <cmath>

namespace cookbook
{

/// A block of the matrix: how the impulses on one body change with the velocities of another.
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// The inverse of the lower triangular factor of a block; false if it has none.
inline bool invert_factor(const Matrix6& block, Matrix6& inverse)
{
  double l[6][6];
  inverse.setZero();
  for (int j = 0; j < 6; ++j)
  {
    double d = block(j, j);
    for (int k = 0; k < j; ++k)
    {
      d -= l[j][k] * l[j][k];
    }
    if (!(d > 0))
    {
      return false;
    }
    const double per = 1 / std::sqrt(d);
    for (int i = j + 1; i < 6; ++i)
    {
      double s = block(i, j);
      for (int k = 0; k < j; ++k)
      {
        s -= l[i][k] * l[j][k];
      }
      l[i][j] = s * per;
    }
    inverse(j, j) = per;
    for (int i = 0; i < j; ++i)
    {
      double s = 0;
      for (int k = i; k < j; ++k)
      {
        s -= l[j][k] * inverse(k, i);
      }
      inverse(j, i) = s * per;
    }
  }
  return true;
}

} // namespace cookbook
