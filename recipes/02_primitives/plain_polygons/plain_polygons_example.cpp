/// \file
/// \brief Three convex polygons, two of which do not overlap.

// [example]
#include "02_primitives/plain_polygons/plain_polygons.hpp"

#include <iostream>

using namespace cookbook;

int main()
{
  const Polygon<double> crate{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const Polygon<double> wedge{{3, 2}, {3, 4}, {1, 4}};
  const Polygon<double> ramp{{3, 0}, {3, 4}, {1, 4}};
  std::cout << "crate, wedge: " << polygons_overlap(crate, wedge) << '\n'
            << "crate, ramp: " << polygons_overlap(crate, ramp) << '\n'
            << "wedge, ramp: " << polygons_overlap(wedge, ramp) << '\n';
}
// [example]
