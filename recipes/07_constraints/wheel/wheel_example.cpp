/// \file
/// \brief A cart of 100 kg that sinks into the springs of four wheels.

// [example]
#include "06_world/game_world/solvers.hpp"
#include "07_constraints/wheel/trial/cart_scene.hpp"
#include "07_constraints/wheel/wheel.hpp"
#include <cstdio>
using namespace cookbook;

int main()
{
  GameWorld world(cart_scene(), solver_named("direct"));
  WheelJoints wheels;
  for (BodyId id = 2; id < 6; ++id)
  {
    WheelJoint wheel = wheel_at(world, 1, id, {0, 0, 1}, {0, 1, 0});
    wheel.suspension = {.stiffness = 2'500, .damping = 250};
    wheels.add(wheel);
  }
  world.add(wheels);
  for (int frame = 0; frame < 600; ++frame, world.step())
    ;
  std::printf("%.4f m lower\n", 0.7 - world.body(1).motion.center.y());
}
// [example]
