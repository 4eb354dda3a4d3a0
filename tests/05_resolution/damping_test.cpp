/// \file
/// What holds for damping, formula R32, and the cases in which other ways to damp fail.

#include "05_resolution/damping/damping.hpp"
#include "05_resolution/damping/trial/damping_cases.hpp"
#include "05_resolution/damping/trial/damping_pitfalls.hpp"
#include "05_resolution/damping/trial/damping_verdicts.hpp"
#include "common/math/vector.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <cmath>
#include <limits>
#include <numbers>

using namespace cookbook;

namespace
{

const double rounding = std::numeric_limits<double>::epsilon();
const std::vector<DampingMethod> methods = damping_methods();

} // namespace

// [R32]
TEST_CASE("at a rate of ln 2 a second, half is left after 1 s, a quarter after 2 s", "[R32]")
{
  const double rate = std::numbers::ln2;
  CHECK(damping_factor(rate, 1.0) == Catch::Approx(0.5).epsilon(2 * rounding));
  CHECK(damping_factor(rate, 2.0) == Catch::Approx(0.25).epsilon(4 * rounding));
  CHECK(damping_factor(rate, 0.0) == 1);
  CHECK(damping_factor(0.0, 5.0) == 1);
}

TEST_CASE("one second's damping is the same in 1, 7, 60 or 1,000 steps", "[R32]")
{
  for (const int steps : {1, 7, 60, 1000})
  {
    double left = 1;
    for (int i = 0; i < steps; ++i)
    {
      left *= damping_factor(2.0, 1.0 / steps);
    }
    // e^-2; each step rounds once in the factor and once in the product.
    CHECK(left == Catch::Approx(0.1353352832366127).epsilon(2 * (steps + 1) * rounding));
  }
}

TEST_CASE("a fall of 20 s at c = 0.1/s: 98.1(1 - e^-2) m/s and 1962 - 981(1 - e^-2) m", "[R32]")
{
  const double lost = 1 - 0.1353352832366127;
  const PhasePoint<double> end = damped_fall<double>({0, 0}, 9.81, 0.1, 20.0);
  CHECK(end.velocity == Catch::Approx(98.1 * lost).epsilon(10 * rounding));
  CHECK(end.position == Catch::Approx(1962 - 981 * lost).epsilon(10 * rounding));
}

TEST_CASE("thrown up at 98.1 m/s with c = 0.1/s, it has 98.1(2e^-2 - 1) m/s after 20 s", "[R32]")
{
  const PhasePoint<Vector3<double>> start{{0, 0, 0}, {0, 98.1, 0}};
  const Vector3<double> gravity(0, -9.81, 0);
  const PhasePoint<Vector3<double>> end = damped_fall(start, gravity, 0.1, 20.0);
  CHECK(end.velocity.y() == Catch::Approx(98.1 * (2 * 0.1353352832366127 - 1)).epsilon(1e-14));
  CHECK(end.velocity.x() == 0);
}

TEST_CASE("damped_fall in 1 to 4,800 steps ends in one place", "[R32]")
{
  for (const double rate : {0.05, 1.0, 30.0, 60.0, 240.0})
  {
    const PhasePoint<double> end = damped_end(methods[5], long_fall, rate);
    const PhasePoint<double> once = damped_fall<double>({0, 0}, -9.81, 0.1, 20.0);
    // 4,800 steps, each rounded a few times.
    CHECK(end.velocity == Catch::Approx(once.velocity).epsilon(1e-12));
    CHECK(end.position == Catch::Approx(once.position).epsilon(1e-12));
  }
}

TEST_CASE("RK4 with small steps finds damped_fall's answer too, to 1e-11", "[R32]")
{
  const auto pull = [](double, double v) { return -9.81 - 0.7 * v; };
  PhasePoint<double> at{3, 20};
  for (int i = 0; i < 2000; ++i)
  {
    at = rk4(at, 0.001, pull);
  }
  const PhasePoint<double> exact = damped_fall<double>({3, 20}, -9.81, 0.7, 2.0);
  CHECK(at.velocity == Catch::Approx(exact.velocity).epsilon(1e-11));
  CHECK(at.position == Catch::Approx(exact.position).epsilon(1e-11));
}
// [R32]

