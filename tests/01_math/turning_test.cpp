/// \file
/// What holds for turning by an angular velocity: formulas M9 and M10, and where ways to turn fail.

#include "01_math/rotations/euler_angles.hpp"
#include "01_math/truth/trial/whole_range.hpp"
#include "01_math/turning/trial/turning_cases.hpp"
#include "01_math/turning/turning.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/verdicts.hpp"

#include <cmath>
#include <limits>
#include <numbers>

using namespace cookbook;

namespace
{

using Long = long double;

/// A few roundings of numbers of size one: double's unit roundoff is 1.1e-16.
constexpr double few = 1e-15;

/// The largest difference of a part, in units in the last place of one.
template <class Real>
double off(const Quaternion<Real>& answer, const Quaternion<Long>& truth)
{
  const Eigen::Matrix<Long, 4, 1> wide = answer.coeffs().template cast<Long>();
  const Long difference = (wide - truth.coeffs()).cwiseAbs().maxCoeff();
  return static_cast<double>(difference / Long(std::numeric_limits<Real>::epsilon()));
}

/// The angle between two orientations of length one.
double angle_of(const Quaternion<double>& a, const Quaternion<double>& b)
{
  const Quaternion<double> turn = a.conjugate() * b;
  return 2 * std::atan2(turn.vec().norm(), std::abs(turn.w()));
}

} // namespace

// [M9]
TEST_CASE("a quarter turn about x takes y to z; 90 turns of 1° are one of 90°", "[M9]")
{
  const double quarter = std::numbers::pi / 2;
  const Vector3<double> y(0, 1, 0), axis = Vector3<double>(1, 2, -2) / 3;
  CHECK((rotation_by<double>({quarter, 0, 0}) * y - Vector3<double>(0, 0, 1)).norm() <= few);
  Quaternion<double> steps(1, 0, 0, 0);
  for (int i = 0; i < 90; ++i)
  {
    steps = turned_by<double>(steps, axis * quarter, 1.0 / 90);
  }
  CHECK(angle_of(steps, rotation_by<double>(axis * quarter)) <= 90 * few);
}
// [M9]

// [half_turn]
TEST_CASE("cosine and sine of half an angle are right to three ulps, on both sides of 1/2", "[M9]")
{
  for (int i = -400; i <= 400; ++i)
  {
    const double angle = i / 200.0 + 1e-3;
    const HalfTurn<double> half = half_turn(angle);
    const Reference cosine = cos(Reference(angle) / 2), sine = sin(Reference(angle) / 2);
    const double most = 3 * std::numeric_limits<double>::epsilon();
    CHECK(abs(Reference(half.cosine) - cosine) <= most);
    CHECK(abs(Reference(half.sine) - sine) <= most * abs(sine));
  }
}

TEST_CASE("no turn, the smallest and one of which no digit is left are no turn at all", "[M9]")
{
  const Quaternion<double> none(1, 0, 0, 0);
  CHECK(rotation_by<double>({0, 0, 0}).coeffs() == none.coeffs());
  CHECK(rotation_by<double>({1e17, 0, 0}).coeffs() == none.coeffs());
  CHECK(rotation_by<double>({1e308, 1e308, 0}).coeffs() == none.coeffs());
  CHECK(rotation_by<double>({0, 1e-200, 0}).y() == 0.5e-200);
  CHECK(rotation_by<double>({0, 5e-324, 0}).coeffs().allFinite());
  // Just below and at 1/ε.
  CHECK(rotation_by<double>({0, 0x1p52 - 1, 0}).w() != 1);
  CHECK(rotation_by<double>({0, 0x1p52, 0}).coeffs() == none.coeffs());
}
// [half_turn]

