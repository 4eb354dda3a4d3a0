/// \file
/// \brief How many solves a frame a chain with a load needs.

// [example]
#include "07_constraints/taut/taut.hpp"
#include <cstdio>
using namespace cookbook;

int main()
{
  const double length = 0.5, inertia = (length * length + 0.1 * 0.1) / 12; // of a link of 1 kg
  for (const double load : {100.0, 1000.0, 10000.0})
  {
    const TautLink link{9.81 * load, length, inertia};
    std::printf("%5.0f kg: above %.2f solves a frame\n", load, tension_limit(link, 1.0 / 60));
  }
  const HangingBridge bridge{.load = 50 * 9.81};
  std::printf("the bridge sags by %.4f m\n", sag_of(bridge));
}
// [example]
