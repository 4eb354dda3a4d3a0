/// \file
/// \brief How high a dropped sphere comes back under step 5: the program of its page.

// [example]
#include "05_resolution/small_world/step_5.hpp"

#include <iostream>

using namespace cookbook::small_world;

int main()
{
  for (const double restitution : {0.0, 0.3, 0.5, 0.8, 1.0})
  {
    step_5::World world;
    add(world, box({0, -1, 0}, {10, 1, 10}, 0));
    add(world, sphere({0, 1.1, 0}, 0.1, 1)); // it touches after 0.45 s
    world.bodies[1].restitution = restitution;
    double highest = 0;
    for (int frame = 0; frame < 60; ++frame)
    {
      step(world, 1.0 / 60);
      highest = std::max(highest, frame < 30 ? 0 : world.bodies[1].motion.center.y() - 0.1);
    }
    std::cout << "e = " << restitution << ": " << std::round(1e3 * highest) / 1e3 << " m\n";
  }
}
// [example]
