/// \file
/// What holds for the ways to take an overlap away: formulas R11, R12, R13 and R14.

#include "05_resolution/position_correction/position_correction.hpp"
#include "05_resolution/position_correction/trial/position_correction_cases.hpp"
#include "05_resolution/position_correction/trial/position_correction_scenes.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <cmath>

using namespace cookbook;

namespace
{

/// A few roundings of numbers of size one.
constexpr double rounding = 1e-15;

const Rational share = Rational(1) / 5;

/// A unit mass on a spring to its place zero, contact or not, after a step of the implicit method:
/// v' = v − h (ω² x' + 2 ζ ω v'), x' = x + h v', solved for v' by hand.
Rational implicit_speed(
    const Rational& x, const Rational& v, const Rational& w, const Rational& z, const Rational& h)
{
  return (v - h * w * w * x) / (1 + 2 * z * w * h + h * h * w * w);
}

} // namespace

// [R11]
TEST_CASE("half a metre at β = 1/5 and 60 Hz is pushed out at 6 m/s, exactly", "[R11]")
{
  const Rational rate = share * 60;
  CHECK(bias_velocity<Rational>(Rational(1) / 2, 0, rate, 100) == 6);
  CHECK(bias_velocity<Rational>(Rational(1) / 2, Rational(1) / 10, rate, 100) == Rational(24) / 5);
  CHECK(bias_velocity<Rational>(Rational(1) / 2, 0, rate, 3) == 3);
  CHECK(bias_velocity<Rational>(Rational(1) / 10, Rational(1) / 10, rate, 100) == 0);
  CHECK(bias_velocity<Rational>(-1, 0, rate, 100) == 0);
}

TEST_CASE(
    "6 m/s make the cube hop 36 / 2 g = 1.83 m, and half a step of gravity more", "[R11][case:S18]")
{
  const Recovery found = recovery(run_out({}, corrections()[1], 2));
  CHECK(found.fastest == Catch::Approx(6).epsilon(rounding));
  const double hop = found.highest + 0.5;
  CHECK((hop > 1.83 && hop < 1.83 + 6 * frame_time));
  // The first step moves at 6, the next at 6 − g h, and so on, down to zero.
  double sum = 0;
  for (double speed = 6; speed > 0; speed -= earth_gravity * frame_time)
  {
    sum += speed * frame_time;
  }
  CHECK(hop == Catch::Approx(sum).epsilon(1e-13));
}
// [R11]

// [R12]
TEST_CASE("k passes of β leave (1 − β)^k of what is beyond the slop, exactly", "[R12]")
{
  const Rational slop = Rational(1) / 100;
  Rational depth = Rational(1) / 2, left = depth - slop;
  for (int pass = 0; pass < 30; ++pass)
  {
    depth -= position_correction(depth, slop, share);
    left *= 1 - share;
    CHECK(depth == slop + left);
  }
  CHECK(position_correction<Rational>(slop, slop, share) == 0);
  CHECK(position_correction<Rational>(-1, slop, share) == 0);
}

TEST_CASE("four passes a frame bring 0.5 m to 1 mm + 0.499 · 0.8^4k", "[R12]")
{
  const std::vector<SunkCube> rows = run_out({}, corrections()[3], 0.2);
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    CHECK(
        -rows[k].bottom ==
        Catch::Approx(0.001 + 0.499 * std::pow(0.8, 4.0 * double(k))).epsilon(1e-13));
  }
}
// [R12]

// [R13]
TEMPLATE_TEST_CASE(
    "30 Hz, ζ = 10, 240 steps a second: 9.0687, 0.9423, 0.0577", "[R13]", float, double)
{
  const Softness<TestType> soft = softness<TestType>(30, 10, TestType(1) / 240);
  CHECK(std::abs(soft.bias_rate - TestType(9.0687)) <= TestType(5e-5));
  CHECK(std::abs(soft.mass_scale - TestType(0.9423)) <= TestType(5e-5));
  CHECK(std::abs(soft.impulse_scale - TestType(0.0577)) <= TestType(5e-5));
}

TEST_CASE("ω = 3, ζ = 2, h = 1/4: a₁ = 19/4, a₂ = 57/16, a₃ = 16/73", "[R13]")
{
  const Softness<Rational> soft = softness_of<Rational>(3, 2, Rational(1) / 4);
  CHECK(soft.bias_rate == Rational(12) / 19);
  CHECK(soft.mass_scale == Rational(57) / 73);
  CHECK(soft.impulse_scale == Rational(16) / 73);
}

TEST_CASE(
    "without a frequency there is no spring; a rigid contact gives all and takes nothing", "[R13]")
{
  const Softness<double> none = softness(0.0, 0.0, 1.0 / 240);
  CHECK(soft_change(none, 1.0, -3.0, 0.0, 0.0) == 0);
  CHECK(soft_change(none, 1.0, -3.0, 0.0, 2.0) == -2);
  CHECK(soft_change(rigid<double>(), 2.0, -3.0, 0.0, 2.0) == 6);
  CHECK(soft_change(rigid<double>(), 2.0, -3.0, 1.0, 2.0) == 8);
}

TEST_CASE("a contact takes back what it gave, and no more; the immovable gets nothing", "[R13]")
{
  CHECK(soft_change(rigid<double>(), 1.0, 5.0, 0.0, 2.0) == -2);
  CHECK(soft_change(rigid<double>(), 1.0, 1.0, 0.0, 2.0) == -1);
  CHECK(soft_change(softness(30.0, 10.0, 1.0 / 240), 0.0, -1.0, 0.0, 0.0) == 0);
}
// [R13]

