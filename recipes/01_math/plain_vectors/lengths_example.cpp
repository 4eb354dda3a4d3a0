/// \file
/// Length, direction, angle and damping, as a page shows them.

// [example]
#include "01_math/plain_vectors/plain_vectors.hpp"

#include <cstdio>

int main()
{
  using namespace cookbook;
  const Vector3<double> v(2, 3, 6), up(0, 1, 0);
  const Vector3<double> unit = plain::normalize(v);
  std::printf("length: %.1f\n", plain::length(v));
  std::printf("direction: (%.4f, %.4f, %.4f)\n", unit.x(), unit.y(), unit.z());
  std::printf("angle with up: %.4f rad\n", plain::angle(v, up));

  for (const int rate : {30, 144}) // a camera that follows at 2 / s, for a second
  {
    Vector3<double> camera(0, 0, 0);
    for (int frame = 0; frame < rate; ++frame)
    {
      camera = plain::damp<double>(camera, v, 2, 1.0 / rate);
    }
    std::printf("%d frames a second: x = %.4f\n", rate, camera.x());
  }
}
// [example]
