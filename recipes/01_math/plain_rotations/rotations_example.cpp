/// \file
/// Axis and angle, a quaternion and slerp, as a page shows them.

// [example]
#include "01_math/plain_rotations/plain_rotations.hpp"

#include <cstdio>

int main()
{
  using namespace cookbook;
  const double degree = 3.14159265358979 / 180;
  const Vector3<double> up(0, 1, 0), nose(0, 0, -1);
  const Vector3<double> turned = plain::rotated<double>(nose, up, 30 * degree);
  std::printf(
      "the nose after 30 degrees: (%.4f, %.4f, %.4f)\n", turned.x(), turned.y(), turned.z());

  const Quaternion<double> from = plain::quaternion_about<double>(up, 0.0);
  const Quaternion<double> to = plain::quaternion_about<double>(up, 90 * degree);
  const Quaternion<double> third = plain::slerp(from, to, 1.0 / 3);
  const plain::AxisAngle<double> turn = plain::axis_and_angle(third);
  std::printf("a third of a quarter turn: %.4f degrees about y\n", turn.angle / degree);
  std::printf("as a quaternion: %.4f + %.4f j\n", third.w(), third.y());
}
// [example]
