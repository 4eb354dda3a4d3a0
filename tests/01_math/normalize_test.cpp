/// \file
/// What holds for lengths and directions, and the vectors that break a way to normalise.

#include "01_math/normalize/normalize.hpp"
#include "01_math/normalize/trial/normalize_cases.hpp"
#include "01_math/normalize/trial/normalize_libraries.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

using namespace cookbook;

TEST_CASE("each way to normalise holds or fails as the table says", "[case:A1][case:A2]")
{
  check_verdicts(
      normalize_verdicts(normalize_cases(0.0f)), names_of(normalize_methods<float>()),
      {{"A1", {"threshold", "wider", "scaled"}},
       {"A2", {"wider", "scaled"}},
       {"(1e20, 1e20, 1e20)", {"wider", "scaled"}},
       {"(1, 2, 2)", {"naive", "threshold", "wider", "scaled"}},
       {"(1, 2, 2) · 1e-7", {"naive", "wider", "scaled"}},
       {"(1, 2, 2) · 1e-22", {"wider", "scaled"}},
       {"(3, 4, 0) · smallest float", {"wider", "scaled"}},
       {"(1, 1, 0) · smallest float", {"wider", "scaled"}},
       {"(1e20, 1, 0)", {"wider", "scaled"}},
       {"half of the largest", {"wider", "scaled"}}});
  check_verdicts(
      normalize_verdicts(normalize_cases(0.0)), names_of(normalize_methods<double>()),
      {{"(1, 2, 2), double", {"naive", "threshold", "wider", "scaled"}},
       {"(1, 1, 1) · 1e200, double", {"scaled"}},
       {"(3, 4, 0) · 1e-200, double", {"scaled"}}});
}

TEST_CASE("each library's way to normalise holds or fails as the table says", "[case:A1][case:A2]")
{
  const std::vector<std::string> all{"normalized", "stableNormalized", "hypot"};
  const std::vector<std::string> scaling{"stableNormalized", "hypot"};
  check_verdicts(
      library_verdicts(normalize_cases(0.0f)), names_of(normalize_libraries<float>()),
      {{"A1", {}},
       {"A2", scaling},
       {"(1e20, 1e20, 1e20)", scaling},
       {"(1, 2, 2)", all},
       {"(1, 2, 2) · 1e-7", all},
       {"(1, 2, 2) · 1e-22", scaling},
       {"(3, 4, 0) · smallest float", scaling},
       {"(1, 1, 0) · smallest float", {}},
       {"(1e20, 1, 0)", scaling},
       {"half of the largest", scaling}});
  check_verdicts(
      library_verdicts(normalize_cases(0.0)), names_of(normalize_libraries<double>()),
      {{"(1, 2, 2), double", all},
       {"(1, 1, 1) · 1e200, double", scaling},
       {"(3, 4, 0) · 1e-200, double", scaling}});
}

TEST_CASE("a direction that is 3 ulp off is right, one that is 5 ulp off is not", "[case:A1]")
{
  // (1, 2, 2) has the length 3; a component's error is counted in ulps of one, 2^-23.
  const auto off = [](float ulps)
  {
    const Direction<float> answer{{1.0f / 3 + ulps * 0x1p-23f, 2.0f / 3, 2.0f / 3}, 3};
    return normalize_verdict<float>(answer, {1, 2, 2});
  };
  CHECK(off(3).holds);
  CHECK_FALSE(off(5).holds);
  CHECK_FALSE(off(-5).holds);
}

TEST_CASE("with a threshold of 1e-6, a length of 1e-6 counts and one below is zero", "[case:A2]")
{
  CHECK(normalize_threshold<double>({1e-6, 0, 0}).length == 1e-6);
  CHECK(normalize_threshold<double>({0.999e-6, 0, 0}).length == 0);
  CHECK(normalize_threshold<double>({0.999e-6, 0, 0}).unit == Vector3<double>(0, 1, 0));
}

// [zero]
TEMPLATE_TEST_CASE(
    "the zero vector has length 0 and points where asked", "[case:A1]", float, double)
{
  const Vector3<TestType> zero = Vector3<TestType>::Zero();
  CHECK(normalize<TestType>(zero).length == 0);
  CHECK(normalize<TestType>(zero).unit == Vector3<TestType>::UnitY());
  CHECK(normalize<TestType>(zero, Vector3<TestType>::UnitZ()).unit == Vector3<TestType>::UnitZ());
}
// [zero]

// [scaled]
TEST_CASE("(2,3,6) times any power of two of float has length 7, scaled the same", "[case:A2]")
{
  for (int exponent = -149; exponent <= 124; ++exponent)
  {
    const Vector3<float> v(
        std::ldexp(2.0f, exponent), std::ldexp(3.0f, exponent), std::ldexp(-6.0f, exponent));
    const Direction<float> answer = normalize(v);
    CHECK(answer.length == std::ldexp(7.0f, exponent));
    CHECK(answer.unit == normalize<float>({2, 3, -6}).unit);
  }
}

TEST_CASE("length and direction are within 4 ulp for every size of float", "[case:A2]")
{
  for (int exponent = -44; exponent <= 38; ++exponent)
  {
    const float size = static_cast<float>(std::pow(10.0, exponent));
    for (const Vector3<float>& v : vectors_of_size(size, 20))
    {
      CHECK(direction_error<float>(normalize(v), v) <= allowed_ulps);
    }
  }
}

TEST_CASE("length and direction are within 4 ulp for every size of double", "[case:A2]")
{
  for (int exponent = -320; exponent <= 308; exponent += 4)
  {
    for (const Vector3<double>& v : vectors_of_size(std::pow(10.0, exponent), 20))
    {
      CHECK(direction_error<double>(normalize(v), v) <= allowed_ulps);
    }
  }
}
// [scaled]

// [room]
TEST_CASE("from a millimetre to a kilometre the naive way is as right as the scaled one", "[room]")
{
  for (const float size : {1e-3f, 1e-2f, 1e-1f, 1.0f, 1e1f, 1e2f, 1e3f})
  {
    for (const Vector3<float>& v : vectors_of_size(size, 100))
    {
      CHECK(normalize_naive(v).length == normalize(v).length);
      CHECK(direction_error(normalize_naive(v), v) <= allowed_ulps);
      CHECK(direction_error<float>(normalize(v), v) <= allowed_ulps);
    }
  }
}
// [room]

// [galaxy]
TEST_CASE("across 1e20 m, or 1e-23 m, the naive way has no length at all", "[galaxy][case:A2]")
{
  CHECK(std::isinf(normalize_naive<float>({1e20f, 1e20f, 1e20f}).length));
  CHECK(normalize_naive<float>({1e-23f, 0, 0}).length == 0);
  // √3 · 1e20, correctly rounded to four digits.
  CHECK(normalize<float>({1e20f, 1e20f, 1e20f}).length == Catch::Approx(1.732e20).epsilon(1e-4));
  CHECK(normalize<float>({1e-23f, 0, 0}).length == 1e-23f);
}
// [galaxy]

TEST_CASE("a length of 3e-22 comes out 0.6 % wrong in the naive way, without a word", "[case:A2]")
{
  // The squares 1e-44 and 4e-44 are whole multiples of the smallest float, 1.4e-45.
  const Direction<float> answer = normalize_naive<float>({1e-22f, 2e-22f, 2e-22f});
  CHECK(answer.length > 3e-22f * 1.001f);
  CHECK(answer.length < 3e-22f * 1.1f);
}
