/// \file
/// \brief Any two shapes by three names.

// [example]
#include "02_primitives/casts/casts.hpp"
#include "02_primitives/overlaps/overlaps.hpp"

#include <iostream>

using namespace cookbook;

int main()
{
  const Sphere<float> ball{{0, 4, 0}, 1};
  const Capsule<float> pill{{{-1, 0, 0}, {1, 0, 0}}, 1};
  std::cout << "overlap: " << overlaps(ball, pill) << '\n'
            << "distance: " << closest_points(ball, pill).distance << '\n';
  const Ray<float> down{{0, 8, 0}, {0, -1, 0}};
  std::cout << "the ray meets the ball at t = " << cast(down, ball)->t << '\n'
            << "and the pill at t = " << cast(down, pill)->t << '\n';
}
// [example]
