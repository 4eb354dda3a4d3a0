/// \file
/// \brief A complete program: the published depth beside the right one.

// [example]
#include "03_sphere_manifolds/sphere_methods/trial/sphere_methods.hpp"

#include <iostream>

using namespace cookbook;

int main()
{
  for (const float distance : {0.5f, 1.0f, 1.5f, 2.0f})
  {
    const Sphere<float> a{{0, 0, 0}, 1}, b{{distance, 0, 0}, 1};
    std::cout << distance << " apart: published " << sphere_sphere_as_published(a, b)->depth
              << ", plain " << plain_sphere_sphere(a, b)->depth << '\n';
  }
}
// [example]
