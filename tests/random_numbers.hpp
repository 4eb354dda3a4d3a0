/// \file
/// Random numbers for tests.
#pragma once

#include "02_primitives/shapes/trial/number_draw.hpp"

#include <cstdint>

namespace cookbook
{

/// Random numbers that are the same with every compiler and library.
class Random : public NumberDraw<double>
{
public:
  using NumberDraw::NumberDraw;

  bool one_in(std::uint32_t n) { return engine_() % n == 0; }

  /// A whole number from low to high.
  int whole(int low, int high)
  {
    return low + static_cast<int>(engine_() % static_cast<std::uint32_t>(high - low + 1));
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
};

} // namespace cookbook
