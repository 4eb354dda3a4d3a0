/// \file
/// Two quadratic equations, as a page shows them.

// [example]
#include "01_math/numbers/quadratic_roots.hpp"

#include <cstdio>

int main()
{
  using namespace cookbook;
  const float places[] = {1, 10000, 1000000}; // [m] from the origin
  for (const float x : places)
  {
    std::printf("at %.0f m a step of 1 cm is %.4f m\n", x, (x + 0.01f) - x);
  }
  for (const double b : {-3.0, -1e9})
  {
    const auto school = plain::quadratic_roots<double>(1, b, 2),
               ours = quadratic_roots<double>(1, b, 2);
    std::printf(
        "x^2 %+g x + 2 = 0: %.4g by the school's formula, right %.4g\n", b, (*school)[0],
        (*ours)[0]);
  }
}
// [example]
