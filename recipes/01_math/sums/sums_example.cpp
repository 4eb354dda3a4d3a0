/// \file
/// A clock that adds a sixtieth of a second for an hour, as a page shows it.

// [example]
#include "01_math/sums/sums.hpp"

#include <cstdio>

int main()
{
  const std::vector<float> frames(60 * 3600, 1.0f / 60);
  const std::span<const float> hour(frames);
  std::printf("in a loop: %.1f s\n", cookbook::sum_naive(hour));
  std::printf("Kahan:     %.1f s\n", cookbook::sum_kahan(hour));
}
// [example]
