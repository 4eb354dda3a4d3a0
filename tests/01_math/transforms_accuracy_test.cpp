/// \file
/// Normals and points of every size through transforms of every size.

#include "01_math/transforms/transforms.hpp"
#include "01_math/truth/trial/whole_range.hpp"
#include "common/math/rotation.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace cookbook;

// [whole_range_normal]
TEMPLATE_TEST_CASE(
    "100,000 normals through matrices of all sizes: of length one, perpendicular to what was in "
    "the plane",
    "[M14]", float, double)
{
  using V = Vector3<TestType>;
  const double u = std::numeric_limits<TestType>::epsilon() / 2.0;
  WholeRange<TestType> random;
  int unlike_one = 0, leaning = 0;
  for (int i = 0; i < 100000; ++i)
  {
    // Powers of two on a turn by 3-4-5 about z: its cofactors are known by hand.
    const int most = std::numeric_limits<TestType>::max_exponent - 4;
    const int a = random.drawn(-most, most), b = random.drawn(-most, most);
    const TestType c = TestType(0.8), s = TestType(0.6), x = std::ldexp(TestType(1), a);
    const TestType z = std::ldexp(TestType(1), b);
    Matrix3<TestType> m;
    m << c * x, -s * x, 0, s * x, c * x, 0, 0, 0, z;
    const TestType p = random.fraction(), q = random.fraction();
    const V n(p, q, TestType(0.5));
    const V answer = transformed_normal<TestType>(m, n);
    unlike_one += std::abs(answer.norm() - 1) <= 8 * u ? 0 : 1;
    // The exact direction is (z(cp - sq), z(sp + cq), x/2): compared by ratios that fit.
    const long double back = (long double)(c)*c + (long double)(s)*s;
    const long double ratio = std::ldexp(1.0L, b - a), half = 0.5L * back;
    const long double ex = ratio * ((long double)(c)*p - (long double)(s)*q);
    const long double ey = ratio * ((long double)(s)*p + (long double)(c)*q);
    const long double length = std::hypot(ex, ey, half);
    const long double off = std::max(
        {std::abs(answer.x() - ex / length), std::abs(answer.y() - ey / length),
         std::abs(answer.z() - half / length)});
    leaning += off <= 16 * u ? 0 : 1;
  }
  CHECK(unlike_one == 0);
  CHECK(leaning == 0);
}
// [whole_range_normal]

// [whole_range_pose]
TEMPLATE_TEST_CASE(
    "100,000 points to a body's frame and back: within 12 roundings of their sizes", "[M15]", float,
    double)
{
  using V = Vector3<TestType>;
  const TestType u = std::numeric_limits<TestType>::epsilon() / 2;
  WholeRange<TestType> random;
  int off = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const Matrix3<TestType> r =
        rational_rotation<TestType>(1 + i % 5, random.drawn(-9, 9), 3, random.drawn(-9, 9));
    const V t = random.even_vector() / 8, p = random.even_vector() / 8;
    const Isometry3<TestType> there = pose<TestType>(r, t);
    const V local = to_local<TestType>(there, p), by_inverse = rigid_inverse<TestType>(there) * p;
    // The scale is a power of two: the sum of the sizes need not fit.
    const TestType size = p.cwiseAbs().maxCoeff() + t.cwiseAbs().maxCoeff();
    const TestType bound = 24 * u * size + 8 * std::numeric_limits<TestType>::denorm_min();
    off += (there * local - p).cwiseAbs().maxCoeff() <= bound ? 0 : 1;
    off += (local - by_inverse).cwiseAbs().maxCoeff() <= bound ? 0 : 1;
  }
  CHECK(off == 0);
}
// [whole_range_pose]
