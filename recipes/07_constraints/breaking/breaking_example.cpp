/// \file
/// \brief Three weights on a chain whose links bear 25 N each.

// [example]
#include "06_world/ball_joint/ball_joint.hpp"
#include "06_world/game_world/solvers.hpp"
#include "07_constraints/breaking/breaking.hpp"
#include <cstdio>
using namespace cookbook;

int main()
{
  Scene scene{.bodies = {{.name = "hook", .shape = SphereShape{0.05}}}};
  for (const double y : {-0.5, -1.0, -1.5})
    scene.bodies.push_back({"weight", SphereShape{0.1}, 1, MotionType::dynamic, {0, y, 0}});
  GameWorld world(scene, solver_named("direct"));
  BallJoints chain;
  for (BodyId id = 0; id < 3; ++id)
    chain.set_strength(
        chain.add(ball_joint_at(world, id, id + 1, world.body(id).motion.center)), 25);
  const std::size_t place = world.add(chain);
  world.step();
  for (const std::size_t i : broken_joints(world.constraints<BallJoints>(place)))
    std::printf("link %zu broke\n", i);
}
// [example]
