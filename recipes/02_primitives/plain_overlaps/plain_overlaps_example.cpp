/// \file
/// \brief Spheres and boxes that overlap or do not.

// [example]
#include "02_primitives/plain_overlaps/plain_overlaps.hpp"

#include <iostream>

using namespace cookbook;

int main()
{
  using V = Vector3<double>;
  const Sphere<double> ball{{0, 2, 0}, 1}, other{{0, 3.5, 0}, 1};
  const Aabb<double> crate(V(-1, -1, -1), V(1, 1, 1)), shelf(V(1.5, -1, -1), V(3, 1, 1));
  const Matrix3<double> turned{{0.8, -0.6, 0}, {0.6, 0.8, 0}, {0, 0, 1}};
  const Obb<double> box{{0, 0, 0}, Matrix3<double>::Identity(), {1, 1, 1}};
  const Obb<double> diamond{{1.9, 1.9, 0}, turned, {1, 1, 1}};
  std::cout << "sphere, sphere: " << spheres_overlap(ball, other) << '\n'
            << "AABB, AABB: " << aabbs_overlap(crate, shelf) << '\n'
            << "sphere, AABB: " << sphere_aabb_overlap(ball, crate) << '\n'
            << "OBB, OBB: " << obbs_overlap(box, diamond) << '\n';
}
// [example]
