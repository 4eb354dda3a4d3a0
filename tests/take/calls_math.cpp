// Calls what the recipes of chapter 1 offer, those whose TAKE_… is defined. check_take.sh includes
// their headers: the house's, or one that was taken.

#include "calls.hpp"

#include <span>

using namespace cookbook;

namespace
{

#if defined(TAKE_matrices) || defined(TAKE_transforms)
/// A matrix of any size; every eighth has two equal columns.
Eigen::Matrix3d drawn_matrix(Draw& draw)
{
  Eigen::Matrix3d m;
  m << draw.vector(1), draw.vector(1), draw.vector(1);
  if (draw.one_in(8))
  {
    m.col(2) = m.col(0);
  }
  return m * draw.scale();
}
#endif

} // namespace

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
#ifdef TAKE_normalize
  print(
      "normalize",
      [](Draw& draw, Bits& bits)
      {
        const double scale = draw.scale();
        const Eigen::Vector3d v = draw.vector(2) * scale;
        bits(normalize(v), normalize_naive(v), normalize_threshold(v), normalize_wide(v));
        bits(normalize_hypot(v));
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
        bits(plain::angle(a, b), angle_acos(a, b), angle_clamped(a, b), angle_kahan(a, b));
        bits(equal_within_roundings(a, b, 1.0));
      });
#endif
#ifdef TAKE_matrices
  print(
      "matrices",
      [](Draw& draw, Bits& bits)
      {
        const Eigen::Matrix3d m = drawn_matrix(draw);
        bits(inverse<double, 3>(m), determinant<double, 3>(m), cofactors<double>(m));
        bits(permanent<double>(m), condition<double, 3>(m), adjugate_inverse<double, 3>(m));
        Eigen::Matrix4d larger = Eigen::Matrix4d::Identity();
        larger.topLeftCorner<3, 3>() = m;
        larger.topRightCorner<3, 1>() = draw.vector(10);
        bits(inverse<double, 4>(larger), determinant<double, 4>(larger), cofactors<double>(larger));
      });
#endif
#ifdef TAKE_transforms
  print(
      "transforms",
      [](Draw& draw, Bits& bits)
      {
        const Eigen::Vector3d move = draw.vector(10), point = draw.vector(10), n = draw.unit();
        const Isometry3<double> there = pose<double>(draw.axes(), move);
        bits(rigid_inverse<double>(there).matrix(), to_local<double>(there, point));
        Affine3<double> t = Affine3<double>::Identity();
        t.linear() = drawn_matrix(draw);
        t.translation() = move;
        const Eigen::Matrix3d m = t.linear();
        bits(to_local<double>(t, point), transformed_normal<double>(m, n));
        bits(transformed_plane<double>(t, Hyperplane3<double>(n, 2)).coeffs());
        const Eigen::Matrix4d all = t.matrix();
        bits(hand_exchanged<double>(all), rows_and_columns_exchanged<double>(all));
        bits(y_up_from_z_up<double>());
      });
#endif
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
#ifdef TAKE_numbers
  print(
      "numbers",
      [](Draw& draw, Bits& bits)
      {
        const double scale = draw.scale();
        const Eigen::Vector3d v = draw.vector(2) * scale, w = draw.vector(2) * scale;
        const Bounded<double> dot = bounded_dot<double, 3>(v, w);
        bits(dot.value, dot.error, is_sign_certain(dot), rounding_bound<double>(3));
        bits(equal_to_rounding(v.x(), w.x(), v.norm(), 4));
        bits(difference_naive(v.x(), v.y(), w.x(), w.y()));
        bits(difference_fused(v.x(), v.y(), w.x(), w.y()), accurate_cross(v, w));
        const Interval<double> a = hull(hull(empty_interval<double>(), v.x()), v.y());
        const Interval<double> b = intersection(a, {w.x(), w.y()});
        bits(a.least, a.most, b.least, b.most, is_empty(b), interval_overlap(a, b));
        bits(clamp(w.z(), b), wrap_degrees(1000 * v.z()), wrap_radians(v.z()));
      });
#endif
#ifdef TAKE_sums
  print(
      "sums",
      [](Draw& draw, Bits& bits)
      {
        double numbers[40];
        for (double& one : numbers)
        {
          one = draw.number(-1, 1) * draw.scale();
        }
        const std::span<const double> all(numbers);
        bits(sum_naive(all), sum_pairwise(all), sum_wide(all));
        bits(sum_kahan(all), sum_compensated(all));
        RunningSum<double> running;
        running.add(numbers[0]);
        running.add(numbers[1]);
        bits(running.sum, running.lost);
      });
#endif
}