// [turns_everywhere]
TEMPLATE_TEST_CASE(
    "100,000 turns of every size are within 2 ulp of one, and twice as many as the angle has",
    "[M9]", float, double)
{
  WholeRange<TestType> draw;
  const Long most = 1 / Long(std::numeric_limits<TestType>::epsilon());
  double worst = 0, relative = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const bool usual = draw.drawn(0, 1) == 0;
    Vector3<TestType> turn = draw.drawn(0, 1) == 0 ? draw.even_vector() : draw.vector();
    turn =
        usual ? Vector3<TestType>(9 * draw.fraction(), 9 * draw.fraction(), draw.fraction()) : turn;
    const Quaternion<TestType> answer = rotation_by(turn);
    const Vector3<Long> wide = turn.template cast<Long>();
    const Long angle = wide.norm();
    if (angle >= most * Long(0.999))
    {
      CHECK(
          (angle < most * Long(1.001) ||
           answer.coeffs() == Quaternion<TestType>(1, 0, 0, 0).coeffs()));
      continue;
    }
    Quaternion<Long> truth(std::cos(angle / 2), 0, 0, 0);
    truth.vec() = angle > 0 ? Vector3<Long>(wide * (std::sin(angle / 2) / angle)) : wide;
    // The angle is rounded, and so is the fraction; each doubling back from half a radian doubles
    // both.
    worst = std::max(worst, off(answer, truth) / (2 + 2 * static_cast<double>(angle)));
    // A small turn keeps its relative digits, until it is so small that it has none.
    if (angle < 1 && angle > 1e8 * Long(std::numeric_limits<TestType>::min()))
    {
      const Long difference = (answer.vec().template cast<Long>() - truth.vec()).norm();
      relative = std::max(relative, double(difference / truth.vec().norm() * most));
    }
  }
  CAPTURE(worst, relative);
  CHECK(worst <= 1);
  CHECK(relative <= 4);
}

TEMPLATE_TEST_CASE(
    "whatever the orientation and the spin, the answer is of length one to 3 ulp", "[M9]", float,
    double)
{
  WholeRange<TestType> draw;
  const TestType epsilon = std::numeric_limits<TestType>::epsilon();
  double worst = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const Vector3<TestType> v = draw.even_vector(), spin = draw.vector();
    Quaternion<TestType> start(v.cwiseAbs().maxCoeff() * draw.fraction(), v.x(), v.y(), v.z());
    const bool moderate = draw.drawn(0, 1) == 0;
    start =
        moderate
            ? Quaternion<TestType>(
                  unit_quaternion(start).coeffs() * (1 + draw.fraction() * 4 * std::sqrt(epsilon)))
            : start;
    const Quaternion<Long> end = unit_quaternion(start).template cast<Long>();
    worst = std::max(worst, static_cast<double>(std::abs(end.norm() - 1) / Long(epsilon)));
    const TestType step = moderate ? TestType(1) / 60 : draw.number();
    const Quaternion<Long> turned =
        turned_by(unit_quaternion(start), spin, step).template cast<Long>();
    worst = std::max(worst, static_cast<double>(std::abs(turned.norm() - 1) / Long(epsilon)));
  }
  CAPTURE(worst);
  CHECK(worst <= 3);
}

TEMPLATE_TEST_CASE(
    "the turn between 100,000 orientations leads from one to the other within 8 ulp", "", float,
    double)
{
  WholeRange<TestType> draw;
  double worst = 0, longest = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const auto drawn = [&]
    {
      const TestType w = draw.fraction(), x = draw.fraction(), y = draw.fraction();
      return unit_quaternion(Quaternion<TestType>(w, x, y, draw.fraction()));
    };
    const Quaternion<TestType> from = drawn();
    Quaternion<TestType> to = drawn();
    if (draw.drawn(0, 1) == 0)
    {
      to.coeffs() = from.coeffs() + to.coeffs() * std::ldexp(TestType(1), -draw.drawn(1, 60));
      to = unit_quaternion(to);
    }
    const Vector3<TestType> turn = turn_between(from, to);
    const Quaternion<Long> again = (rotation_by(turn) * from).template cast<Long>();
    Quaternion<Long> plus = to.template cast<Long>(), minus(-plus.coeffs());
    worst = std::max(
        worst, std::min(
                   off<TestType>(again.template cast<TestType>(), plus),
                   off<TestType>(again.template cast<TestType>(), minus)));
    longest = std::max(longest, static_cast<double>(turn.norm()));
  }
  CAPTURE(worst);
  CHECK(worst <= 8);
  CHECK(longest <= std::numbers::pi + 1e-6);
}

TEST_CASE("the turn between orientations 1e-25 rad apart is 1e-25 rad, in float too")
{
  const Quaternion<float> from(1, 0, 0, 0), to(1, 0, 0.5e-25f, 0);
  CHECK(turn_between(from, to) == Vector3<float>(0, 1e-25f, 0));
  CHECK(turn_between(from, from) == Vector3<float>(0, 0, 0));
  CHECK(turn_between(from, Quaternion<float>(-1, 0, 0, 0)) == Vector3<float>(0, 0, 0));
}
// [turns_everywhere]

