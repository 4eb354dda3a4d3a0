#pragma once

/// \file
/// \brief Floats and vectors of floats from a seed, the same on every machine.

#include "common/math/vector.hpp"

#include <cstdint>
#include <random>

namespace cookbook
{

/// Draws floats within bounds, and vectors of them.
class FloatDraw
{
public:
  explicit FloatDraw(std::uint32_t seed) : engine_(seed) {}

  float number(float low, float high)
  {
    return low + (high - low) * static_cast<float>(engine_() >> 8) * 0x1p-24f;
  }
  Vector3<float> vector(float low, float high)
  {
    const float x = number(low, high), y = number(low, high);
    return {x, y, number(low, high)};
  }
  Vector3<float> vector(float most) { return vector(-most, most); }

private:
  std::mt19937 engine_;
};

} // namespace cookbook
