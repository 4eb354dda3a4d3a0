/// \file
/// \brief A lamp that hangs on a hook by a ball joint.

// [example]
#include "06_world/ball_joint/ball_joint.hpp"
#include "06_world/game_world/solvers.hpp"
#include <cmath>
#include <cstdio>
using namespace cookbook;

int main()
{
  const SceneBody hook{.name = "hook", .shape = SphereShape{0.1}, .position = {0, 3, 0}};
  const SceneBody lamp{.name = "lamp", .shape = SphereShape{0.2}, .mass = 4, .position = {1, 3, 0}};
  GameWorld world({.bodies = {hook, lamp}}, solver_named("direct"));
  BallJoints joints;
  joints.add(ball_joint_at(world, 0, 1, {0, 3, 0}));
  const std::size_t cables = world.add(joints);
  for (int step = 0; step < 36; ++step)
    world.step();
  const JointImpulses& cable = world.constraints<BallJoints>(cables).impulses(0);
  const double pull = 60 * std::hypot(cable[0], cable[1], cable[2]);
  std::printf("at %.2f m, %.1f N\n", world.body(1).motion.center.y(), pull);
}
// [example]
