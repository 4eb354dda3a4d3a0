/// \file
/// \brief A tower of seven cubes under corrected positions.

// [example]
#include "05_resolution/plain_positions/plain_positions.hpp"

#include <iostream>

int main()
{
  using namespace cookbook::small_world;
  plain_positions::World world;
  add(world, box({0, -1, 0}, {10, 1, 10}, 0));
  for (int i = 0; i < 7; ++i)
  {
    add(world, box({0, i + 0.5, 0}, {0.5, 0.5, 0.5}, 1));
  }
  for (int frame = 0; frame < 1200; ++frame) // 20 s
  {
    step(world, 1.0 / 60);
  }
  const double sink = 6.5 - world.bodies.back().motion.center.y();
  std::cout << "the top has sunk by " << std::round(10000 * sink) / 10 << " mm\n";
}
// [example]
