/// \file
/// \brief A lift of 50 kg whose motor can push by 1 % more than its weight.

// [example]
#include "06_world/game_world/solvers.hpp"
#include "07_constraints/slider/slider.hpp"
#include <cstdio>
using namespace cookbook;

int main()
{
  const SceneBody shaft{.name = "shaft", .shape = BoxShape{{0.1, 5, 0.1}}};
  SceneBody lift{.name = "lift", .shape = BoxShape{{0.5, 1, 0.5}}, .mass = 50};
  lift.position = {0.7, 0, 0};
  GameWorld world({.bodies = {shaft, lift}}, solver_named("direct"));
  SliderJoint slider = slider_at(world, 0, 1, {0.7, 0, 0}, {0, 1, 0});
  slider.drive.motor_speed = 1, slider.drive.motor_force = 1.01 * 50 * 9.81;
  SliderJoints sliders;
  sliders.add(slider);
  world.add(sliders);
  for (int frame = 0; frame < 120; ++frame)
    world.step();
  std::printf("%.4f m\n", slider_position(slider, world.body(0), world.body(1)));
}
// [example]
