#pragma once

/// \file
/// \brief Numbers and vectors of them from a seed, the same on every machine.

#include "common/math/vector.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>

namespace cookbook
{

/// Draws numbers within bounds, and vectors of them; as many of 32 random bits as `Real` holds.
///
/// Give each number a name before two meet in one expression: which is drawn first would be open.
template <class Real>
class NumberDraw
{
public:
  explicit NumberDraw(std::uint32_t seed) : engine_(seed) {}

  Real between(Real low, Real high)
  {
    constexpr int bits = std::min(std::numeric_limits<Real>::digits, 32);
    constexpr Real unit = Real(1) / static_cast<Real>(std::uint64_t{1} << bits);
    return low + (high - low) * (static_cast<Real>(engine_() >> (32 - bits)) * unit);
  }

  /// Every component from low to high.
  Vector3<Real> in_box(Real low, Real high)
  {
    const Real x = between(low, high), y = between(low, high);
    return {x, y, between(low, high)};
  }
  Vector3<Real> in_cube(Real half) { return in_box(-half, half); }

protected:
  std::mt19937 engine_;
};

using FloatDraw = NumberDraw<float>;

} // namespace cookbook
