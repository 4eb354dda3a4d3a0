/// \file
/// What holds for angles: formula M5, the pairs of vectors that break a way to find one, and
/// comparisons of vectors.

#include "01_math/angles/angles.hpp"
#include "01_math/angles/trial/angles_cases.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <cmath>
#include <limits>

using namespace cookbook;

namespace
{

constexpr double pi = 3.14159265358979324;

/// The error of an angle in roundings of itself.
template <class Real>
double roundings(Real answer, long double truth)
{
  const long double roundoff = std::numeric_limits<Real>::epsilon() / Real(2);
  return static_cast<double>(
      std::abs(static_cast<long double>(answer) - truth) / (roundoff * truth));
}

} // namespace

// [M5]
TEMPLATE_TEST_CASE(
    "(1,0,0) and (±1,t,0) are atan(t) and π - atan(t) apart, for t from 2^-120 to 2^120", "[M5]",
    float, double)
{
  for (int exponent = -120; exponent <= 120; ++exponent)
  {
    const TestType t = std::ldexp(TestType(1), exponent);
    const long double truth = std::atan(static_cast<long double>(t));
    const long double straight = 3.14159265358979323846L;
    CHECK(roundings(angle(Vector3<TestType>(1, 0, 0), {1, t, 0}), truth) <= 12);
    CHECK(roundings(angle(Vector3<TestType>(1, 0, 0), {-1, t, 0}), straight - truth) <= 12);
  }
}

TEST_CASE("vectors 1e-8 apart, and 1e-8 short of opposite, in double", "[M5]")
{
  // atan x = x - x³/3, and x³ is far below the last digit here.
  const Vector3<double> a(1, 0, 0), b(1, 1e-8, 0);
  CHECK(angle(a, b) == Catch::Approx(1e-8).epsilon(1e-15));
  CHECK(angle(a, Vector3<double>(-1, 1e-8, 0)) == Catch::Approx(pi - 1e-8).epsilon(1e-15));
}
// [M5]

TEST_CASE(
    "an angle that is far below the vectors' smallest digits: 7e-309/3e-16, in double", "[M5]")
{
  // For such an angle θ = tan θ, to rounding; the quotient of the components is right to 2u.
  const double across = 7e-309;
  CHECK(
      angle<double>({3e-16, 0, 0}, {3e-16, across, 0}) ==
      Catch::Approx(across / 3e-16).epsilon(1e-15));
  CHECK(
      angle<double>({3e-16, 0, 0}, {3e-16, 5e-308, 0}) ==
      Catch::Approx(5e-308 / 3e-16).epsilon(1e-15));
  CHECK(angle<double>({3, 0, 0}, {3, 5e-292, 0}) == Catch::Approx(5e-292 / 3).epsilon(1e-15));
}

TEST_CASE("half a turn seen against its axis is -π, though parts of it are tiny", "[M5]")
{
  const Vector3<float> a(-9.87707205215988e37f, 0, 0),
      axis(2.8e-45f, 6.0007749880242045e-09f, 1.01e-26f);
  const Vector3<float> b(2.7038599401784463e37f, -9.799961220955066e-33f, -7.521185794771175e-36f);
  // a × b = (0, a_x·(-b_z), a_x·b_y): its y component is negative, and so is axis·(a × b).
  CHECK(signed_angle(a, b, axis) < -3);
}

// [A3]
TEST_CASE(
    "vectors of floats 1e-4 apart: 1e-4 within 1e-8, where the arc cosine says 0", "[case:A3]")
{
  const Vector3<float> a(1, 0, 0), b = turned_by_half_tangent<float>(0.5e-4);
  CHECK(angle_acos(a, b) == 0);
  CHECK(angle_clamped(a, b) == 0);
  CHECK(angle(a, b) == Catch::Approx(1e-4).margin(1e-8));
}
// [A3]

TEST_CASE(
    "of 729 vectors and three times each, acos is not a number for some, clamped for none", "[M5]")
{
  int acos_nan = 0, clamped_nan = 0, beyond_one = 0;
  for (int i = 0; i < 729; ++i)
  {
    const Vector3<float> a =
        Vector3<int>(1001 + i % 9, 1011 + i / 9 % 9, 1021 + i / 81).cast<float>();
    const Vector3<float> b = 3 * a;
    acos_nan += std::isnan(angle_acos(a, b)) ? 1 : 0;
    beyond_one += a.normalized().dot(b.normalized()) > 1 ? 1 : 0;
    beyond_one += a.normalized().dot(-b.normalized()) < -1 ? 1 : 0;
    clamped_nan +=
        std::isnan(angle_clamped(a, b)) || std::isnan(angle_clamped<float>(a, -b)) ? 1 : 0;
    CHECK(angle_clamped<float>(a, -b) > 3.14f);
  }
  CHECK(acos_nan > 0);
  CHECK(beyond_one > 1);
  CHECK(clamped_nan == 0);
}

