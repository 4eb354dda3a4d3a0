/// \file
/// What holds for products, parts, mirror images and mixtures of vectors: formulas M1 to M4.

#include "01_math/numbers/difference_of_products.hpp"
#include "01_math/vectors/trial/vectors_cases.hpp"
#include "01_math/vectors/vectors.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <limits>

using namespace cookbook;

namespace
{

using Exact3 = Vector3<Rational>;

/// All vectors of whole numbers from -most to most.
std::vector<Vector3<int>> whole_vectors(int most)
{
  std::vector<Vector3<int>> all;
  for (int i = 0; i < (2 * most + 1) * (2 * most + 1) * (2 * most + 1); ++i)
  {
    const int side = 2 * most + 1;
    all.push_back({i / (side * side) - most, i / side % side - most, i % side - most});
  }
  return all;
}

} // namespace

// [M1]
TEST_CASE("(3,4,0) and (5,12,0) have the dot product 5 · 13 · 63/65", "[M1]")
{
  // Both lie in the plane: cosine and sine of their angles are sides of 3-4-5 and 5-12-13, and
  // the cosine of the difference is their sum of products.
  const Rational cosine = Rational(3, 5) * Rational(5, 13) + Rational(4, 5) * Rational(12, 13);
  CHECK(cosine == Rational(63, 65));
  CHECK(Exact3(3, 4, 0).dot(Exact3(5, 12, 0)) == 5 * 13 * cosine);
}
// [M1]

// [signs]
TEST_CASE("(4,3,0) is ahead of (1,0,0), (0,1,0) beside it, (-2,3,0) behind", "[M1]")
{
  const Vector3<int> n(1, 0, 0);
  CHECK(Vector3<int>(4, 3, 0).dot(n) == 4);
  CHECK(Vector3<int>(0, 1, 0).dot(n) == 0);
  CHECK(Vector3<int>(-2, 3, 0).dot(n) == -2);
}
// [signs]

// [M2]
TEST_CASE("|a × b|² = |a|²|b|² - (a·b)² for all 15,625 pairs of whole vectors up to 2", "[M2]")
{
  int right = 0;
  for (const Vector3<int>& a : whole_vectors(2))
  {
    for (const Vector3<int>& b : whole_vectors(2))
    {
      const int dot = a.dot(b);
      right += a.cross(b).squaredNorm() == a.squaredNorm() * b.squaredNorm() - dot * dot ? 1 : 0;
    }
  }
  CHECK(right == 125 * 125);
}
// [M2]

// [orientation]
TEST_CASE("x × y = z, y × z = x, z × x = y, and the other way round the negatives", "[M2]")
{
  const Vector3<double> x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  CHECK(accurate_cross(x, y) == z);
  CHECK(accurate_cross(y, z) == x);
  CHECK(accurate_cross(z, x) == y);
  CHECK(accurate_cross(y, x) == -z);
  CHECK(accurate_cross<double>({1, 2, 3}, {2, 1, 2}) == Vector3<double>(1, 4, -3));
  CHECK(accurate_cross<float>({1, 2, 3}, {2, 1, 2}) == Vector3<float>(1, 4, -3));
}

TEST_CASE(
    "the cross product is perpendicular to both of its factors for 15,625 whole pairs", "[M2]")
{
  int right = 0;
  for (const Vector3<int>& a : whole_vectors(2))
  {
    for (const Vector3<int>& b : whole_vectors(2))
    {
      const Vector3<int> c = a.cross(b);
      const bool same = accurate_cross<double>(a.cast<double>(), b.cast<double>()).cast<int>() == c;
      right += c.dot(a) == 0 && c.dot(b) == 0 && same ? 1 : 0;
    }
  }
  CHECK(right == 125 * 125);
}
// [orientation]

