/// \file
/// \brief A crate turned on a slab, over its edge: where edges of one box pass faces of the other.

// [example]
#include "04_obb_manifolds/edge_clipping/edge_clipping.hpp"
#include <iostream>

int main()
{
  using namespace cookbook;
  Matrix3<double> turned;
  turned << 0.8, 0, 0.6, 0, 1, 0, -0.6, 0, 0.8;
  const Obb<double> slab{{0, 0, 0}, Matrix3<double>::Identity(), {1.2, 0.3, 1}};
  const Obb<double> crate{{0.8, 0.7, 0.2}, turned, {0.5, 0.5, 0.5}};
  if (const auto manifold = edge_clipping(slab, crate))
  {
    std::cout << "normal " << manifold->normal.transpose() << ", depth " << manifold->depth << "\n";
    for (const ContactPoint<double>& point : manifold->points)
    {
      std::cout << point.position.transpose() << "\n";
    }
  }
}
// [example]
