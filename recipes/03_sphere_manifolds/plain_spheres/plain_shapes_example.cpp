/// \file
/// \brief A complete program: one sphere against the ground, a capsule and a box.

// [example]
#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"

#include <iostream>

using namespace cookbook;

int main()
{
  const Sphere<double> ball{{0, 1, 0}, 1.25};
  const Plane<double> ground{{0, 1, 0}, 0};
  const Capsule<double> beam{{{1.5, 0, -2}, {1.5, 0, 2}}, 1};
  const Obb<double> crate{{-2, 0, 0}, Matrix3<double>::Identity(), {1, 1, 1}};
  std::cout.precision(3);
  for (const auto& m :
       {plain_sphere_plane(ball, ground), plain_sphere_capsule(ball, beam),
        plain_sphere_box(ball, crate)})
  {
    const Vector3<double> moved = ball.center - m->depth * m->normal;
    std::cout << "depth " << m->depth << ", out at " << moved.transpose() << '\n';
  }
}
// [example]
