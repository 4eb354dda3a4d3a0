/// \file
/// \brief A cloth that falls on a sphere and stays there.

// [example]
#include "07_constraints/cloth/cloth.hpp"
#include <cstdio>
using namespace cookbook;

int main()
{
  Cloth cloth = make_cloth({.corner = {-0.5, 0.5, -0.5}});
  const Obstacles obstacles{.spheres = {{{0, 0, 0}, 0.4}}};
  for (int frame = 0; frame <= 120; ++frame)
  {
    const Vector3<double> middle = cloth.particles.positions[cloth.at(8, 8)];
    if (frame % 30 == 0)
      std::printf("%3d frames: middle %.2f m, ", frame, middle.norm());
    step_cloth(cloth, {.damping = 1, .substeps = 10}, obstacles);
    if (frame % 30 == 0)
      std::printf("corner at %.2f m\n", cloth.particles.positions[0].y());
  }
}
// [example]
