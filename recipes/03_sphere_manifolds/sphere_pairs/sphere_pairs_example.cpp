/// \file
/// \brief A complete program: three pairs of spheres in one call.

// [example]
#include "03_sphere_manifolds/sphere_pairs/sphere_pairs.hpp"

#include <cmath>
#include <iostream>

using namespace cookbook;

int main()
{
  const Sphere<float> a{{0, 0, 0}, 1};
  const Lists pairs =
      lists_of_pairs({{a, {{1.5f, 0, 0}, 1}}, {a, {{0, 1.75f, 0}, 1}}, {a, {{3, 0, 0}, 1}}});
  Lists results = lists_of_overlaps(3);
  const SphereOverlaps overlaps = overlaps_of(results);
  sphere_pairs(pairs_of(pairs), overlaps);
  for (const float depth : overlaps.depth)
  {
    std::cout << (depth < 0 ? "apart by " : "overlap of ") << std::abs(depth) << '\n';
  }
}
// [example]
