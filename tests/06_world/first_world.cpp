/// \file
/// A whole program that uses the world, as a page shows it; ctest compares what it prints.

// [first_world]
#include "06_world/game_world/solvers.hpp"

#include <cstdio>

int main()
{
  using namespace cookbook;
  const BoxShape cube{{0.5, 0.5, 0.5}};
  const SphereShape sphere{0.25};
  Scene scene;
  scene.bodies = {
      {.name = "floor", .shape = PlaneShape{{0, 1, 0}, 0}},
      {.name = "crate 1", .shape = cube, .mass = 10, .position = {0, 0.5, 0}},
      {.name = "crate 2", .shape = cube, .mass = 10, .position = {0, 1.5, 0}},
      {.name = "crate 3", .shape = cube, .mass = 10, .position = {0, 2.5, 0}},
      {.name = "ball", .shape = sphere, .mass = 5, .position = {-8, 2, 0}, .velocity = {12, 3, 0}}};
  GameWorld world(scene, solver_named("direct"));
  for (int line = 1; line <= 9; ++line)
  {
    for (int step = 1; step <= 30; ++step)
    {
      world.step();
    }
    const Vector3<double> at = world.bodies()[3].motion.center;
    std::printf("%.1f s: crate 3 is at (%.2f, %.2f)\n", world.time(), at.x(), at.y());
  }
}
// [first_world]
