#pragma once

/// \file
/// \brief The real roots of a quadratic equation, without cancellation.

#include "01_math/numbers/difference_of_products.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace cookbook
{

/// The formula of school, (−b ± √(b² − 4ac)) / 2a: one root loses its digits where 4ac is small.
namespace plain
{

// [quadratic_school]
/// The roots of ax² + bx + c = 0 by the formula of school, the smaller one first; nothing if there
/// are none. `a` is above zero.
template <class Real>
std::optional<std::array<Real, 2>> quadratic_roots(Real a, Real b, Real c)
{
  const Real discriminant = b * b - 4 * a * c;
  if (discriminant < Real(0))
  {
    return std::nullopt;
  }
  const Real root = std::sqrt(discriminant);
  return {{(-b - root) / (2 * a), (-b + root) / (2 * a)}};
}
// [quadratic_school]

} // namespace plain

// [quadratic]
/// The real roots of ax² + bx + c = 0, the smaller one first; nothing if there are none. A double
/// root comes twice, and so does the only root where `a` is zero. Nothing as well where `a` and `b`
/// are zero.
///
/// Nothing cancels: −b and the root are added with one sign, and the other root is c over the
/// product.
template <class Real>
std::optional<std::array<Real, 2>> quadratic_roots(Real a, Real b, Real c)
{
  const Real discriminant = difference_of_products<Real>(b, b, 4 * a, c);
  if (discriminant < Real(0) || (a == Real(0) && b == Real(0)))
  {
    return std::nullopt;
  }
  const Real q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
  const Real product = q == Real(0) ? Real(0) : c / q, other = a == Real(0) ? product : q / a;
  return {{std::min(product, other), std::max(product, other)}};
}
// [quadratic]

} // namespace cookbook