// [M3]
TEST_CASE("(1,2,3) is (20,10,20)/9 along (2,1,2) and (-11,8,7)/9 across", "[M3]")
{
  const Exact3 a(1, 2, 3), n(2, 1, 2);
  CHECK(project(a, n) == Exact3(20, 10, 20) / Rational(9));
  CHECK(reject(a, n) == Exact3(-11, 8, 7) / Rational(9));
}

TEST_CASE("what lies across is at right angles, exactly, for 343 whole vectors", "[M3]")
{
  const Exact3 n(2, 1, 2);
  for (const Vector3<int>& whole : whole_vectors(3))
  {
    const Exact3 a = whole.cast<Rational>();
    CHECK(reject(a, n).dot(n) == 0);
    CHECK(project(a, n) + reject(a, n) == a);
  }
}
// [M3]

// [M4]
TEST_CASE("(1,2,3) mirrored along (2,1,2) is (-31,-2,-13)/9, and mirrored twice itself", "[M4]")
{
  const Exact3 v(1, 2, 3), n(2, 1, 2);
  const Exact3 mirrored = reflect(v, n);
  CHECK(mirrored == Exact3(-31, -2, -13) / Rational(9));
  CHECK(mirrored.dot(mirrored) == 14);
  CHECK(reflect(mirrored, n) == v);
  CHECK(reflect_unit<Rational>(v, n / Rational(3)) == mirrored);
}
// [M4]

// [unit_normal]
TEST_CASE("without the division a normal of length 1.1 turns a speed of 1 into 1.42", "[M4]")
{
  // 1 - 2 · 1.1² = -1.42
  const Exact3 too_long(Rational(11, 10), 0, 0);
  CHECK(reflect_unit(Exact3(1, 0, 0), too_long) == Exact3(Rational(-142, 100), 0, 0));
  CHECK(reflect(Exact3(1, 0, 0), too_long) == Exact3(-1, 0, 0));
}
// [unit_normal]

// [zero_normal]
TEMPLATE_TEST_CASE(
    "along the zero vector is nothing, across it is all", "[degenerate]", float, double)
{
  const Vector3<TestType> a(1, -2, 3), zero(0, 0, 0), negative_zero(-TestType(0), 0, 0);
  for (const Vector3<TestType>& n : {zero, negative_zero})
  {
    CHECK(project(a, n) == zero);
    CHECK(reject(a, n) == a);
    CHECK(reflect(a, n) == a);
  }
  CHECK(project(zero, a) == zero);
  CHECK(reject(zero, a) == zero);
  CHECK(reflect(zero, a) == zero);
  CHECK(project(zero, zero) == zero);
  CHECK(accurate_cross(a, zero) == zero);
}

TEST_CASE("fractions have the same answers for the zero vector", "[degenerate]")
{
  const Exact3 a(1, -2, 3), zero(0, 0, 0);
  CHECK(project(a, zero) == zero);
  CHECK(reject(a, zero) == a);
  CHECK(reflect(a, zero) == a);
  CHECK(project(zero, a) == zero);
}
// [zero_normal]

TEMPLATE_TEST_CASE(
    "numbers from ε² to 1/ε² are ordinary, others and zero not", "[whole]", float, double)
{
  const TestType epsilon = std::numeric_limits<TestType>::epsilon();
  for (const TestType ordinary : {epsilon * epsilon, TestType(1), 1 / epsilon / epsilon})
  {
    CHECK(is_ordinary<TestType>(ordinary));
  }
  for (const TestType other :
       {epsilon * epsilon / 2, 2 / epsilon / epsilon, TestType(0), TestType(-1), TestType(NAN)})
  {
    CHECK_FALSE(is_ordinary<TestType>(other));
  }
}

TEMPLATE_TEST_CASE(
    "zero and what is not finite have no power of two to take out", "[whole]", float, double)
{
  const TestType infinite = std::numeric_limits<TestType>::infinity();
  CHECK(scaled<TestType>({0, 0, 0}).exponent == 0);
  CHECK(scaled<TestType>({infinite, 1, 0}).exponent == 0);
  CHECK(scaled<TestType>({6, -1, 0}).exponent == 2);
}

