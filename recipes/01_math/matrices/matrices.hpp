#pragma once

/// \file
/// \brief Determinant and inverse of a 3 by 3 or 4 by 4 matrix, right for every finite one.

#include "01_math/matrices/cofactors.hpp"
#include "01_math/matrices/wide_double.hpp"
#include "common/math/vector.hpp"
#include "common/math/wide.hpp"

#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

namespace cookbook
{

// [condition]
/// How many times more the determinant changes than the entries do, both relative.
///
/// One for a diagonal matrix, whatever its entries; infinite where the determinant is zero.
template <class Real, int Size>
Real condition(const SquareMatrix<Real, Size>& m)
{
  const SquareMatrix<WideDouble, Size> wide = m.template cast<WideDouble>();
  const SquareMatrix<WideDouble, Size> c = cofactors<WideDouble>(wide);
  const WideDouble determinant = wide.col(0).dot(c.col(0));
  if (determinant.high == 0)
  {
    return std::numeric_limits<Real>::infinity();
  }
  const WideDouble products = wide.cwiseProduct(c).cwiseAbs().sum();
  return static_cast<Real>(static_cast<double>(products / (abs(determinant) * Size)));
}
// [condition]

// [keeps_digits]
/// Whether a determinant, computed in `Real`, has lost no more than about a quarter of its digits,
/// and no product on the way to the inverse has left the range of the type, at either end.
template <class Real, int Size>
bool keeps_digits(const SquareMatrix<Real, Size>& m, const Real& determinant)
{
  using Limits = std::numeric_limits<Real>;
  static const Real fraction = std::ldexp(Real(1), -Limits::digits / 4);
  static const Real most = std::ldexp(Real(1), Limits::max_exponent / 5);
  static const Real least = std::ldexp(Real(1), Limits::min_exponent / Size);
  const Real size = std::abs(determinant);
  const auto entries = m.array().abs();
  return size >= fraction * permanent<Real>(m) && size * most >= Real(1) &&
         m.cwiseAbs().maxCoeff() <= most && (entries >= least || entries == Real(0)).all();
}
// [keeps_digits]

// [inverse_wide]
/// The inverse in 105 binary digits, rounded once; nothing if a singular matrix may round to this
/// one.
///
/// That is decided by how far the determinant moves where each entry moves by half an ulp.
template <class Real, int Size>
std::optional<SquareMatrix<Real, Size>> inverse_wide(const SquareMatrix<Real, Size>& m)
{
  if (!m.allFinite())
  {
    return std::nullopt;
  }
  const SquareMatrix<WideDouble, Size> wide = m.template cast<WideDouble>();
  const SquareMatrix<WideDouble, Size> c = cofactors<WideDouble>(wide);
  const WideDouble determinant = wide.col(0).dot(c.col(0));
  const WideDouble roundoff = static_cast<double>(std::numeric_limits<Real>::epsilon()) / 2;
  const WideDouble first = roundoff * wide.cwiseProduct(c).cwiseAbs().sum();
  const WideDouble second = roundoff * roundoff * permanent<WideDouble>(wide);
  if (abs(determinant) <= first + second * WideDouble(64))
  {
    return std::nullopt;
  }
  const auto rounded = [&](const WideDouble& cofactor)
  { return static_cast<Real>(static_cast<double>(cofactor / determinant)); };
  return c.transpose().unaryExpr(rounded);
}
// [inverse_wide]

// [inverse]
/// The inverse, M11; nothing where the matrix is singular to rounding or not finite.
///
/// Right for entries of every size. An entry that is too large for `Real` becomes infinite.
template <class Real, int Size>
std::optional<SquareMatrix<Real, Size>> inverse(const SquareMatrix<Real, Size>& m)
{
  if (keeps_digits<Real, Size>(m, m.determinant()))
  {
    return m.inverse();
  }
  if constexpr (!std::is_same_v<Real, Wide<Real>>)
  {
    const SquareMatrix<Wide<Real>, Size> wide = widen(m);
    if (keeps_digits<Wide<Real>, Size>(wide, wide.determinant()))
    {
      return wide.inverse().template cast<Real>();
    }
  }
  return inverse_wide<Real, Size>(m);
}
// [inverse]

/// The determinant; infinite where it is too large for `Real`.
///
/// About three quarters of its digits are right, unless the products cancel to less than 2^-98 of
/// their sum without signs.
template <class Real, int Size>
Real determinant(const SquareMatrix<Real, Size>& m)
{
  const Real plain = m.determinant();
  if (keeps_digits<Real, Size>(m, plain) || !m.allFinite())
  {
    return plain;
  }
  const SquareMatrix<WideDouble, Size> wide = m.template cast<WideDouble>();
  const SquareMatrix<WideDouble, Size> c = cofactors<WideDouble>(wide);
  return static_cast<Real>(static_cast<double>(WideDouble(wide.col(0).dot(c.col(0)))));
}

} // namespace cookbook
