/// \file
/// The plain formulas beside those for any size, as a page shows them.

// [example]
#include "01_math/angles/angles.hpp"

#include <cstdio>

int main()
{
  using namespace cookbook;
  const Vector3<float> room(1, 2, 2), galaxy = 1e20f * room, a(8193, 8192, 0), b(8192, 8191, 0);
  std::printf("          plain  any size\n");
  std::printf("a room    %-5.3g  %.3g\n", plain::length(room), length(room));
  std::printf("a galaxy  %-5.3g  %.3g\n", plain::length(galaxy), length(galaxy));
  std::printf("an angle  %-5.3g  %.3g\n", plain::angle(a, b), angle(a, b));
}
// [example]
