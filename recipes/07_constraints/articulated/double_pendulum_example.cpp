/// \file
/// \brief A double pendulum that swings for a minute, by its two angles.

// [example]
#include "05_resolution/integrators/integrators.hpp"
#include "07_constraints/articulated/double_pendulum.hpp"
#include <cstdio>
using namespace cookbook;

int main()
{
  const SwingingLink rod{.mass = 1, .moment = 0.02, .center = 0.25, .length = 0.5};
  const DoublePendulum pendulum{rod, rod};
  const auto accelerations = [&](const Vector2<double>& angles, const Vector2<double>& speeds)
  { return angular_accelerations(pendulum, angles, speeds); };
  PhasePoint<Vector2<double>> at{{1, 1}, {0, 0}};
  std::printf("energy %.6f J\n", energy(pendulum, at.position, at.velocity));
  for (int step = 0; step < 60 * 240; ++step)
    at = rk4(at, 1 / 240.0, accelerations);
  std::printf("energy %.6f J a minute later\n", energy(pendulum, at.position, at.velocity));
}
// [example]
