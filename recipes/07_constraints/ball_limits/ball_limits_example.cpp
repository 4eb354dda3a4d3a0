/// \file
/// \brief An arm on a shoulder that lets it swing by 30° only.

// [example]
#include "06_world/game_world/solvers.hpp"
#include "07_constraints/ball_limits/ball_limits.hpp"
#include <cstdio>
using namespace cookbook;

int main()
{
  const SceneBody torso{.name = "torso", .shape = BoxShape{{0.2, 0.4, 0.1}}};
  SceneBody arm{.name = "arm", .shape = BoxShape{{0.3, 0.05, 0.05}}, .mass = 2};
  arm.position = {0.5, 0.3, 0};
  GameWorld world({.bodies = {torso, arm}}, solver_named("direct"));
  ConeTwistJoint shoulder = cone_twist_at(world, 0, 1, {0.2, 0.3, 0}, {1, 0, 0});
  shoulder.cone = 0.5235987756; // pi / 6
  ConeTwistJoints shoulders;
  shoulders.add(shoulder);
  world.add(shoulders);
  for (int frame = 0; frame < 120; ++frame)
    world.step();
  std::printf("the arm is at %.4f m\n", world.body(1).motion.center.y()); // 0.3 - 0.3 sin 30°
}
// [example]
