#pragma once

/// \file
/// \brief What `either` means for packs: each lane picks its own.

#include "common/math/vector.hpp"
#include "common/simd/pack.hpp"

#include <cstddef>

namespace cookbook
{

// [either]
/// In every lane the number of the first, if a test says so there; otherwise that of the second.
template <class Real, std::size_t Width, class Second>
Pack<Real, Width> either(
    const typename Pack<Real, Width>::Mask& first, const Pack<Real, Width>& yes,
    const Second& second)
{
  return all(first) ? yes : select(first, yes, Pack<Real, Width>(second()));
}

/// The same for each number of a vector or matrix.
template <class Real, std::size_t Width, int Rows, int Columns, class Second>
Eigen::Matrix<Pack<Real, Width>, Rows, Columns> either(
    const typename Pack<Real, Width>::Mask& first,
    const Eigen::Matrix<Pack<Real, Width>, Rows, Columns>& yes, const Second& second)
{
  Eigen::Matrix<Pack<Real, Width>, Rows, Columns> chosen = yes;
  if (!all(first))
  {
    const Eigen::Matrix<Pack<Real, Width>, Rows, Columns> no = second();
    for (int i = 0; i < yes.size(); ++i)
    {
      chosen(i) = select(first, yes(i), no(i));
    }
  }
  return chosen;
}
// [either]

} // namespace cookbook
