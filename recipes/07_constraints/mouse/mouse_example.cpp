/// \file
/// \brief A crate that the mouse drags up by the middle of its top.

// [example]
#include "06_world/game_world/solvers.hpp"
#include "07_constraints/mouse/mouse.hpp"
#include <cstdio>
using namespace cookbook;

int main()
{
  const SceneBody ground{.name = "ground", .shape = PlaneShape{{0, 1, 0}, 0}};
  const BoxShape box{{0.2, 0.2, 0.2}};
  const SceneBody crate{.name = "crate", .shape = box, .mass = 10, .position = {0, 0.2, 0}};
  GameWorld world({.bodies = {ground, crate}}, solver_named("direct"));
  MouseJoint mouse = mouse_at(world, 0, 1, {0, 0.4, 0}); // the middle of its top
  mouse.target = {0, 2, 0}, mouse.max_force = 300;
  MouseJoints held;
  held.add(mouse);
  world.add(held);
  for (int frame = 0; frame < 600; ++frame, world.step())
    ;
  std::printf("%.2f m up\n", world.body(1).motion.center.y());
}
// [example]
