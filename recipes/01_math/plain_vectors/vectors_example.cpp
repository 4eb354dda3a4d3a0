/// \file
/// Dot and cross product, projection, reflection and lerp, as a page shows them.

// [example]
#include "01_math/plain_vectors/plain_vectors.hpp"

#include <cstdio>

int main()
{
  using namespace cookbook;
  const Vector3<double> look(0, 0, -1), player(3, 0, -4); // from the guard, who looks along -z
  std::printf("ahead: %.1f m\n", player.dot(look));
  std::printf("side: %s\n", look.cross(player).y() > 0 ? "left" : "right");

  const Vector3<double> velocity(3, -4, 0), floor(0, 1, 0);
  const Vector3<double> along = plain::project(velocity, floor);
  const Vector3<double> after = plain::reflect(velocity, floor);
  std::printf("into the floor: y = %.1f\n", along.y());
  std::printf("after the bounce: (%.1f, %.1f, %.1f)\n", after.x(), after.y(), after.z());

  const Vector3<double> third = plain::lerp<double>({0, 0, 0}, {3, 6, 0}, 1.0 / 3);
  std::printf("a third of the way: (%.1f, %.1f, %.1f)\n", third.x(), third.y(), third.z());
}
// [example]
