/// \file
/// \brief A ball on a rope of 1 m, let go level with its hook.

// [example]
#include "06_world/game_world/solvers.hpp"
#include "07_constraints/distance/distance.hpp"
#include <algorithm>
#include <cstdio>
using namespace cookbook;

int main()
{
  const SceneBody hook{.name = "hook", .shape = SphereShape{0.05}};
  SceneBody ball{.name = "ball", .shape = SphereShape{0.1}, .mass = 2, .position = {1, 0, 0}};
  GameWorld world({.bodies = {hook, ball}}, solver_named("direct"));
  DistanceJoints ropes;
  ropes.add(rope_between(world, 0, 1, {0, 0, 0}, {1, 0, 0}, 1));
  const std::size_t place = world.add(ropes);
  double most = 0;
  for (int frame = 0; frame < 60; ++frame, world.step())
    most = std::max(most, 60 * world.constraints<DistanceJoints>(place).impulses(0)[0]);
  std::printf("%.2f times its weight\n", most / (2 * 9.81));
}
// [example]
