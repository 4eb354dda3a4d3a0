/// \file
/// \brief A tower of ten cubes under step 3 of the small world.

// [example]
#include "05_resolution/small_world/step_3.hpp"

#include <iostream>

int main()
{
  cookbook::small_world::step_3::World world;
  add(world, cookbook::small_world::box({0, -1, 0}, {10, 1, 10}, 0));
  for (int i = 0; i < 10; ++i)
  {
    add(world, cookbook::small_world::box({0, i + 0.5, 0}, {0.5, 0.5, 0.5}, 1));
  }
  for (int frame = 0; frame < 2400; ++frame) // 40 s
  {
    step(world, 1.0 / 60);
  }
  const Eigen::Vector3d top = world.bodies.back().motion.center;
  std::cout << "top: " << std::round(1000 * top.y()) << " mm high, ";
  std::cout << std::round(1000 * std::hypot(top.x(), top.z())) << " mm aside\n";
}
// [example]
