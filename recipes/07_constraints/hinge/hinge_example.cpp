/// \file
/// \brief A door that is thrown against its limit.

// [example]
#include "06_world/game_world/solvers.hpp"
#include "07_constraints/hinge/hinge.hpp"
#include <cstdio>
using namespace cookbook;

int main()
{
  const SceneBody post{.name = "post", .shape = BoxShape{{0.05, 1, 0.05}}};
  SceneBody door{.name = "door", .shape = BoxShape{{0.5, 1, 0.02}}, .mass = 20};
  door.position = {0.5, 0, 0}, door.velocity = {0, 0, -5}, door.angular_velocity = {0, 10, 0};
  GameWorld world({.bodies = {post, door}}, solver_named("soft_steps"));
  HingeJoint hinge = hinge_at(world, 0, 1, {0, 0, 0}, {0, 1, 0});
  hinge.drive.upper = 1.5;
  HingeJoints hinges;
  hinges.add(hinge);
  const std::size_t place = world.add(hinges);
  for (int frame = 0; frame < 12; ++frame)
    world.step();
  std::printf("at %.4f rad\n", world.constraints<HingeJoints>(place)[0].angle);
}
// [example]
