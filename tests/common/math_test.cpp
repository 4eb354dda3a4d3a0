/// \file
/// What holds for the shared mathematics.

#include "common/math/norm.hpp"
#include "common/math/rotation.hpp"
#include "common/math/ulp.hpp"
#include "common/math/wide.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <limits>

using namespace cookbook;

TEST_CASE("the quaternion 1 + 2i splits (3-4-5) into a turn with cosine -3/5, sine 4/5", "[math]")
{
  const Matrix3<Rational> r = rational_rotation<Rational>(1, 2, 0, 0);
  Matrix3<Rational> expected;
  expected << Rational(1), Rational(0), Rational(0), Rational(0), Rational(-3, 5), Rational(-4, 5),
      Rational(0), Rational(4, 5), Rational(-3, 5);
  CHECK(r == expected);
}

TEST_CASE("every rotation by a small whole quaternion is exactly a rotation", "[math]")
{
  for (int w = -2; w <= 2; ++w)
  {
    for (int x = -2; x <= 2; ++x)
    {
      for (int y = -2; y <= 2; ++y)
      {
        const Matrix3<Rational> r = rational_rotation<Rational>(w, x, y, 1);
        CHECK(r * r.transpose() == Matrix3<Rational>::Identity());
        CHECK(r.determinant() == 1);
      }
    }
  }
}

TEST_CASE("a rotation by a whole quaternion is the one that Eigen makes of it", "[math]")
{
  const Quaternion<double> q(1, 2, 3, 4);
  const Matrix3<double> ours = rational_rotation<double>(1, 2, 3, 4);
  // Two roundings an entry.
  CHECK((ours - q.normalized().toRotationMatrix()).cwiseAbs().maxCoeff() <= 1e-15);
}

TEST_CASE("a sheared matrix is 0.1 from a rotation, a mirror is 2", "[math]")
{
  Matrix3<double> sheared = Matrix3<double>::Identity();
  sheared(0, 1) = 0.1;
  CHECK(rotation_error(sheared) == Catch::Approx(0.1));
  CHECK(rotation_error<double>(-Matrix3<double>::Identity()) == 2);
  CHECK(rotation_error<double>(Matrix3<double>::Identity()) == 0);
  CHECK(rotation_error<double>(Matrix3<double>::Identity() / 2) == 0.75); // a quarter, not one
  CHECK(rotation_error<double>(Matrix3<double>::Zero()) == 1);            // nor a mirror
}

TEST_CASE("the ulp of 1 is 2^-23 in float, whatever the sign", "[math]")
{
  CHECK(ulp(1.0f) == std::ldexp(1.0f, -23));
  CHECK(ulp(-1.0f) == std::ldexp(1.0f, -23));
  CHECK(ulp(0.0f) == std::numeric_limits<float>::denorm_min());
}

TEST_CASE("a float is widened to double, and a double stays one", "[math]")
{
  STATIC_REQUIRE(std::is_same_v<Wide<float>, double>);
  STATIC_REQUIRE(std::is_same_v<Wide<double>, double>);
  CHECK(widen(Vector3<float>(0.1f, 2, 3)).x() == static_cast<double>(0.1f));
}

TEMPLATE_TEST_CASE(
    "a vector times a power of two has the same direction bits", "[math]", float, double)
{
  // The smallest squares would lose digits, the largest of them would not.
  const int exponent = std::numeric_limits<TestType>::min_exponent / 2 + 1;
  for (int i = 1; i <= 100; ++i)
  {
    const Vector3<TestType> v(1, TestType(i) / 301, TestType(i) / 7001);
    const Vector3<TestType> small = v * std::ldexp(TestType(1), exponent);
    CHECK(normalize(small).unit == normalize(v).unit);
    CHECK(normalize(small).length == std::ldexp(normalize(v).length, exponent));
  }
}
