/// \file
/// Random numbers for tests.
#pragma once

#include "common/math/vector.hpp"

#include <cstdint>
#include <random>

namespace cookbook
{

/// Random numbers that are the same with every compiler and library.
class Random
{
public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  double between(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(engine_()) * 0x1p-32);
  }

  bool one_in(std::uint32_t n) { return engine_() % n == 0; }

  /// A whole number from low to high.
  int whole(int low, int high)
  {
    return low + static_cast<int>(engine_() % static_cast<std::uint32_t>(high - low + 1));
  }

  Vector3<double> in_cube(double half)
  {
    const double x = between(-half, half);
    const double y = between(-half, half);
    return {x, y, between(-half, half)};
  }

  Vector3<double> direction()
  {
    for (;;)
    {
      const Vector3<double> v = in_cube(1);
      if (v.squaredNorm() > 0.01 && v.squaredNorm() <= 1)
      {
        return v.normalized();
      }
    }
  }

private:
  std::mt19937 engine_;
};

} // namespace cookbook
