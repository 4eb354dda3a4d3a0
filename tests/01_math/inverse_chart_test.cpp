/// \file
/// What holds for the matrices that the ways to invert are timed on.

#include "01_math/inverse_chart/trial/inverse_chart.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

// [conditioned]
TEST_CASE("matrices of stretch 1e6 have singular values 1, 1 and 1e-6", "[M11]")
{
  for (const Matrix3<double>& m : conditioned<3>(1e6, 20))
  {
    // The sums of their squares, of the squares of two multiplied, and all three multiplied.
    CHECK(m.squaredNorm() == Catch::Approx(2 + 1e-12).epsilon(1e-15));
    CHECK(cofactors<double>(m).squaredNorm() == Catch::Approx(1 + 2e-12).epsilon(1e-14));
    CHECK(std::abs(determinant<double, 3>(m)) == Catch::Approx(1e-6).epsilon(1e-9));
  }
}

TEMPLATE_TEST_CASE_SIG(
    "of stretch 1e12 the recommended inverse is right to the last digit, Eigen's to 3 digits or so",
    "[M11]", ((int Size), Size), 3, 4)
{
  const auto matrices = conditioned<Size>(1e12, 30);
  const auto ways = timed_inverses<Size>();
  CHECK(inverse_errors<Size>(ways.front(), matrices).maximum > 1e-7);
  CHECK(inverse_errors<Size>(ways.front(), matrices).maximum < 1e-2);
  CHECK(inverse_errors<Size>(ways.back(), matrices).maximum < 2e-16);
}

TEMPLATE_TEST_CASE_SIG(
    "of stretch 1 all ways are right to 15 digits", "[M11]", ((int Size), Size), 3, 4)
{
  for (const TimedInverse<Size>& way : timed_inverses<Size>())
  {
    INFO(way.name);
    CHECK(inverse_errors<Size>(way, conditioned<Size>(1, 30)).maximum < 1e-15);
  }
}
// [conditioned]
