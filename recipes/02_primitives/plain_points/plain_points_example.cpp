/// \file
/// \brief A plane, a segment and a box, and a point.

// [example]
#include "02_primitives/plain_points/plain_points.hpp"

#include <iostream>

using namespace cookbook;

int main()
{
  const Plane<double> ground{{0, 1, 0}, 0};
  const Segment<double> rope{{0, 0, 0}, {8, 6, 0}};
  const Obb<double> crate{{0, 1, 0}, Matrix3<double>::Identity(), {2, 1, 1}};
  const Vector3<double> p(7, -1, 0);
  std::cout << "above the ground: " << signed_distance(ground, p) << '\n'
            << "closest on the rope: " << closest_point(rope, p).transpose() << '\n'
            << "closest on the crate: " << closest_on_box(crate, p).transpose() << '\n';
}
// [example]