// [signed]
TEMPLATE_TEST_CASE("about z, x to y is a right angle and y to x minus one", "[M5]", float, double)
{
  using Three = Vector3<TestType>;
  const Three x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const TestType right = static_cast<TestType>(pi / 2);
  for (const TestType size : {TestType(1e-38), TestType(1), TestType(1e38)})
  {
    CHECK(signed_angle<TestType>(x * size, y, z) == right);
    CHECK(signed_angle<TestType>(y, x * size, z) == -right);
    CHECK(signed_angle<TestType>(x, y, -z * size) == -right);
    CHECK(signed_angle<TestType>(x, y, Three(1, 1, 1) * size) == right);
  }
  // No side to turn to: opposite, equal, a zero vector, an axis in the plane.
  const TestType tiny = std::numeric_limits<TestType>::denorm_min();
  CHECK(signed_angle<TestType>(x, Three(1, tiny, 0), z) == tiny);
  CHECK(signed_angle<TestType>(Three(1, 7 * tiny, 2 * tiny), x, {0, -1, -3}) == 7 * tiny);
  // a × b is 1.5 (0, -1, 3) tiny, and rounded it would be on the other side of the axis.
  CHECK(signed_angle<TestType>({TestType(1.5), 0, 0}, {1, 3 * tiny, tiny}, {0, 5, 2}) > 0);
  CHECK(signed_angle<TestType>(x, -x, z) == static_cast<TestType>(pi));
  CHECK(signed_angle<TestType>(x, x, z) == 0);
  CHECK(signed_angle<TestType>(Three(0, 0, 0), y, z) == 0);
  CHECK(signed_angle<TestType>(x, y, Three(0, 0, 0)) == right);
  CHECK(signed_angle<TestType>(y, x, Three(1, 0, 0)) == right);
}
// [signed]

// [zero]
TEMPLATE_TEST_CASE("the angle with a zero vector of any signs is 0", "[degenerate]", float, double)
{
  const TestType none = 0;
  for (const TestType zero : {none, -none})
  {
    for (const TestType one : {TestType(1), TestType(-1), none, -none})
    {
      const Vector3<TestType> a(zero, zero, zero), b(one, one, one);
      CHECK(angle(a, b) == 0);
      CHECK(angle(b, a) == 0);
      CHECK_FALSE(std::signbit(angle(a, b)));
    }
  }
}
// [zero]

TEST_CASE("each way to find an angle holds or fails as the table says", "[case:A3]")
{
  check_verdicts(
      angles_verdicts(angles_cases(0.0f)), names_of(angle_methods<float>()),
      {{"A3", {"atan2", "Kahan", "recommended"}},
       {"(1, 1, 1) and (1, 2, 3)", {"as published", "atan2", "Kahan", "recommended"}},
       {"(1, 0, 0) and (0, 2, 0)", {"as published", "clamped", "atan2", "Kahan", "recommended"}},
       {"(1001, 1005, 1018) and three times it", {"atan2", "recommended"}},
       {"(1, 0, 0) and (−1e4, 1, 0)", {"atan2", "Kahan", "recommended"}},
       {"(8193, 8192, 0) and (8192, 8191, 0)", {"recommended"}},
       {"(1e20, 0, 0) and (1e20, 2e20, 0)", {"recommended"}},
       {"(1, 0, 0) and (1, 1, 0), times smallest float", {"recommended"}},
       {"the zero vector and (−1, −1, −1)", {"Kahan", "recommended"}}});
  check_verdicts(
      angles_verdicts(angles_cases(0.0)), names_of(angle_methods<double>()),
      {{"(1e8 + 1, 1e8, 0) and (1e8, 1e8 − 1, 0), double", {"recommended"}},
       {"(1, 0, 0) and (1, 1e-300, 0), double", {"recommended"}}});
}

TEST_CASE("an angle 11 roundings off is right, one 13 off is not", "[case:A3]")
{
  CHECK(angle_verdict(1 + 11 * 0x1p-53, 1.0).holds);
  CHECK_FALSE(angle_verdict(1 + 14 * 0x1p-53, 1.0).holds);
  CHECK_FALSE(angle_verdict(1 - 13 * 0x1p-53, 1.0).holds);
}

TEST_CASE("a comparison within 0.005 says that 4 mm are nothing", "[equal]")
{
  CHECK(equal_as_published<float>({0.004f, 0, 0}, {0, 0, 0}));
  CHECK_FALSE(equal_as_published<float>({0.005f, 0, 0}, {0, 0, 0}));
  CHECK_FALSE(equal_within_roundings<float>({0.004f, 0, 0}, {0, 0, 0}, 1));
  // Eight roundings of a number of size 1 in float: 2^-21.
  CHECK(equal_within_roundings<float>({1, 0, 0}, {1 + 0x1p-21f, 0, 0}, 1));
  CHECK(equal_within_roundings<float>({1, 0, 0}, {1, -0x1p-21f, 0}, 1));
  CHECK_FALSE(equal_within_roundings<float>({1, 0, 0}, {1, 0, 0x1.4p-21f}, 1));
  CHECK(equal_within_roundings<float>({1, 0, 0}, {1, 0, 0x1.8p-21f}, 2));
}

TEST_CASE("each way to compare holds or fails as the table says", "[equal]")
{
  check_verdicts(
      equal_verdicts(), equal_methods,
      {{"(0.004, 0, 0) and 0, in a room", {"isApprox", "within roundings"}},
       {"(1, 1, 1) and (1.004, 1, 1)", {"isApprox", "within roundings"}},
       {"(1e6, 0, 0) and the next float", {"isApprox", "within roundings"}},
       {"(0.1 + 0.6 − 0.7, 0, 0) and 0", {"as published", "within roundings"}}});
}