TEMPLATE_TEST_CASE(
    "(3,5,7) along (0,0,2) is (0,0,7), for any power of two of both", "[whole]", float, double)
{
  using Limits = std::numeric_limits<TestType>;
  const int least = Limits::min_exponent - Limits::digits, most = Limits::max_exponent - 4;
  for (int of_a = least; of_a <= most; of_a += 3)
  {
    for (int of_n = least; of_n <= most; of_n += 3)
    {
      const Vector3<TestType> a = times_power_of_two<TestType>({3, 5, 7}, of_a);
      const Vector3<TestType> n = times_power_of_two<TestType>({0, 0, 2}, of_n);
      if (project(a, n) != Vector3<TestType>(0, 0, a.z()) ||
          reject(a, n) != Vector3<TestType>(a.x(), a.y(), 0) ||
          reflect(a, n) != Vector3<TestType>(a.x(), a.y(), -a.z()))
      {
        FAIL("2^" << of_a << " and 2^" << of_n);
      }
    }
  }
}

TEMPLATE_TEST_CASE(
    "what reaches the largest number is kept, not infinite", "[whole]", float, double)
{
  const TestType most = std::numeric_limits<TestType>::max();
  const Vector3<TestType> corner(most, most, 0), x(1, 0, 0), slanted(1, TestType(0.5), 0);
  CHECK(project(corner, x) == Vector3<TestType>(most, 0, 0));
  CHECK(reflect(corner, x) == Vector3<TestType>(-most, most, 0));
  // The part along is (1.2, 0.6) of the most, and infinite; the part across is (-0.2, 0.4) of it.
  CHECK(reject(corner, slanted).x() / most == Catch::Approx(-0.2).epsilon(1e-6));
  CHECK(std::isinf(project(corner, slanted).x()));
  CHECK(
      length<TestType>({most / 2, most / 2, 0}) / most ==
      Catch::Approx(std::sqrt(0.5)).epsilon(1e-6));
}

// [nearly_parallel]
TEST_CASE("(1e8+1,1e8,0) × (1e8,1e8-1,0) is (0,0,-1), where the textbook's is zero", "[cross]")
{
  const Vector3<double> a(1e8 + 1, 1e8, 0), b(1e8, 1e8 - 1, 0);
  CHECK(a.cross(b) == Vector3<double>(0, 0, 0));
  CHECK(accurate_cross(a, b) == Vector3<double>(0, 0, -1));
}
// [nearly_parallel]

TEST_CASE("a difference of products is right at both ends of the range of double", "[cross]")
{
  const double tiny = 0x1p-1074, huge = 0x1p1023;
  CHECK(difference_of_products(huge, huge, huge, huge) == 0);
  CHECK(difference_of_products(huge, tiny, 0.0, huge) == 0x1p-51);
  CHECK(difference_of_products(huge, tiny, tiny, huge) == 0);
  CHECK(difference_of_products(0.0, huge, tiny, huge) == -0x1p-51);
  CHECK(difference_of_products(0x1.8p1023, 0x1p-1074, 0x1p1023, 0x1p-1074) == 0x1p-52);
  CHECK(difference_of_products(0x1p600, 0x1p600, 0x1p600, 0x1p600 - 0x1p547) == HUGE_VAL);
  CHECK(difference_of_products(0x1p510, 0x1p510, 0x1p510, 0x1p510 - 0x1p457) == 0x1p967);
  CHECK(difference_of_products(0x1p600, 0x1p420, 0x1p600, 0x1p420 - 0x1p367) == 0x1p967);
  CHECK(difference_of_products(0x1p-537, 0x1p-537, 0x1p-537, 0x1p-536) == -0x1p-1074);
  CHECK(difference_of_products(0.0, 1.0, 0.0, 1.0) == 0);
  // (1 + 2^-52)² - (1 + 2^-51) = 2^-104, far below the last digit of either.
  CHECK(difference_of_products(1 + 0x1p-52, 1 + 0x1p-52, 1 + 0x1p-51, 1.0) == 0x1p-104);
  CHECK(
      difference_of_products(
          std::ldexp(1 + 0x1p-52, -490), std::ldexp(1 + 0x1p-52, -490),
          std::ldexp(1 + 0x1p-51, -980), 1.0) == 0);
  CHECK(
      difference_of_products(
          std::ldexp(1 + 0x1p-52, -480), std::ldexp(1 + 0x1p-52, -480),
          std::ldexp(1 + 0x1p-51, -960), 1.0) == 0x1p-1064);
}

