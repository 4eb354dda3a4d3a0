/// \file
/// \brief Shots at a wall of 2 cm under step 7: the program of its page.

// [example]
#include "05_resolution/small_world/step_7.hpp"

#include <iostream>

using namespace cookbook::small_world;

int main()
{
  for (const double speed : {10.0, 30.0, 100.0, 300.0, 1000.0})
  {
    step_7::World world;
    world.gravity.setZero();
    add(world, box({0, 0, 0}, {0.01, 5, 5}, 0));
    add(world, sphere({-2, 0, 0}, 0.05, 1));
    world.bodies[1].restitution = 0.5;
    world.bodies[1].motion.velocity.x() = speed;
    for (int frame = 0; frame < 30; ++frame)
    {
      step(world, 1.0 / 60);
    }
    std::cout << speed << " m/s before, " << world.bodies[1].motion.velocity.x() << " m/s after\n";
  }
}
// [example]
