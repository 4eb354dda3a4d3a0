/// \file
/// \brief A complete program: two spheres far from the origin, in world and in relative
/// coordinates.

// [example]
#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"

#include <iostream>

using namespace cookbook;

int main()
{
  const Vector3<double> a(1e6, 1e6, 1e6), b(1e6 + 0.99, 1e6, 1e6); // radii 0.5: 0.01 deep
  const auto world = plain_sphere_sphere<float>({a.cast<float>(), 0.5f}, {b.cast<float>(), 0.5f});
  const Vector3<float> a_to_b = (b - a).cast<float>(); // subtracted in double
  const auto relative = plain_sphere_sphere<float>({{0, 0, 0}, 0.5f}, {a_to_b, 0.5f});
  std::cout.precision(4);
  std::cout << "world coordinates    " << world->depth << '\n'
            << "relative coordinates " << relative->depth << '\n';
}
// [example]
