// Calls what the recipes on numbers and sums offer, those whose TAKE_… is defined. check_take.sh
// includes their headers: the house's, or one that was taken.

#include "calls.hpp"

using namespace cookbook;

int main()
{
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
        bits(sum_naive(all), sum_sorted(all), sum_pairwise(all), sum_wide(all));
        bits(sum_kahan(all), sum_neumaier(all), sum_compensated(all));
        RunningSum<double> running;
        running.add(numbers[0]);
        running.add(numbers[1]);
        bits(running.sum, running.lost);
      });
#endif
}
