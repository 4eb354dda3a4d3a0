// Calls what the recipes of chapter 1 on vectors, lengths and angles offer, those whose TAKE_… is
// defined. check_take.sh includes their headers: the house's, or one that was taken.

#include "calls.hpp"

using namespace cookbook;

int main()
{
#ifdef TAKE_vectors
  print(
      "vectors",
      [](Draw& draw, Bits& bits)
      {
        const double of_a = draw.scale(), of_b = draw.scale(), share = draw.number(0, 1);
        const Eigen::Vector3d a = draw.vector(2) * of_a, b = draw.vector(2) * of_b;
        bits(project(a, b), reject(a, b), reflect(a, b), reflect_unit(a, draw.unit()));
        bits(lerp(a, b, share), length(a), accurate_cross(a, b));
      });
#endif
#ifdef TAKE_angles
  print(
      "angles",
      [](Draw& draw, Bits& bits)
      {
        const double scale = draw.scale(), fineness = draw.number(0, 60);
        const Eigen::Vector3d a = draw.vector(2) * scale, axis = draw.unit();
        const double tilt = std::ldexp(draw.number(-1, 1), -static_cast<int>(fineness));
        const Eigen::Vector3d b =
            draw.one_in(2) ? draw.vector(2) : Eigen::Vector3d(a + tilt * axis);
        bits(angle(a, b), signed_angle(a, b, axis), accurate_cross(a, b));
        bits(angle_atan2(a, b), angle_acos(a, b), angle_clamped(a, b), angle_kahan(a, b));
        bits(equal_within_roundings(a, b, 1.0));
      });
#endif
}