// [M10]
TEST_CASE("added, a quaternion grows by √(1 + (ωh/2)²) and turns by 2 atan(ωh/2)", "[M10]")
{
  // ωh/2 = 3/4: five fourths as long, and the half turn has cosine 4/5 and sine 3/5.
  const Quaternion<double> start(1, 0, 0, 0);
  const Quaternion<double> added = quaternion_added<double>(start, {1.5, 0, 0}, 1);
  CHECK(added.norm() == 1.25);
  CHECK(std::abs(angle_of(added.normalized(), start) - 2 * std::atan(0.75)) <= few);
  const Quaternion<double> unit = quaternion_added_and_normalised<double>(start, {1.5, 0, 0}, 1);
  CHECK(std::abs(unit.w() - 0.8) <= few);
  CHECK(std::abs(unit.x() - 0.6) <= few);
}
// [M10]

TEST_CASE("the fraction with a fourth of the angle turns by 4 atan(ωh/4), at length one")
{
  // ωh/4 = 1/3: half the turn has cosine 4/5 and sine 3/5.
  const Quaternion<double> start(1, 0, 0, 0);
  const Quaternion<double> turned = turned_by_fraction<double>(start, {0, 0, 4.0 / 3}, 1);
  CHECK(std::abs(turned.w() - 0.8) <= few);
  CHECK(std::abs(turned.z() - 0.6) <= few);
}

// [A5]
TEST_CASE(
    "at 50 rad/s and 60 Hz a quaternion added lags 150° a second and grows 122 times", "[case:A5]")
{
  const TurningCase second{"", "", {0, 50, 0}, 60, 60, 1e-3, false};
  const auto ways = spin_ways<double>();
  const auto end = [&](std::size_t i) { return ways[i].turn(second.spin, 1.0 / 60, 60); };
  const double degree = std::numbers::pi / 180;
  // 60 (5/6 - 2 atan 5/12) = 2.625 rad, and (1 + 25/144)^30 = 121.8.
  CHECK(spin_error(second, end(1)) == Catch::Approx(150.4 * degree).margin(0.05 * degree));
  CHECK(end(1).length == Catch::Approx(121.8).margin(0.05));
  CHECK(spin_error(second, end(2)) == Catch::Approx(150.4 * degree).margin(0.05 * degree));
  CHECK(spin_error(second, end(6)) <= 100 * few);
}
// [A5]

// [turning_verdicts]
TEST_CASE("each way to turn holds or fails as the table says", "[case:A5][case:A6][long]")
{
  const std::string angles = "angles added, as published", added = "quaternion added",
                    unit = "added, length one", fraction = "half-angle fraction",
                    matrix = "matrix added, orthonormal", divided = "divided by |ω|",
                    best = "turned_by";
  check_verdicts(
      turning_verdicts(), names_of(spin_ways<double>()),
      {{"A5", {angles, divided, best}},
       {"A6", {divided, best}},
       {"no spin for 1 s", {angles, added, unit, fraction, matrix, best}},
       {"1e-25 rad/s about y, float", {angles, added, unit, fraction, matrix, best}},
       {"1e25 rad/s about y, float", {angles, best}},
       {"1 rad/s for a million steps, float", {best}}});
}
// [turning_verdicts]

TEST_CASE("a length that is 1/500 off fails, one that is 1/2000 off holds; so does an angle")
{
  const TurningCase still{"", "", {0, 0, 0}, 1, 1, 0.01, false};
  const Quaternion<double> none(1, 0, 0, 0);
  CHECK(spin_verdict(still, {none, 1.0005}).holds);
  CHECK_FALSE(spin_verdict(still, {none, 1.002}).holds);
  CHECK_FALSE(spin_verdict(still, {none, 0.998}).holds);
  CHECK(spin_verdict(still, {Quaternion<double>(1, 0.004, 0, 0), 1}).holds);
  CHECK_FALSE(spin_verdict(still, {Quaternion<double>(1, 0.006, 0, 0), 1}).holds);
  CHECK_FALSE(spin_verdict(still, {none, HUGE_VAL}).holds);
}

TEST_CASE("a spin, or a fraction of a way, that is not a number gives no number", "[M9]")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(rotation_by<double>({0, nan, 0}).coeffs().hasNaN());
  CHECK(turned_by<double>(Quaternion<double>(1, 0, 0, 0), {0, nan, 0}, 1).coeffs().hasNaN());
}
