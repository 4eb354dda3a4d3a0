/// \file
/// \brief A pyramid of 55 cubes under step 2 of the small world.

// [example]
#include "05_resolution/small_world/step_2.hpp"

#include <iostream>

int main()
{
  cookbook::small_world::step_2::World world;
  add(world, cookbook::small_world::box({0, -1, 0}, {20, 1, 20}, 0));
  for (int row = 0; row < 10; ++row)
  {
    for (int i = 0; i < 10 - row; ++i)
    {
      const double x = 1.125 * (i - 0.5 * (9 - row));
      add(world, cookbook::small_world::box({x, row + 0.5, 0}, {0.5, 0.5, 0.5}, 1));
    }
  }
  for (int frame = 0; frame < 1200; ++frame) // 20 s
  {
    step(world, 1.0 / 60);
  }
  std::cout << "top: " << std::round(1000 * world.bodies.back().motion.center.y()) << " mm\n";
}
// [example]
