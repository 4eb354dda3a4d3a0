#pragma once

/// \file
/// \brief Cofactors of 3 by 3 and 4 by 4 matrices, and what is made of them without a question.

#include "common/math/vector.hpp"

#include <cmath>

namespace cookbook
{

/// A matrix with as many rows as columns.
template <class Real, int Size>
using SquareMatrix = Eigen::Matrix<Real, Size, Size>;

/// A 4 by 4 matrix.
template <class Real>
using Matrix4 = SquareMatrix<Real, 4>;

// [cofactors]
/// The cofactors of a 3 by 3 matrix: each column is the cross product of the two others.
template <class Real>
Matrix3<Real> cofactors(const Matrix3<Real>& m)
{
  Matrix3<Real> answer;
  answer.col(0) = m.col(1).cross(m.col(2));
  answer.col(1) = m.col(2).cross(m.col(0));
  answer.col(2) = m.col(0).cross(m.col(1));
  return answer;
}
// [cofactors]

// [cofactors4]
/// The six 2 by 2 minors of two rows: of the columns 01, 02, 03, 12, 13 and 23.
template <class Real>
Vector<Real, 6> minors(const Matrix4<Real>& m, int first, int second)
{
  const auto minor = [&](int i, int j)
  { return m(first, i) * m(second, j) - m(first, j) * m(second, i); };
  Vector<Real, 6> all;
  all << minor(0, 1), minor(0, 2), minor(0, 3), minor(1, 2), minor(1, 3), minor(2, 3);
  return all;
}

/// The cofactors that a row and the minors of two other rows make: a cross product of three rows.
template <class Real>
Vector<Real, 4> cofactor_row(const Vector<Real, 4>& row, const Vector<Real, 6>& of)
{
  return {
      row[1] * of[5] - row[2] * of[4] + row[3] * of[3],
      row[2] * of[2] - row[0] * of[5] - row[3] * of[1],
      row[0] * of[4] - row[1] * of[2] + row[3] * of[0],
      row[1] * of[1] - row[0] * of[3] - row[2] * of[0]};
}

/// The cofactors of a 4 by 4 matrix, by the 2 by 2 minors of its upper and its lower half.
template <class Real>
Matrix4<Real> cofactors(const Matrix4<Real>& m)
{
  const Vector<Real, 6> upper = minors<Real>(m, 0, 1), lower = minors<Real>(m, 2, 3);
  Matrix4<Real> answer;
  answer.row(0) = cofactor_row<Real>(m.row(1), lower);
  answer.row(1) = -cofactor_row<Real>(m.row(0), lower);
  answer.row(2) = cofactor_row<Real>(m.row(3), upper);
  answer.row(3) = -cofactor_row<Real>(m.row(2), upper);
  return answer;
}
// [cofactors4]

// [adjugate]
/// The inverse by the formula as it stands, M11; the determinant must not be zero.
template <class Real, int Size>
SquareMatrix<Real, Size> adjugate_inverse(const SquareMatrix<Real, Size>& m)
{
  const SquareMatrix<Real, Size> c = cofactors<Real>(m);
  const Real determinant = m.col(0).dot(c.col(0));
  return c.transpose() / determinant;
}
// [adjugate]

// [permanent]
/// All products of the determinant added without their signs.
template <class Real>
Real permanent(const Matrix3<Real>& m)
{
  using std::abs;
  const auto pair = [&](int i, int j) { return abs(m(i, 1) * m(j, 2)) + abs(m(j, 1) * m(i, 2)); };
  return abs(m(0, 0)) * pair(1, 2) + abs(m(1, 0)) * pair(2, 0) + abs(m(2, 0)) * pair(0, 1);
}
// [permanent]

/// The same for a 4 by 4 matrix: pairs of the upper rows times pairs of the lower ones.
template <class Real>
Real permanent(const Matrix4<Real>& m)
{
  using std::abs;
  const auto pair = [&](int row, int i, int j)
  { return abs(m(row, i) * m(row + 1, j)) + abs(m(row, j) * m(row + 1, i)); };
  const auto both = [&](int i, int j, int k, int l)
  { return pair(0, i, j) * pair(2, k, l) + pair(0, k, l) * pair(2, i, j); };
  return both(0, 1, 2, 3) + both(0, 2, 1, 3) + both(0, 3, 1, 2);
}

} // namespace cookbook