// [no_rate]
TEST_CASE("without damping it is a parabola; with 1e-300/s or 1e-9/s it is next to one", "[R32]")
{
  for (const double rate : {0.0, 1e-300, 1e-9})
  {
    const PhasePoint<double> end = damped_fall<double>({0, 3}, -9.81, rate, 2.0);
    // What is left out is a rate·time of 2e-9, in parts of each term.
    CHECK(end.position == Catch::Approx(6 - 2 * 9.81).epsilon(4e-9));
    CHECK(end.velocity == Catch::Approx(3 - 2 * 9.81).epsilon(4e-9));
  }
  CHECK(damped_fall<double>({0, 3}, -9.81, 0.0, 2.0).velocity == 3 - 2 * 9.81);
}

TEST_CASE("series and quotient meet where one takes over from the other, at c·t = 1", "[R32]")
{
  // ∫(1−t)e^−t from 0 to 1 is 1/e.
  CHECK(small_decay(1.0) == Catch::Approx(1 / std::numbers::e).epsilon(4 * rounding));
  CHECK(decay(1.0, 1.0).falling == Catch::Approx(1 / std::numbers::e).epsilon(4 * rounding));
  CHECK(small_decay(0.0) == 0.5);
}

TEST_CASE("a rate of 1e300/s stops everything at once, and nothing is infinite", "[R32]")
{
  const PhasePoint<double> end = damped_fall<double>({7, 1e6}, -9.81, 1e300, 1.0);
  CHECK(end.velocity == Catch::Approx(0).margin(1e-200));
  CHECK(end.position == 7);
}
// [no_rate]

// [cheap]
TEST_CASE(
    "1/(1 + c·step) falls at a final speed of exactly g/c, exp after the kick slower", "[R32]")
{
  const Rational g = Rational(981) / 100, rate = Rational(1) / 10, step = Rational(1) / 30;
  const Rational final = g / rate;
  CHECK(implicit_damping_factor(rate, step) * (final + step * g) == final);
  // v = q(v + gh) at v = gh q/(1 - q) = g/c - gh/2 + …, the next term being g c h²/12 = 9e-5.
  const double q = damping_factor(0.1, 1 / 30.0);
  CHECK(9.81 / 30 * q / (1 - q) == Catch::Approx(98.1 - 9.81 / 60).epsilon(1e-6));
  // Half a kick before and half after leave only that term.
  const double amid = 98.1 + 9.81 * 0.1 / 900 / 12;
  CHECK(damped_kick(amid, 9.81, q, 1 / 30.0) == Catch::Approx(amid).epsilon(1e-9));
}

TEST_CASE("the cheap factor is too large by (c·step)²/2 each step, and never negative", "[R32]")
{
  for (const double s : {1e-2, 1e-3})
  {
    const double over = implicit_damping_factor(1.0, s) - damping_factor(1.0, s);
    CHECK(over == Catch::Approx(s * s / 2).epsilon(2 * s)); // the next term is 5/6 s³
  }
  CHECK(implicit_damping_factor(1.0, 1e6) > 0);
  CHECK(explicit_damping_factor(1.0, 1.5) == -0.5);
  CHECK(explicit_damping_factor(1.0, 3.0) == -2);
}
// [cheap]

// [damping_left_out]
TEST_CASE("a drop of 0.3 s needs no damping of 0.01/s: it is 0.44 mm off without", "[R32]")
{
  const auto off = [](double time) {
    return 9.81 / 2 * time * time - damped_fall<double>({0, 0}, 9.81, 0.01, time).position;
  };
  CHECK(off(0.3) < 0.001);
  CHECK(off(0.3) == Catch::Approx(9.81 * 0.01 * 0.027 / 6).epsilon(0.01)); // g c t³/6
}
// [damping_left_out]

