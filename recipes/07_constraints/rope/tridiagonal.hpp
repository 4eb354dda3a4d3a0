#pragma once

/// \file
/// \brief Systems of equations in which each unknown knows but its two neighbours.

#include <Eigen/Core>
#include <Eigen/LU>

#include <cstddef>
#include <vector>

namespace cookbook
{

// [tridiagonal]
/// A row of a tridiagonal system, of numbers or of blocks of Size by Size:
/// before x[i-1] + diagonal x[i] + after x[i+1] = right.
template <int Size>
struct TridiagonalRow
{
  using Block = Eigen::Matrix<double, Size, Size>;
  Block before = Block::Zero(), diagonal = Block::Zero(), after = Block::Zero();
  Eigen::Matrix<double, Size, 1> right = Eigen::Matrix<double, Size, 1>::Zero();
};

/// Solves a tridiagonal system: eliminates downwards, then inserts upwards. Each row is touched
/// twice.
///
/// Without pivoting: the diagonal has to outweigh what is beside it. Source: Thomas 1949.
template <int Size>
std::vector<Eigen::Matrix<double, Size, 1>>
solve_tridiagonal(std::vector<TridiagonalRow<Size>> rows)
{
  std::vector<Eigen::Matrix<double, Size, 1>> x(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    TridiagonalRow<Size>& row = rows[i];
    if (i > 0)
    {
      row.diagonal -= row.before * rows[i - 1].after;
      row.right -= row.before * rows[i - 1].right;
    }
    const typename TridiagonalRow<Size>::Block inverse = row.diagonal.inverse();
    row.after = (inverse * row.after).eval();
    row.right = (inverse * row.right).eval();
  }
  for (std::size_t i = rows.size(); i-- > 0;)
  {
    x[i] = rows[i].right;
    if (i + 1 < rows.size())
    {
      x[i] -= rows[i].after * x[i + 1];
    }
  }
  return x;
}
// [tridiagonal]

} // namespace cookbook
