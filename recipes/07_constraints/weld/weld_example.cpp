/// \file
/// \brief A shelf that is welded to a wall.

// [example]
#include "06_world/game_world/solvers.hpp"
#include "07_constraints/weld/weld.hpp"
#include <cstdio>
using namespace cookbook;

int main()
{
  const SceneBody wall{.name = "wall", .shape = BoxShape{{0.1, 1, 1}}};
  SceneBody shelf{.name = "shelf", .shape = BoxShape{{0.2, 0.02, 0.5}}, .mass = 3};
  shelf.position = {0.3, 0, 0};
  GameWorld world({.bodies = {wall, shelf}}, solver_named("direct"));
  WeldJoints welds;
  welds.add(weld_at(world, 0, 1, {0.1, 0, 0}));
  const std::size_t place = world.add(welds);
  for (int frame = 0; frame < 60; ++frame)
    world.step();
  const JointImpulses& weld = world.constraints<WeldJoints>(place).impulses(0);
  std::printf("%.2f N, %.3f N m\n", 60 * weld[1], 60 * weld[5]);
}
// [example]