// [damping_needed]
TEST_CASE("a fall of 20 s does: without a damping of 0.01/s it is 124 m off", "[R32]")
{
  const double fallen = damped_fall<double>({0, 0}, 9.81, 0.01, 20.0).position;
  CHECK(9.81 / 2 * 400 - fallen > 120);
  // 981·(20 - 100(1 - e^-0.2)) with e^-0.2 = 0.81873075307798…
  CHECK(fallen == Catch::Approx(981 * (20 - 18.126924692201818)).epsilon(1e-12));
}
// [damping_needed]

TEST_CASE(
    "20 s of fall at 30, 60 and 240 Hz, to 1e-3: which ways agree with 84.82 m/s", "[case:I5]")
{
  CHECK(worst_speed(methods[0], long_fall) > 0.7);
  CHECK(worst_speed(methods[1], long_fall) == Catch::Approx(2.8e-3).epsilon(0.01));
  CHECK(worst_speed(methods[2], long_fall) == Catch::Approx(5.2e-4).epsilon(0.01));
  // The final speed lacks gh/2, of which 1 - e^-2 shows after 20 s: half a step's fall in 98.1.
  CHECK(worst_speed(methods[3], long_fall) == Catch::Approx(9.81 / 60 / 98.1).epsilon(0.01));
  CHECK(worst_speed(methods[4], long_fall) <= 1e-6);
  CHECK(worst_speed(methods[5], long_fall) <= 1e-12);
}

// [X22]
TEST_CASE("0.98 a step, g = 9.82: final speeds of 16.04, 8.02 and 2.00 m/s", "[case:X22]")
{
  const std::vector<std::pair<double, double>> speeds{{30, 16.04}, {60, 8.02}, {240, 2.00}};
  for (const auto& [rate, speed] : speeds)
  {
    double velocity = 0;
    for (int i = 0; i < 5000; ++i)
    {
      velocity = damped_as_published(velocity, 9.82, 0.98, 1 / rate);
    }
    CHECK(velocity == Catch::Approx(speed).margin(0.006));
    CHECK(velocity == Catch::Approx(9.82 / rate * 49).epsilon(1e-12)); // g h q/(1 - q)
  }
}
// [X22]

// [I6]
TEST_CASE(
    "at 10,000 Hz a step adds 0.98 mm/s, which the threshold takes away", "[case:I6][case:X23]")
{
  CHECK(damped_end(methods[0], free_fall, 1e4).position == 0);
  CHECK(damped_end(methods[0], free_fall, 60).position == Catch::Approx(-490.5).epsilon(1e-9));
  for (std::size_t i = 1; i < methods.size(); ++i)
  {
    INFO(methods[i].name);
    CHECK(std::abs(damped_end(methods[i], free_fall, 1e4).position + 490.5) <= 0.1);
  }
}
// [I6]

TEST_CASE("what holds and what fails at damping", "[case:I5][case:I6][case:X22]")
{
  check_verdicts(
      damping_verdicts(), names_of(methods),
      {{"I5", {"1/(1 + c·step)", "exp mid-kick", "damped_fall"}},
       {"X22", {"1/(1 + c·step)", "exp mid-kick", "damped_fall"}},
       {"no gravity, 1 s, c = 1.21/s, 30 to 240 Hz: speed to 1 %",
        {"exp(−c·step)", "exp mid-kick", "damped_fall"}},
       {"brake, c = 150/s at 60 Hz: stops",
        {"as published", "1/(1 + c·step)", "exp(−c·step)", "exp mid-kick", "damped_fall"}},
       {"I6", {"1 − c·step", "1/(1 + c·step)", "exp(−c·step)", "exp mid-kick", "damped_fall"}}});
}
