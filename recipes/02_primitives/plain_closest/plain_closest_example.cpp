/// \file
/// \brief Closest points of a triangle and of two segments.

// [example]
#include "02_primitives/plain_closest/plain_closest.hpp"

#include <iostream>

using namespace cookbook;

int main()
{
  const Triangle<double> roof{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  std::cout << "over the face: " << closest_on_triangle(roof, {1, 1, 3}).transpose() << '\n'
            << "beside an edge: " << closest_on_triangle(roof, {3, 3, 0}).transpose() << '\n'
            << "at a corner: " << closest_on_triangle(roof, {7, -1, 2}).transpose() << '\n';
  const Segment<double> beam{{-2, 0, 0}, {2, 0, 0}}, pole{{1, 3, -2}, {1, 3, 2}};
  const ClosestPoints<double, 3> between = closest_on_segments(beam, pole);
  std::cout << "beam: " << between.a.transpose() << ", pole: " << between.b.transpose()
            << ", distance: " << between.distance << '\n';
}
// [example]
