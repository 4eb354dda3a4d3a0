/// \file
/// \brief A crate slides on a slab: what a solver knows of a point is found again by its feature.

// [example]
#include "04_obb_manifolds/feature_memory/feature_memory.hpp"

#include <iostream>

int main()
{
  using namespace cookbook;
  const Obb<double> slab{{0, 0, 0}, Matrix3<double>::Identity(), {2, 0.5, 2}};
  Obb<double> crate{{0.3, 0.99, 0.2}, Matrix3<double>::Identity(), {0.5, 0.5, 0.5}};
  ContactMemory<double, double> memory{}; // a number for each point: its impulse, say
  for (int frame = 0; frame < 3; ++frame)
  {
    crate.center.x() += 0.01;
    memory = next_frame(memory, slab, crate);
    std::cout << "frame " << frame << ": known " << memory.warm[0] << " N s, x "
              << memory.manifold->points[0].position.x() << " m\n";
    memory.warm[0] += 1; // what the solver found in this frame
  }
}
// [example]
