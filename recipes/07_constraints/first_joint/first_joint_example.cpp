/// \file
/// \brief A wrecking ball on a joint knocks over a tower.

// [example]
#include "07_constraints/first_joint/small_joint.hpp"
#include <cstdio>
using namespace cookbook::small_world;

int main()
{
  World world;
  add(world, box({0, -1, 0}, {20, 1, 20}, 0)); // the ground: no mass
  add(world, sphere({0, 4, 0}, 0.1, 0));       // the hook
  add(world, sphere({-3, 4, 0}, 0.4, 100));    // the ball, 3 m to the left of it
  for (int i = 0; i < 5; ++i)
    add(world, box({0.7, 0.2 + 0.4 * i, 0}, {0.2, 0.2, 0.2}, 1));
  std::vector<BallJoint> joints{ball_joint_at(world, 1, 2, {0, 4, 0})};
  for (int frame = 0; frame <= 180; ++frame, step_joined(world, joints, 1.0 / 60))
    if (frame % 30 == 0)
      std::printf(
          "%.1f s: ball at %5.2f m, topmost cube %5.2f m\n", frame / 60.0,
          world.bodies[2].motion.center.x(), world.bodies[7].motion.center.y());
}
// [example]
