#pragma once

/// \file
/// \brief Inverses by Eigen's decompositions, which take long to compile, compiled once.

#include "01_math/matrices/cofactors.hpp"

#include <optional>

namespace cookbook
{

/// Eigen's PartialPivLU, for 3 by 3 matrices of float and double and for 4 by 4 ones of double.
template <class Real, int Size>
SquareMatrix<Real, Size> partial_lu_inverse(const SquareMatrix<Real, Size>& m);

/// Eigen's FullPivLU, for the same; nothing where it says that the matrix is singular.
template <class Real, int Size>
std::optional<SquareMatrix<Real, Size>> full_lu_inverse(const SquareMatrix<Real, Size>& m);

} // namespace cookbook
