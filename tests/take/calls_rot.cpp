// Calls what the recipes of rotations and turning offer, those whose TAKE_… is defined.
// check_take.sh includes their headers: the house's, or one that was taken.

#include "calls.hpp"

using namespace cookbook;

int main()
{
#ifdef TAKE_rotations
  print(
      "rotations",
      [](Draw& draw, Bits& bits)
      {
        const double scale = draw.scale(), angle = draw.number(-7, 7), share = draw.number(-1, 2);
        const Eigen::Vector3d v = draw.vector(2) * scale, n = draw.unit();
        const Eigen::Quaterniond a = draw.orientation(), b = draw.orientation();
        const Eigen::Quaterniond large(Eigen::Vector4d(a.coeffs() * scale));
        const Eigen::Matrix3d r = rotation_about(v, angle);
        const EulerAngles<double> angles = euler_angles(r);
        bits(r, angles.heading, angles.pitch, angles.roll, from_euler_angles(angles));
        bits(quaternion_of(r), rotation_matrix(large), unit_quaternion(large), rotation_error(r));
        bits(product(a, b), dot(a, b), turned_vector(a, v));
        bits(slerp(large, b, share), nlerp(large, b, share));
        bits(rotation_between<double>(v, n), rotation_between<double>(n, -n));
        bits(rotation_between<double>(n, 1e-9 * v - n));
      });
#endif
#ifdef TAKE_turning
  print(
      "turning",
      [](Draw& draw, Bits& bits)
      {
        const double scale = draw.scale(), step = draw.number(0, 1);
        const Eigen::Vector3d spin = draw.vector(9) * scale;
        const Eigen::Quaterniond a = draw.orientation(), b = draw.orientation();
        bits(turned_by(a, spin, step), rotation_by(spin), turn_between(a, b));
        const HalfTurn<double> half = half_turn(draw.number(-9, 9));
        bits(half.cosine, half.sine);
      });
#endif
}
