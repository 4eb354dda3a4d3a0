/// \file
/// \brief A cable of 10 m between two hooks 8 m apart, by XPBD.

// [example]
#include "07_constraints/rope/rope.hpp"
#include <cstdio>
using namespace cookbook;

int main()
{
  Rope rope = make_rope({-4, 0, 0}, {6, 0, 0}, 40, 10);
  rope.particles.positions[40].x() = 4;
  rope.particles.inverse_masses[0] = rope.particles.inverse_masses[40] = 0;
  for (int frame = 0; frame < 900; ++frame)
    step_xpbd(rope.particles, rope.links, {.damping = 4, .substeps = 30});
  std::printf("sag %.4f m, right is 2.6553 m\n", -rope.particles.positions[20].y());
}
// [example]
