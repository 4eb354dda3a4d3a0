#pragma once

/// \file
/// \brief The next wider number type, for intermediate results that must not lose digits.

#include "common/math/vector.hpp"

namespace cookbook
{

/// Chooses the wider type; types other than float are their own.
template <class Real>
struct WideOf
{
  using type = Real; ///< the type itself
};

/// A float's products and sums fit a double.
template <>
struct WideOf<float>
{
  using type = double; ///< double
};

/// The type to compute in where a difference of nearly equal numbers is taken.
template <class Real>
using Wide = typename WideOf<Real>::type;

/// A vector or matrix in the wider type; its numbers stay as they are.
template <class Real, int Rows, int Columns>
Eigen::Matrix<Wide<Real>, Rows, Columns> widen(const Eigen::Matrix<Real, Rows, Columns>& m)
{
  return m.template cast<Wide<Real>>();
}

} // namespace cookbook
