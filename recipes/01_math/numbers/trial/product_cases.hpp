#pragma once

/// \file
/// \brief Ways to subtract a product from another, and the products that break them.

#include "01_math/numbers/difference_of_products.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to compute ad − bc, by name.
template <class Real>
struct ProductMethod
{
  std::string name;                           ///< as on the page
  Real (*difference)(Real, Real, Real, Real); ///< the way: a, d, b, c
};

/// ad − bc in the wider type: exact for floats but for the last rounding, no help for doubles.
template <class Real>
Real difference_wide(Real a, Real d, Real b, Real c)
{
  return static_cast<Real>(Wide<Real>(a) * Wide<Real>(d) - Wide<Real>(b) * Wide<Real>(c));
}

/// The ways that compete, the recommended one last.
template <class Real>
std::array<ProductMethod<Real>, 4> product_methods()
{
  return {
      {{"naive", difference_naive<Real>},
       {"wider", difference_wide<Real>},
       {"fused", difference_fused<Real>},
       {"difference_of_products", difference_of_products<Real>}}};
}

/// Four numbers and the true ad − bc, by hand.
template <class Real>
struct ProductCase
{
  std::string what; ///< as text
  Real a, d, b, c;  ///< the numbers
  Real right;       ///< the true answer
};

/// Products of floats. Of three Fibonacci numbers in a row, the square of the middle one is 1 more
/// or less than the product of the others, as Cassini found.
inline std::vector<ProductCase<float>> product_cases(float)
{
  return {
      {"3 · 7 − 5 · 4, float", 3, 7, 5, 4, 1},
      {"three Fibonacci numbers, float", 9227465, 9227465, 5702887, 14930352, 1},
      {"1e60 − 1e60, float", 1e30f, 1e30f, 1e30f, 1e30f, 0}};
}

/// Products of doubles.
inline std::vector<ProductCase<double>> product_cases(double)
{
  const double f76 = 3416454622906707, f77 = 5527939700884757, f78 = 8944394323791464;
  return {
      {"larger Fibonacci numbers, double", f77, f77, f76, f78, 1},
      {"products of 2^1030, 2^978 apart, double", 0x1p530, 0x1p500, 0x1p530, 0x1p500 - 0x1p448,
       0x1p978}};
}

/// The verdicts on all ways; right means within an ulp and a half.
template <class Real>
std::vector<VerdictRow> product_verdicts(const std::vector<ProductCase<Real>>& cases)
{
  std::vector<VerdictRow> rows;
  for (const ProductCase<Real>& one : cases)
  {
    rows.push_back({"", one.what, {}, number(static_cast<double>(one.right))});
    for (const ProductMethod<Real>& method : product_methods<Real>())
    {
      const Real answer = method.difference(one.a, one.d, one.b, one.c);
      const bool right =
          std::abs(answer - one.right) <= std::numeric_limits<Real>::epsilon() * one.right;
      rows.back().verdicts.push_back(
          {right, right                ? "right"
                  : std::isnan(answer) ? "not a number"
                                       : "says " + number(static_cast<double>(answer))});
    }
  }
  return rows;
}

} // namespace cookbook
