/// \file
/// \brief A complete program: two spheres, their normal, depth and contact point.

// [example]
#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"

#include <iostream>

using namespace cookbook;

int main()
{
  const Sphere<double> a{{0, 0, 0}, 4};
  const Sphere<double> b{{2, 3, 6}, 5};
  std::cout.precision(4);
  if (const auto manifold = plain_sphere_sphere(a, b))
  {
    std::cout << "normal " << manifold->normal.transpose() << '\n'
              << "depth  " << manifold->depth << '\n'
              << "point  " << manifold->points[0].position.transpose() << '\n';
  }
}
// [example]
