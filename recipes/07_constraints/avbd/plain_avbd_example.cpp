/// \file
/// \brief A cable of particles settles by augmented vertex block descent.

// [example]
#include "07_constraints/avbd/plain_avbd.hpp"
#include "07_constraints/rope/rope.hpp"
#include <cstdio>
using namespace cookbook;

int main()
{
  Rope cable = make_rope({0, 0, 0}, {8, 0, 0}, 40, 10);
  for (DistanceConstraint& link : cable.links)
    link.length = 0.25; // 10 m between poles 8 m apart
  cable.particles.inverse_masses[0] = cable.particles.inverse_masses[40] = 0;
  std::vector<AvbdMemory> memories;
  for (int frame = 0; frame < 1200; ++frame)
    step_plain_avbd(cable.particles, cable.links, memories, {.damping = 2, .iterations = 50});
  std::printf("it sags by %.2f m, right is 2.66 m\n", -cable.particles.positions[20].y());
}
// [example]
