/// \file
/// \brief A tower of five cubes under step 1 of the small world.

// [example]
#include "05_resolution/small_world/step_1.hpp"

#include <iostream>

int main()
{
  cookbook::small_world::step_1::World world;
  add(world, cookbook::small_world::box({0, -1, 0}, {10, 1, 10}, 0)); // the ground: no mass
  for (int i = 0; i < 5; ++i)
  {
    add(world, cookbook::small_world::box({0, i + 0.5, 0}, {0.5, 0.5, 0.5}, 1));
  }
  for (int frame = 0; frame < 1200; ++frame) // 20 s
  {
    step(world, 1.0 / 60);
  }
  for (std::size_t i = 1; i <= 5; ++i)
  {
    std::cout << "cube " << i << ": " << std::round(1000 * world.bodies[i].motion.center.y())
              << " mm\n";
  }
}
// [example]
