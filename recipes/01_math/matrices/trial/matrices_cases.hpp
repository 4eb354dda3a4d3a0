#pragma once

/// \file
/// \brief Ways to invert a matrix, matrices that break some of them, and how far off an inverse is.

#include "01_math/matrices/matrices.hpp"
#include "01_math/matrices/trial/lu_inverses.hpp"
#include "tools/exact/exact.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace cookbook
{

// [inverse_as_published]
/// Our model of the seed's code, X36: a determinant below a fixed threshold counts as zero, and the
/// answer is then the identity.
template <class Real>
Matrix3<Real> inverse_as_published(const Matrix3<Real>& m)
{
  if (std::abs(m.determinant()) < Real(0.005))
  {
    return Matrix3<Real>::Identity();
  }
  return m.inverse();
}
// [inverse_as_published]

/// A way to invert, by name; nothing where it says that the matrix is singular.
template <class Real>
struct InverseMethod
{
  std::string name;                                               ///< as on the page
  std::optional<Matrix3<Real>> (*invert)(const Matrix3<Real>& m); ///< the way
};

/// The ways that compete, the recommended one last.
template <class Real>
std::array<InverseMethod<Real>, 6> inverse_methods()
{
  using M = Matrix3<Real>;
  using Answer = std::optional<M>;
  return {
      {{"as published", [](const M& m) -> Answer { return inverse_as_published<Real>(m); }},
       {"Eigen inverse", [](const M& m) -> Answer { return m.inverse(); }},
       {"Eigen with check",
        [](const M& m)
        {
          M answer;
          bool invertible = false;
          m.computeInverseWithCheck(answer, invertible);
          return invertible ? Answer(answer) : Answer();
        }},
       {"PartialPivLU", [](const M& m) -> Answer { return partial_lu_inverse<Real, 3>(m); }},
       {"FullPivLU", full_lu_inverse<Real, 3>},
       {"recommended", inverse<Real, 3>}}};
}

/// The exact values of a matrix's entries.
template <class Real, int Size>
SquareMatrix<Rational, Size> exact_matrix(const SquareMatrix<Real, Size>& m)
{
  return m.unaryExpr([](const Real& x) { return Rational(x); });
}

/// How far an inverse is off, in roundings: one is what the exact inverse changes, entry by entry,
/// where each entry of the matrix changes by half an ulp. Infinite where an entry is not finite.
template <class Real, int Size>
double inverse_error(const SquareMatrix<Real, Size>& answer, const SquareMatrix<Real, Size>& m)
{
  if (!answer.allFinite())
  {
    return std::numeric_limits<double>::infinity();
  }
  using Exact = SquareMatrix<Rational, Size>;
  const Exact a = exact_matrix<Real, Size>(m), x = adjugate_inverse<Rational, Size>(a);
  const Exact size = x.cwiseAbs();
  const Exact off = (exact_matrix<Real, Size>(answer) - x).cwiseAbs();
  const Exact rounding =
      size * a.cwiseAbs() * size * Rational(std::numeric_limits<Real>::epsilon());
  Rational worst = 0;
  for (int i = 0; i < Size * Size; ++i)
  {
    if (off.data()[i] != 0)
    {
      worst = std::max<Rational>(worst, 2 * off.data()[i] / rounding.data()[i]);
    }
  }
  return static_cast<double>(worst);
}

/// A matrix that some way to invert may not survive.
template <class Real>
struct MatrixCase
{
  std::string id;   ///< in the book; empty for a neighbour of the case above
  std::string what; ///< the matrix, in a few words
  Matrix3<Real> m;  ///< the matrix
  bool singular;    ///< whether it is singular to rounding
};

/// A matrix by its rows.
template <class Real>
Matrix3<Real> rows(const std::array<double, 9>& all)
{
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> map(all.data());
  return map.template cast<Real>();
}

/// The matrices to try, in float or in double.
template <class Real>
std::vector<MatrixCase<Real>> matrix_cases()
{
  const bool is_float = std::is_same_v<Real, float>;
  const double tiny = is_float ? 1e-20 : 1e-160, small = is_float ? 1e-5 : 1e-13;
  const std::string name = is_float ? "" : ", double";
  const auto scale = [](double s) { return Matrix3<Real>(Matrix3<Real>::Identity() * Real(s)); };
  const Matrix3<Real> alike =
      Matrix3<Real>::Ones() + Real(small) * rows<Real>({0, 5, 6, 3, 1, 2, 1, 4, 0});
  return {
      {"A4", "Scale(0.1)" + name, scale(0.1), false},
      {"", "Scale(1e-4)" + name, scale(1e-4), false},
      {"", "Scale(" + number(tiny) + ")" + name, scale(tiny), false},
      {"", "Scale(" + number(1 / tiny) + ")" + name, scale(1 / tiny), false},
      {"", "diag(1e-30, 1, 1e30)" + name, rows<Real>({1e-30, 0, 0, 0, 1, 0, 0, 0, 1e30}), false},
      {"", (is_float ? "0.0034 and 2.6e-23 beside it" : "1e-20 and 2.3e-308 beside it") + name,
       is_float ? rows<Real>({0.0034, 2.6e-23, 0, 0, 0.0034, 2.6e-23, 0, 0, 0.0034})
                : rows<Real>({1e-20, 0, 0, 0, 1e-20, 2.3e-308, 0, 0, 1e-20}),
       false},
      {"", "rows in km, m, mm" + name, rows<Real>({2e3, 0, 1e3, 1, 3, 2, 1e-3, 1e-3, 2e-3}), false},
      {"", "Hilbert" + name,
       rows<Real>({1, 1. / 2, 1. / 3, 1. / 2, 1. / 3, 1. / 4, 1. / 3, 1. / 4, 1. / 5}), false},
      {"", "all nearly 1" + name, alike, false},
      {"", "1 2 3, 4 5 6, 7 8 9" + name, rows<Real>({1, 2, 3, 4, 5, 6, 7, 8, 9}), true},
      {"", "the same / 10" + name, rows<Real>({0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}), true},
      {"", "the same with 9.01" + name, rows<Real>({1, 2, 3, 4, 5, 6, 7, 8, 9.01}), false}};
}

/// An inverse is right if it is off by no more roundings of the matrix than this.
inline constexpr double allowed_inverse_roundings = 16;

/// Whether an answer is right, and what to say of it.
template <class Real>
Verdict inverse_verdict(const std::optional<Matrix3<Real>>& answer, const MatrixCase<Real>& one)
{
  if (!answer)
  {
    return {one.singular, "says: singular"};
  }
  if (!answer->allFinite())
  {
    return {false, "not finite"};
  }
  if (one.singular)
  {
    return {false, "entries up to " + rounded(double(answer->cwiseAbs().maxCoeff()))};
  }
  const double error = inverse_error<Real, 3>(*answer, one.m);
  const bool right = error <= allowed_inverse_roundings;
  return {right, right ? "right" : rounded(error) + " roundings off"};
}

/// The verdicts on all ways, case by case.
template <class Real>
std::vector<VerdictRow> inverse_verdicts()
{
  std::vector<VerdictRow> all;
  for (const MatrixCase<Real>& one : matrix_cases<Real>())
  {
    const std::string id = std::is_same_v<Real, float> ? one.id : "";
    all.push_back({id, one.what, {}});
    for (const InverseMethod<Real>& method : inverse_methods<Real>())
    {
      all.back().verdicts.push_back(inverse_verdict<Real>(method.invert(one.m), one));
    }
  }
  return all;
}

} // namespace cookbook
