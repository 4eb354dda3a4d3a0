/// \file
/// \brief A log that rolls down a slope.

// [example]
#include "06_world/cylinder/cylinder.hpp"
#include "06_world/game_world/solvers.hpp"

#include <iostream>

int main()
{
  using namespace cookbook;
  Scene scene{.bodies = {{.name = "slope", .shape = PlaneShape{{0.6, 0.8, 0}, 0}}}};
  scene.bodies.push_back({.name = "log", .shape = Cylinder{0.5, 2}, .mass = 100});
  scene.bodies[1].position = {0.3, 0.4, 0};
  scene.bodies[1].orientation = {1, 1, 0, 0}; // a quarter turn: its axis is level
  GameWorld world(scene, solver_named("soft_steps"));
  for (int frame = 0; frame < 120; ++frame) // 2 s
  {
    world.step();
  }
  std::cout << "speed after 2 s: " << world.bodies()[1].motion.velocity.norm() << " m/s\n"
            << "two thirds of what slides: " << 2.0 / 3 * 9.81 * 0.6 * 2 << " m/s\n";
}
// [example]
