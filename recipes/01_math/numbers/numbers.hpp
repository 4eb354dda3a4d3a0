#pragma once

/// \file
/// \brief Rounding: how large its errors are, and comparisons that allow for no more than that.

#include "01_math/numbers/difference_of_products.hpp"
#include "01_math/numbers/interval.hpp"
#include "01_math/numbers/wrap_angle.hpp"
#include "common/math/vector.hpp"

#include <cmath>
#include <limits>

namespace cookbook
{

// [rounding_bound]
/// The unit roundoff u: the most that one rounding changes a number, relative to it.
template <class Real>
Real unit_roundoff()
{
  return std::numeric_limits<Real>::epsilon() / Real(2);
}

/// γₙ = nu/(1 − nu): the most that n roundings in a row do, relative; infinite where nu reaches 1.
template <class Real>
Real rounding_bound(int roundings)
{
  const Real nu = static_cast<Real>(roundings) * unit_roundoff<Real>();
  return nu < Real(1) ? nu / (Real(1) - nu) : std::numeric_limits<Real>::infinity();
}

/// What `roundings` roundings in a row do to numbers of size `size`, and as many underflows.
template <class Real>
Real rounding_error(Real size, int roundings)
{
  const Real least = std::numeric_limits<Real>::denorm_min();
  return rounding_bound<Real>(roundings) * size + static_cast<Real>(roundings) * least;
}
// [rounding_bound]

// [equal_to_rounding]
/// Whether two numbers may be the same but for rounding.
///
/// `size` is the size of what both were computed from: the largest number, or a sum of absolute
/// values as in M6. False where nothing is known: NaN, infinite and not the same, a size that is
/// infinite.
template <class Real>
bool equal_to_rounding(Real a, Real b, Real size, int roundings)
{
  const Real allowed = rounding_error(size, roundings);
  return a == b || (std::isfinite(allowed) && std::abs(a - b) <= allowed);
}
// [equal_to_rounding]

// [bounded_dot]
/// A number, and how far at most it is from the true one.
template <class Real>
struct Bounded
{
  Real value; ///< computed
  Real error; ///< at least |computed − true|; infinite where nothing is known
};

/// Whether the sign of the true number is that of the computed one.
template <class Real>
bool is_sign_certain(const Bounded<Real>& x)
{
  return std::abs(x.value) > x.error;
}

/// a·b with its bound, M6: n roundings for n components, and one more for the bound's own. The
/// bound is infinite or NaN where a product overflows.
template <class Real, int Size>
Bounded<Real> bounded_dot(const Vector<Real, Size>& a, const Vector<Real, Size>& b)
{
  const Real sizes = a.cwiseAbs().dot(b.cwiseAbs());
  return {a.dot(b), rounding_error(sizes, static_cast<int>(a.size()) + 1)};
}
// [bounded_dot]

} // namespace cookbook
