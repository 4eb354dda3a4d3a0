/// \file
/// A point to the world and back, and a normal, as a page shows them.

// [example]
#include "01_math/transforms/plain_transforms.hpp"

#include <cstdio>

int main()
{
  using namespace cookbook;
  Matrix3<double> turn, stretch; // a quarter about y; three times as wide
  turn << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  stretch << 3, 0, 0, 0, 1, 0, 0, 0, 1;
  const Isometry3<double> crate = pose<double>(turn, {5, 0, 0});
  const Vector3<double> corner(0, 0, 2), world = crate * corner, local = to_local(crate, world);
  std::printf("in the world: (%.1f, %.1f, %.1f)\n", world.x(), world.y(), world.z());
  std::printf("in the crate: (%.1f, %.1f, %.1f)\n", local.x(), local.y(), local.z());

  const Vector3<double> ramp(-1, 1, 0), n = plain::transformed_normal<double>(stretch, ramp);
  std::printf("normal of the stretched ramp: (%.4f, %.4f, %.4f)\n", n.x(), n.y(), n.z());
}
// [example]
