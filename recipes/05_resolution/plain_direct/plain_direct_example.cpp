/// \file
/// \brief What each cube of a tower carries, from one system of equations.

// [example]
#include "05_resolution/plain_direct/plain_direct.hpp"

#include <iostream>

int main()
{
  using namespace cookbook::small_world;
  plain_direct::World world;
  add(world, box({0, -1, 0}, {10, 1, 10}, 0));
  add(world, box({0, 0.5, 0}, {0.5, 0.5, 0.5}, 1));
  add(world, box({0, 1.5, 0}, {0.5, 0.5, 0.5}, 1000));
  for (int frame = 0; frame < 300; ++frame) // 5 s
  {
    step(world, 1.0 / 60);
  }
  for (const std::size_t below : {0U, 1U})
  {
    const double load = 60 * plain_direct::impulse_between(world, below, below + 1);
    std::cout << "load on body " << below << ": " << load << " N\n";
  }
}
// [example]