// [lerp]
TEST_CASE("lerp is exact at both ends, and halfway between -3e38 and 3e38 is 0", "[lerp]")
{
  const Vector3<float> a(-3e38f, 0.1f, 1e8f), b(3e38f, 0.7f, 1);
  CHECK(lerp(a, b, 0.0f) == a);
  CHECK(lerp(a, b, 1.0f) == b);
  CHECK(lerp(a, b, 0.5f).x() == 0);
  CHECK(lerp<double>({0, 0, 8}, {4, -8, 0}, 0.25) == Vector3<double>(1, -2, 6));
}

TEST_CASE("in 10,000 steps from 0.1 to 0.7 lerp never turns back; the mixture does", "[lerp]")
{
  const Vector3<float> a(0.1f, 0.3f, -0.7f), b(0.7f, 0.30000004f, 0.2f);
  int ours = 0, mixtures = 0;
  for (int i = 1; i <= 10000; ++i)
  {
    const float before = static_cast<float>(i - 1) / 10000, now = static_cast<float>(i) / 10000;
    ours += (lerp(a, b, now) - lerp(a, b, before)).minCoeff() < 0 ? 1 : 0;
    mixtures += (lerp_by_mixture(a, b, now) - lerp_by_mixture(a, b, before)).minCoeff() < 0 ? 1 : 0;
  }
  CHECK(ours == 0);
  CHECK(mixtures > 100);
}
// [lerp]

TEST_CASE("formulas on vectors hold or fail as the table says", "[vectors]")
{
  const std::vector<std::string> ours{"recommended"};
  check_verdicts(
      vectors_verdicts(), vectors_methods,
      {{"nearly parallel: (1e8 + 1, 1e8, 0) × (1e8, 1e8 − 1, 0)", ours},
       {"(1e200, 1e200, 0) × itself", ours},
       {"(1, 2, 3) along (2, 1, 2) · 1e-30, float", ours},
       {"(1, 2, 3) along (2, 1, 2) · 1e25, float", ours},
       {"(1, 2, 3) along the zero vector", ours},
       {"(1, 0, 0) mirrored, normal (1.1, 0, 0)", ours},
       {"lerp as a + t (b − a): from 1e8 to 1, t = 1", ours},
       {"lerp as a + t (b − a): from −3e38 to 3e38, t = 1/2", ours},
       {"lerp as (1 − t) a + t b: from 0.1 to 0.1, t = 0.2", ours},
       {"(3, 5, 0) − (1, 2, 0), as published", ours}});
}

TEST_CASE("in a room the textbook's formulas are within 10 roundings of the recommended", "[room]")
{
  for (const Vector3<int>& whole : whole_vectors(3))
  {
    const Vector3<float> a = whole.cast<float>() * 0.37f, n(0.2f, -0.9f, 0.4f);
    const float allowed = 10 * 0x1p-24f * a.norm();
    CHECK((project_textbook(a, n) - project(a, n)).cwiseAbs().maxCoeff() <= allowed);
    CHECK((a.cross(n) - accurate_cross(a, n)).cwiseAbs().maxCoeff() <= allowed);
  }
}
