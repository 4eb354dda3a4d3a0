/// \file
/// \brief A lamp of 2 kg on a spring of 1 Hz, let go a little too high.

// [example]
#include "05_resolution/small_world/small_body.hpp"
#include "07_constraints/springs/springs.hpp"
#include <cstdio>
using namespace cookbook;

int main()
{
  const double step = 1.0 / 60, gravity = 9.81;
  small_world::RigidBody hook = small_world::sphere({0, 3, 0}, 0.1, 0); // no mass: it stays
  small_world::RigidBody lamp = small_world::sphere({0, 2.5, 0}, 0.1, 2);
  const SpringCoefficients<double> spring = spring_coefficients(1.0, 0.1, step);
  const double load = load_speed(spring, 1.0, step, gravity);
  for (int frame = 1; frame <= 600; ++frame)
  {
    apply_spring<double>(hook, lamp, {hook.motion.center, lamp.motion.center}, 0.5, spring, load);
    lamp.motion.velocity.y() -= step * gravity;
    integrate_position(lamp, step);
    if (frame % 30 == 0 && (frame <= 120 || frame == 600))
      std::printf("%4.1f s: %.4f m\n", frame * step, lamp.motion.center.y());
  }
}
// [example]
