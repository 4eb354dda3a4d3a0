/// \file
/// \brief A rope of springs that holds with four substeps a frame and explodes with three.

// [example]
#include "07_constraints/rope/rope.hpp"
#include <cstdio>
using namespace cookbook;

int main()
{
  Rope rope = make_rope({0, 0, 0}, {5, 0, 0}, 20, 5, 1e-4); // springs of 10,000 N/m
  rope.particles.inverse_masses[0] = 0;
  for (int frame = 0; frame < 30; ++frame)
    step_mass_spring(rope.particles, rope.links, {.substeps = 4});
  std::printf("4 substeps: end at %.2f m\n", rope.particles.positions[20].y());
  for (int frame = 0; frame < 16; ++frame)
    step_mass_spring(rope.particles, rope.links, {.substeps = 3});
  std::printf("3 substeps: end at %.0f m\n", rope.particles.positions[20].y());
}
// [example]
