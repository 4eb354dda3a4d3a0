/// \file
/// \brief What is asleep on a floor of 400 cubes, and what a sphere wakes: the program of its page.

// [example]
#include "05_resolution/small_world/step_6.hpp"
#include "05_resolution/small_world/trial/small_scenes.hpp"

#include <iostream>

using namespace cookbook::small_world;

int main()
{
  step_6::World world = floor_of_cubes<step_6::World>(20);
  add(world, sphere({0, 10, 0}, 0.25, 1)); // it falls where four cubes meet
  for (int seconds = 0; seconds < 5; ++seconds)
  {
    int asleep = 0;
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
    {
      asleep += step_6::is_asleep(world, i) ? 1 : 0;
    }
    std::cout << "after " << seconds << " s: " << asleep << " asleep, " << world.contacts.size()
              << " contact points solved\n";
    run(world, 1);
  }
}
// [example]
