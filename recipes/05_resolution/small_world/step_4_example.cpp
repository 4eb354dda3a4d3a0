/// \file
/// \brief The pairs that step 4 compares on a floor of cubes: the program of its page.

// [example]
#include "05_resolution/small_world/trial/small_scenes.hpp"

#include <iostream>

using namespace cookbook::small_world;

int main()
{
  for (const int side : {5, 10, 20, 40})
  {
    step_4::World world = floor_of_cubes<step_4::World>(side);
    const std::size_t bodies = world.bodies.size();
    const std::size_t compared = pairs_compared(world.bodies);
    step(world, frame);
    std::cout << bodies - 1 << " cubes: " << bodies * (bodies - 1) / 2 << " pairs, " << compared
              << " compared, " << world.contacts.size() / 4 << " touch\n";
  }
}
// [example]