// [R14]
TEST_CASE(
    "a soft push is a step of the implicit spring, exactly, for any stiffness and mass", "[R14]")
{
  for (const Rational& w : {Rational(1) / 100, Rational(3), Rational(1000000)})
  {
    for (const Rational& z : {Rational(0), Rational(1) / 7, Rational(10)})
    {
      for (const Rational& mass : {Rational(1) / 1000, Rational(1), Rational(1000)})
      {
        const Rational h = Rational(1) / 60, x = Rational(-1) / 8, v = Rational(-5) / 3;
        const Softness<Rational> soft = softness_of<Rational>(w, z, h);
        const Rational impulse = soft_change<Rational>(soft, mass, v, soft.bias_rate * -x, 0);
        CHECK(v + impulse / mass == implicit_speed(x, v, w, z, h));
        // A second push finds nothing left to do.
        CHECK(
            soft_change<Rational>(soft, mass, v + impulse / mass, soft.bias_rate * -x, impulse) ==
            0);
      }
    }
  }
}

TEST_CASE("whatever the frequency times the step, energy of spring and mass never grows", "[R14]")
{
  const Rational h = 1;
  for (const Rational& w : {Rational(1) / 1000, Rational(1) / 2, Rational(2), Rational(1000)})
  {
    for (const Rational& z : {Rational(0), Rational(1), Rational(10)})
    {
      Rational x = -1, v = Rational(1) / 3;
      for (int step = 0; step < 6; ++step)
      {
        const Rational before = v * v + w * w * x * x;
        v = implicit_speed(x, v, w, z, h);
        x += h * v;
        CHECK(v * v + w * w * x * x < before);
      }
    }
  }
}

TEST_CASE("at rest a soft contact of 30 Hz sinks by g / ω² = 0.276 mm, whatever the mass", "[R14]")
{
  const double turn = 2 * std::numbers::pi * 30;
  for (const double mass : {0.001, 1.0, 1000.0})
  {
    SunkCube cube;
    cube.bottom = 0;
    cube.mass = mass;
    const SunkCube late = run_out(cube, corrections().back(), 20).back();
    CHECK(-late.bottom == Catch::Approx(earth_gravity / (turn * turn)).epsilon(1e-6));
    CHECK(std::abs(late.speed) <= 1e-9);
    CHECK(late.impulses[0] == Catch::Approx(mass * earth_gravity * frame_time / 4).epsilon(1e-9));
  }
}
// [R14]

// [ways_out]
TEST_CASE("a soft push that is not relaxed keeps its speed and hops 12 cm at 3 m/s", "[case:S18]")
{
  const auto highest = [](bool relax)
  {
    const Correction way{"", [=](SunkCube& cube) { push_softly(cube, 30, push_limit, relax); }};
    return recovery(run_out({}, way, 2)).highest;
  };
  CHECK(highest(true) <= 0);
  CHECK((highest(false) > 0.1 && highest(false) < 0.15));
}

TEST_CASE(
    "uncapped, split impulse moves a cube at 6 m/s that has no speed of its own", "[case:S18]")
{
  const Correction way{"", [](SunkCube& cube) { push_beside_speed(cube, no_limit); }};
  const Recovery found = recovery(run_out({}, way, 2));
  CHECK(found.jump == Catch::Approx(0.1).epsilon(1e-12));
  CHECK(found.fastest <= rounding);
  // Each frame leaves four fifths.
  CHECK(-run_out({}, way, 1).back().bottom == Catch::Approx(0.5 * std::pow(0.8, 60)).epsilon(1e-9));
}

TEST_CASE(
    "two tiles that report one overlap are projected out of twice: half a metre up", "[case:S18]")
{
  SunkCube cube;
  cube.impulses = {0, 0};
  CHECK(
      run_out(cube, corrections()[0], frame_time)[1].bottom ==
      Catch::Approx(0.5).epsilon(rounding));
  for (const std::size_t way : {3u, 4u, 5u})
  {
    CHECK(recovery(run_out(cube, corrections()[way], 2)).highest <= 0);
  }
}
// [ways_out]

TEST_CASE("what holds and what fails at a cube inside the floor", "[case:S18]")
{
  check_verdicts(
      correction_verdicts(), names_of(corrections()),
      {{"S18",
        {"projection", "non-linear Gauss–Seidel, 4 passes", "split impulse, ≤ 3 m/s",
         "soft, 30 Hz, ≤ 3 m/s"}},
       {"the same: no jump of more than 4 m/s",
        {"Baumgarte, ≤ 3 m/s", "split impulse, ≤ 3 m/s", "soft, 30 Hz, ≤ 3 m/s"}},
       {"two tiles report it: ends on the floor",
        {"non-linear Gauss–Seidel, 4 passes", "split impulse, ≤ 3 m/s", "soft, 30 Hz, ≤ 3 m/s"}},
       {"cube at rest, 10 s: at most 1.5 mm deep",
        {"projection", "Baumgarte", "Baumgarte, ≤ 3 m/s", "non-linear Gauss–Seidel, 4 passes",
         "split impulse, ≤ 3 m/s", "soft, 30 Hz, ≤ 3 m/s"}}});
}
