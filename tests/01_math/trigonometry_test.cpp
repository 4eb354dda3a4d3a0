/// \file
/// What holds for sine, cosine, arc tangent and exponential: an ulp from the truth, whatever the
/// input.

#include "01_math/truth/trial/whole_range.hpp"
#include "common/math/exponential.hpp"
#include "common/math/trigonometry.hpp"
#include "common/math/ulp.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <cmath>
#include <limits>
#include <vector>

using namespace cookbook;

namespace
{

const double pi = 3.14159265358979323846;
const double infinity = std::numeric_limits<double>::infinity();
const double no_number = std::numeric_limits<double>::quiet_NaN();

/// How far a number is from the truth, in ulps of the double next to that on the side of zero.
double ulps(double found, const Reference& truth)
{
  const double below = std::nextafter(static_cast<double>(truth), 0.0);
  return static_cast<double>(abs(Reference(found) - truth) / Reference(ulp(below)));
}

/// Whether two numbers have the same bits, or neither is a number.
bool same(double a, double b)
{
  return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}

/// An angle [rad]: of any size, of a few turns, of many, or next to a number of quarter turns.
double drawn_angle(WholeRange<double>& draw)
{
  switch (draw.drawn(0, 3))
  {
  case 0:
    return draw.number();
  case 1:
    return 9 * draw.fraction();
  case 2:
    return 0x1p21 * draw.fraction();
  default:
    return std::nextafter(draw.drawn(-700'000, 700'000) * (pi / 2), draw.drawn(0, 1) * 1e9);
  }
}

} // namespace

// [sine_cosine]
TEST_CASE("sine and cosine of 100,000 angles of any size are within an ulp", "[math]")
{
  WholeRange<double> draw;
  double worst = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const double angle = drawn_angle(draw);
    const SineCosine<double> of = sine_cosine(angle);
    worst = std::max(worst, ulps(of.sine, sin(Reference(angle))));
    worst = std::max(worst, ulps(of.cosine, cos(Reference(angle))));
  }
  CAPTURE(worst);
  CHECK(worst < 1);
}
// [sine_cosine]

TEST_CASE(
    "of all doubles this is next to a number of quarter turns, and its cosine has digits", "[math]")
{
  const double angle = std::ldexp(6381956970095103, 797);
  CHECK(ulps(cosine(angle), cos(Reference(angle))) < 1);
  CHECK(std::abs(cosine(angle)) < 5e-19);
}

TEST_CASE("the arc tangents of 100,000 points of any size are within an ulp", "[math]")
{
  WholeRange<double> draw;
  double worst = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const bool usual = draw.drawn(0, 1) == 0;
    const double x = usual ? draw.fraction() : draw.number(),
                 y = usual ? draw.fraction() : draw.number();
    worst = std::max(worst, ulps(arc_tangent(y, x), atan2(Reference(y), Reference(x))));
  }
  CAPTURE(worst);
  CHECK(worst <= 1);
}

TEST_CASE("100,000 exponentials are within an ulp, those below the normal numbers, too", "[math]")
{
  WholeRange<double> draw;
  double worst = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const double x = draw.fraction() * (draw.drawn(0, 1) == 0 ? 709 : 2);
    worst = std::max(worst, ulps(exponential(x), exp(Reference(x))));
    const double below = -708 - 37 * std::abs(draw.fraction());
    worst = std::max(worst, ulps(exponential(below), exp(Reference(below))));
  }
  CAPTURE(worst);
  CHECK(worst < 1.01);
}

TEST_CASE("sine and cosine of zeros, infinities and what is not a number", "[math]")
{
  CHECK(same(sine(0.0), 0));
  CHECK(same(sine(-0.0), -0.0));
  CHECK(sine(5e-324) == 5e-324);
  CHECK(cosine(-0.0) == 1);
  for (const double none : {infinity, -infinity, no_number})
  {
    CHECK(std::isnan(sine(none)));
    CHECK(std::isnan(cosine(none)));
  }
}

TEST_CASE(
    "arc tangents on the axes, at infinity, and of the smallest and largest numbers", "[math]")
{
  CHECK(same(arc_tangent(0.0, 1.0), 0));
  CHECK(same(arc_tangent(-0.0, 1.0), -0.0));
  CHECK(same(arc_tangent(0.0, 0.0), 0));
  CHECK(same(arc_tangent(0.0, -0.0), pi));
  CHECK(same(arc_tangent(-0.0, -1.0), -pi));
  CHECK(same(arc_tangent(1.0, 0.0), pi / 2));
  CHECK(same(arc_tangent(-5e-324, -0.0), -pi / 2));
  CHECK(same(arc_tangent(infinity, 1e308), pi / 2));
  CHECK(same(arc_tangent(1e308, -infinity), pi));
  CHECK(same(arc_tangent(-infinity, infinity), -pi / 4));
  CHECK(same(arc_tangent(infinity, -infinity), 3 * pi / 4));
  CHECK(same(arc_tangent(1e308, 1e308), pi / 4));
  CHECK(same(arc_tangent(5e-324, 5e-324), pi / 4));
  CHECK(same(arc_tangent(5e-324, 1e308), 0));
  CHECK(std::isnan(arc_tangent(no_number, 1.0)));
  CHECK(std::isnan(arc_tangent(infinity, no_number)));
}

TEST_CASE("exponentials of zeros, infinities and what is too large or small", "[math]")
{
  CHECK(exponential(-0.0) == 1);
  CHECK(exponential(infinity) == infinity);
  CHECK(same(exponential(-infinity), 0));
  CHECK(exponential(709.8) == infinity);
  CHECK(exponential(1e300) == infinity);
  CHECK(exponential(-745.1) == 5e-324);
  CHECK(same(exponential(-746.0), 0));
  CHECK(same(exponential(-1e300), 0));
  CHECK(std::isnan(exponential(no_number)));
}

TEST_CASE("in float sine, cosine, arc tangent and exponential are the doubles, rounded", "[math]")
{
  CHECK(sine(1.5f) == static_cast<float>(std::sin(1.5)));
  CHECK(cosine(1.5f) == static_cast<float>(std::cos(1.5)));
  CHECK(arc_tangent(1.5f, 2.0f) == static_cast<float>(std::atan2(1.5, 2.0)));
  CHECK(exponential(1.5f) == static_cast<float>(std::exp(1.5)));
}

TEST_CASE("numbers of a hundred digits go on with their own functions", "[math]")
{
  CHECK(sine(Reference(2)) == sin(Reference(2)));
  CHECK(arc_tangent(Reference(2), Reference(3)) == atan2(Reference(2), Reference(3)));
  CHECK(exponential(Reference(2)) == exp(Reference(2)));
}

// [order]
TEST_CASE("a dot product is added from the right, whatever the compiler", "[math]")
{
  const double left = 0.1 + 0.2 + 0.3, right = 0.1 + (0.2 + 0.3);
  CHECK(left != right);
  CHECK(Vector3<double>(0.1, 0.2, 0.3).dot(Vector3<double>(1, 1, 1)) == right);
}
// [order]
