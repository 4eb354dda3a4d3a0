#pragma once

/// \file
/// \brief Numbers and vectors over the whole range of a number type, degenerate ones among them.

#include "common/math/vector.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace cookbook
{

/// Draws finite numbers of every size that `Real` has, the same ones every time.
///
/// Every eighth number is zero, the smallest, the largest or a power of two; all others have random
/// digits, and an exponent from those of the smallest to those of the largest number.
template <class Real>
class WholeRange
{
public:
  /// A number of any size and sign.
  Real number()
  {
    using Limits = std::numeric_limits<Real>;
    const int exponent = drawn(Limits::min_exponent - Limits::digits, Limits::max_exponent - 1);
    const Real sign = drawn(0, 1) == 0 ? Real(-1) : Real(1);
    if (drawn(0, 7) == 0)
    {
      const Real special[] = {
          0, Limits::denorm_min(), Limits::max(), std::ldexp(Real(1), exponent)};
      return sign * special[drawn(0, 3)];
    }
    return sign * std::ldexp(digits(), exponent);
  }

  /// A number from -1 to 1 with random digits.
  Real fraction() { return drawn(0, 1) == 0 ? digits() - Real(1) : Real(1) - digits(); }

  /// A vector whose components have all sizes, each its own.
  Vector3<Real> vector()
  {
    const Real x = number(), y = number();
    return {x, y, number()};
  }

  /// A vector whose components are of one size, which may be any.
  Vector3<Real> even_vector()
  {
    const Real size = number(), x = fraction(), y = fraction();
    return Vector3<Real>(x, y, fraction()) * size;
  }

  /// A whole number from `least` to `most`.
  int drawn(int least, int most)
  {
    return least + static_cast<int>(random_() % static_cast<unsigned>(most - least + 1));
  }

private:
  /// From one to below two.
  Real digits()
  {
    using Limits = std::numeric_limits<Real>;
    const std::uint64_t bits = random_() >> (64 - (Limits::digits - 1));
    return Real(1) + std::ldexp(static_cast<Real>(bits), 1 - Limits::digits);
  }

  std::mt19937_64 random_{1};
};

} // namespace cookbook
