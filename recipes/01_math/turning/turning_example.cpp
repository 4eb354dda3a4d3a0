/// \file
/// A spinning body for a second, as a page shows it.

// [example]
#include "01_math/plain_rotations/plain_rotations.hpp"

#include <cstdio>

int main()
{
  using namespace cookbook;
  const Vector3<double> spin(0, 2, 0); // [rad/s]
  for (const int rate : {10, 60})
  {
    Quaternion<double> q = Quaternion<double>::Identity();
    for (int frame = 0; frame < rate; ++frame)
    {
      q = plain::turned_by<double>(q, spin, 1.0 / rate);
    }
    const plain::AxisAngle<double> turn = plain::axis_and_angle(q);
    std::printf("%d frames: %.4f rad, axis y = %.1f\n", rate, turn.angle, turn.axis.y());
  }
}
// [example]
