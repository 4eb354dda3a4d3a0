/// \file
/// What holds for a body that spins freely: formulas R24 and R25, and where ways to step it fail.

#include "05_resolution/spinning_bodies/mean_spin.hpp"
#include "05_resolution/spinning_bodies/spinning_bodies.hpp"
#include "05_resolution/spinning_bodies/trial/spinning_bodies_cases.hpp"
#include "05_resolution/spinning_bodies/trial/steady_spin_cases.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

using namespace cookbook;

namespace
{

/// A few roundings of numbers of size one: double's unit roundoff is 1.1e-16.
constexpr double rounding = 1e-15;

/// Whole numbers from -9 to 9, the same ones every time.
class Whole
{
public:
  int next()
  {
    seed_ = seed_ * 1664525u + 1013904223u;
    return static_cast<int>(seed_ >> 8) % 19 - 9;
  }
  template <class Real>
  Vector3<Real> vector()
  {
    const int x = next(), y = next();
    return {Real(x), Real(y), Real(next())};
  }
  template <class Real>
  Vector3<Real> positive()
  {
    return vector<Real>() + Vector3<Real>::Constant(Real(10));
  }

private:
  std::uint32_t seed_ = 1;
};

/// A method by its name.
SpinMethod method_called(const std::string& name)
{
  for (const SpinMethod& method : spin_methods())
  {
    if (method.name == name)
    {
      return method;
    }
  }
  throw std::logic_error(name);
}

/// How far [rad] from the truth the orientation of case I4 is after 10 s.
double orientation_error(const std::string& name, double rate)
{
  static const Quaternion<double> right = true_orientation(tennis_racket(), 10);
  const auto nothing = [](double, const Spinning<double>&) {};
  const Spinning<double> end = stepped(tennis_racket(), method_called(name), 10, rate, nothing);
  return angle_between(end.orientation, right);
}

} // namespace

// [term_left_out]
TEST_CASE("a cube and a ball need no gyroscopic term: with and without it is the same")
{
  Spinning<double> body{Quaternion<double>::Identity(), {1, 2, 3}};
  const Vector3<double> cube(2, 2, 2);
  Spinning<double> with = body;
  for (int i = 0; i < 600; ++i)
  {
    with = turned<double>(with, cube, 1 / 60.0);
    body = without_term<double>(body, cube, 1 / 60.0);
  }
  CHECK(with.angular_velocity == Vector3<double>(1, 2, 3)); // to the last bit
  CHECK((body.angular_velocity - with.angular_velocity).norm() <= 1000 * rounding);
  CHECK(angle_between(body.orientation, with.orientation) <= 1000 * rounding);
}
// [term_left_out]

// [term_needed]
TEST_CASE("a racket needs it: without it, it never turns over")
{
  CHECK(spin_run(tennis_racket(), method_called("no term"), 10, 60).flips.empty());
  CHECK(spin_run(tennis_racket(), method_called("turned"), 10, 60).flips.size() == 4);
}
// [term_needed]

// [A5]
TEST_CASE("at 50 rad/s and 60 Hz a quaternion added lags 150° a second, and grows 122 times")
{
  const TurnCase second{"", "", {0, 50, 0}, 1, 60, 1e-3};
  const std::vector<Quaternion<double>> ways = turned_in_four_ways(second);
  const Quaternion<double> right = rotation_by<double>(second.spin);
  const double degree = std::numbers::pi / 180;
  CHECK(ways[1].norm() == Catch::Approx(122).margin(0.5));
  CHECK(angle_between(ways[2], right) == Catch::Approx(150 * degree).margin(0.5 * degree));
  CHECK(angle_between(ways[3], right) <= 100 * rounding);
}

TEST_CASE("what holds and what fails at steady spins", "[case:A5][case:A6][case:X24]")
{
  // One axis alone is no trouble for angles.
  check_verdicts(
      turn_verdicts(),
      {"angles added, as published", "quaternion added", "added, length one", "rotation_by"},
      {{"A5", {"angles added, as published", "rotation_by"}},
       {"A6", {"rotation_by"}},
       {"X24", {"rotation_by"}}});
}
// [A5]

// [X24]
TEST_CASE("angles added at (1, 1, 1) rad/s are off by 170.7° after 2 s, at any rate", "[case:X24]")
{
  for (const double rate : {0.5, 60.0, 960.0})
  {
    const TurnCase one{"", "", {1, 1, 1}, 2, rate, 1e-6};
    const std::vector<Quaternion<double>> ways = turned_in_four_ways(one);
    const double off = angle_between(ways[0], rotation_by<double>({2, 2, 2}));
    CHECK(off * 180 / std::numbers::pi == Catch::Approx(170.7).margin(0.05));
    CHECK(angle_between(ways[3], rotation_by<double>({2, 2, 2})) <= 2000 * rounding);
  }
}
// [X24]

// [R24]
TEST_CASE("moments 1, 2, 3 and spin (1, 1, 1): the spin changes by (-1, 1, -1/3)", "[R24]")
{
  const Vector3<Rational> change = gyroscopic_acceleration<Rational>({1, 2, 3}, {1, 1, 1});
  CHECK(change == Vector3<Rational>(-1, 1, Rational(-1) / 3));
}

TEST_CASE("Euler's equations keep energy and the length of L, exactly, for 100 bodies", "[R24]")
{
  Whole whole;
  for (int i = 0; i < 100; ++i)
  {
    const Vector3<Rational> moments = whole.positive<Rational>(), spin = whole.vector<Rational>();
    const Vector3<Rational> momentum = moments.cwiseProduct(spin);
    const Vector3<Rational> change =
        moments.cwiseProduct(gyroscopic_acceleration<Rational>(moments, spin));
    CHECK(change.dot(spin) == 0);     // of ω·Iω / 2
    CHECK(change.dot(momentum) == 0); // of |Iω|² / 2
    CHECK(change == Vector3<Rational>(-spin.cross(momentum)));
  }
}

TEST_CASE(
    "100 s at 60 Hz: |L| to 1e-10; energy to 1e-4 by turned, 1e-6 by turned_finely, 1e-10 with "
    "energy",
    "[R24][long]")
{
  for (const Vector3<double>& spin :
       {tennis_racket().spin, Vector3<double>(6, 6, 6), Vector3<double>(10, 0.01, 0.01),
        Vector3<double>(0.01, 0.01, 10), Vector3<double>(-3, 9, 1)})
  {
    const FreeSpin scene{"", {1, 2, 3}, spin};
    const SpinRun cheap = spin_run(scene, method_called("turned"), 100, 60);
    const SpinRun best = spin_run(scene, method_called("turned_finely"), 100, 60);
    const SpinRun kept = spin_run(scene, method_called("turned_with_energy"), 100, 60);
    CHECK(cheap.momentum_drift <= 1e-10);
    CHECK(cheap.momentum_turn <= 1e-10);
    CHECK(cheap.energy_drift <= 1e-4);
    CHECK(best.momentum_drift <= 1e-10);
    CHECK(best.momentum_turn <= 1e-10);
    CHECK(best.energy_drift <= 1e-6);
    CHECK(kept.momentum_drift <= 1e-10);
    CHECK(kept.momentum_turn <= 1e-10);
    CHECK(kept.energy_drift <= 1e-10);
  }
}

TEST_CASE("a coin's spin is two steady turns, in one step of 10 s or in 600", "[R24]")
{
  // Moments 1, 1, 2 and spin (3, 0, 8): L = (3, 0, 16). In the world the coin turns about L by
  // L/1 a second, on its own axis by 16 (1/2 - 1).
  const Vector3<double> coin(1, 1, 2);
  const Spinning<double> start{Quaternion<double>::Identity(), {3, 0, 8}};
  const Quaternion<double> right =
      rotation_by<double>({30, 0, 160}) * rotation_by<double>({0, 0, -80});
  Spinning<double> small = start;
  for (int i = 0; i < 600; ++i)
  {
    small = turned<double>(small, coin, 1 / 60.0);
  }
  // Angles of 160 rad are known to 160 roundings.
  CHECK(angle_between(turned<double>(start, coin, 10).orientation, right) <= 400 * rounding);
  CHECK(angle_between(small.orientation, right) <= 2000 * rounding);
}

TEST_CASE(
    "half the step: a quarter of turned's error, a sixteenth of turned_finely's", "[R24][long]")
{
  CHECK(
      orientation_error("turned", 60) / orientation_error("turned", 120) ==
      Catch::Approx(4).margin(0.2));
  CHECK(
      orientation_error("turned_finely", 30) / orientation_error("turned_finely", 60) ==
      Catch::Approx(16).margin(1));
}

TEST_CASE("a body swings by half a radian at most in each part of a step, of 16 at most", "[R24]")
{
  const auto parts = [](double swing)
  {
    SpinAxes<double> axes{{1, 1, 1}, 1, {0, 2}, {2, -2}};
    return std::pair(cut(axes, 1.0, swing / 2), axes.third.rate);
  };
  for (const auto& [swing, count] : {std::pair(0.1, 1), {0.49, 1}, {0.51, 2}, {1.2, 3}, {7.9, 16}})
  {
    CAPTURE(swing);
    CHECK(parts(swing) == std::pair(count, -2.0));
    CHECK(parts(-swing) == std::pair(count, -2.0));
  }
  CHECK(parts(8.1) == std::pair(1, 0.0));
}

TEST_CASE("a step back undoes a step, for 100 bodies", "[R24]")
{
  Whole whole;
  for (int i = 0; i < 100; ++i)
  {
    const Vector3<double> moments = whole.positive<double>(), spin = whole.vector<double>();
    const Spinning<double> start{Quaternion<double>(0.5, -0.5, 0.5, 0.5), spin};
    const Spinning<double> there = turned_finely<double>(start, moments, 0.01);
    const Spinning<double> back = turned_finely<double>(there, moments, -0.01);
    CHECK(angle_between(back.orientation, start.orientation) <= 20 * rounding);
    CHECK((back.angular_velocity - spin).norm() <= 100 * rounding * (1 + spin.norm()));
  }
}
// [R24]

// [mean_spin]
/// A body that turns by a fraction of what is little, about a direction, in a step of one.
Spinning<double>
little_turning(const Vector3<double>& moments, const Vector3<double>& way, double share)
{
  const double most = little_turn * moments.minCoeff() / moments.maxCoeff();
  return {Quaternion<double>(0.5, -0.5, 0.5, 0.5), way.normalized() * (share * most)};
}

TEST_CASE("about the mean: angular momentum and energy stay to rounding, up to the largest turn")
{
  Whole whole;
  for (int i = 0; i < 200; ++i)
  {
    const Vector3<double> moments = whole.positive<double>();
    const Vector3<double> way = whole.vector<double>() + Vector3<double>(0.5, 0, 0);
    for (const double share : {0.999, 0.3, 1e-3, 1e-9})
    {
      Spinning<double> body = little_turning(moments, way, share);
      const double spin = body.angular_velocity.norm();
      REQUIRE(turns_little(moments, spin));
      const double energy = doubled_energy(body, moments);
      const Vector3<double> momentum = angular_momentum(body, moments);
      body = turned_about_mean<double>(body, moments, 1);
      CHECK(std::abs(doubled_energy(body, moments) - energy) <= 30 * rounding * energy);
      CHECK((angular_momentum(body, moments) - momentum).norm() <= 30 * rounding * momentum.norm());
      CHECK(std::abs(body.orientation.norm() - 1) <= rounding);
    }
  }
}

TEST_CASE("about the mean: a step back undoes a step; half the step, a quarter of the error")
{
  const Vector3<double> moments(1, 2, 3);
  const Spinning<double> start = little_turning(moments, {1, 2, 0.5}, 0.9);
  const Spinning<double> there = turned_about_mean<double>(start, moments, 1);
  const Spinning<double> back = turned_about_mean<double>(there, moments, -1);
  CHECK(angle_between(back.orientation, start.orientation) <= 10 * rounding);
  CHECK((back.angular_velocity - start.angular_velocity).norm() <= 10 * rounding);
  const auto off = [&](int steps)
  {
    Spinning<double> mean = start, fine = start;
    for (int i = 0; i < 8 * steps; ++i)
    {
      mean = turned_about_mean<double>(mean, moments, 1.0 / steps);
    }
    for (int i = 0; i < 800; ++i)
    {
      fine = turned_finely<double>(fine, moments, 0.01);
    }
    return angle_between(mean.orientation, fine.orientation);
  };
  CHECK(off(1) > 1e-6); // not rounding
  CHECK(off(1) / off(2) == Catch::Approx(4).margin(0.1));
}

TEST_CASE("about the mean: a cube turns by what rotation_by() says, to a ten-millionth")
{
  const Vector3<double> cube(2, 2, 2);
  const Spinning<double> start = little_turning(cube, {1, -2, 2}, 0.999);
  const Spinning<double> end = turned_about_mean<double>(start, cube, 1);
  const Quaternion<double> right = rotation_by<double>(start.angular_velocity) * start.orientation;
  CHECK(angle_between(end.orientation, right) <= 1e-7 * start.angular_velocity.norm());
  CHECK((end.angular_velocity - start.angular_velocity).norm() <= rounding);
}

TEST_CASE(
    "what turns little: less than a fifth of a radian, needles by as much less as they are thin")
{
  CHECK(turns_little<double>({2, 2, 2}, 0.19));
  CHECK_FALSE(turns_little<double>({2, 2, 2}, 0.2));
  CHECK(turns_little<double>({100, 1, 100}, 0.0019));
  CHECK_FALSE(turns_little<double>({100, 1, 100}, 0.0021));
  CHECK_FALSE(turns_little<double>({0, 0, 0}, 0)); // nothing could be found of its spin
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(turns_little<double>({1, 2, 3}, not_a_number));
}
// [mean_spin]

// [R25]
TEST_CASE("the Jacobian is the linear part of I(ω − ω₀) + h ω × Iω, exactly", "[R25]")
{
  Whole whole;
  for (int i = 0; i < 100; ++i)
  {
    const Vector3<Rational> moments = whole.positive<Rational>(), start = whole.vector<Rational>();
    const Vector3<Rational> spin = whole.vector<Rational>(), change = whole.vector<Rational>();
    const Rational step = Rational(1) / 60;
    const auto missed = [&](const Vector3<Rational>& at) -> Vector3<Rational>
    {
      const Vector3<Rational> momentum = moments.cwiseProduct(at);
      return moments.cwiseProduct(at - start) + step * at.cross(momentum);
    };
    const Vector3<Rational> square = step * change.cross(moments.cwiseProduct(change));
    const Matrix3<Rational> jacobian = gyroscopic_jacobian<Rational>(moments, spin, step);
    const Vector3<Rational> sum = spin + change;
    CHECK(Vector3<Rational>(missed(sum) - missed(spin)) == jacobian * change + square);
  }
}

TEST_CASE(
    "Newton's method solves the implicit step: to 0.02 in one step, to rounding in 4", "[R25]")
{
  const Vector3<double> moments(1, 2, 3), start(4, 5, 6);
  const double step = 1 / 60.0;
  const auto missed = [&](int iterations)
  {
    const Vector3<double> spin = implicit_spin<double>(moments, start, step, iterations);
    return (spin - start - step * gyroscopic_acceleration<double>(moments, spin)).norm();
  };
  CHECK(missed(1) <= 0.02);
  CHECK(missed(1) >= 1e-4);
  CHECK(missed(4) <= 20 * rounding);
  const Vector3<double> solved = implicit_spin<double>(moments, start, step, 4);
  for (const double unit : {1e-300, 1e300}) // only proportions count
  {
    CHECK(implicit_spin<double>(unit * moments, start, step, 4).isApprox(solved, 20 * rounding));
  }
}

TEST_CASE("solved to the end or not, the implicit step loses energy; the midpoint none", "[R25]")
{
  const Vector3<double> moments(1, 2, 3), start(4, 5, 6);
  const auto energy = [&](const Vector3<double>& spin)
  { return moments.cwiseProduct(spin).dot(spin); };
  const double step = 1 / 60.0;
  CHECK(energy(implicit_spin<double>(moments, start, step, 1)) < 0.999 * energy(start));
  CHECK(energy(implicit_spin<double>(moments, start, step, 9)) < 0.999 * energy(start));
  const Spinning<double> body{Quaternion<double>::Identity(), start};
  const Spinning<double> after = implicit_midpoint<double>(body, moments, step);
  CHECK(doubled_energy(after, moments) == Catch::Approx(energy(start)).epsilon(10 * rounding));
}
// [R25]

// [flip_times]
TEST_CASE("elliptic integrals: K(√½) = Γ(¼)²/(4√π), F + F = K, and F without modulus is φ")
{
  const double half = std::sqrt(0.5);
  const double gamma = std::tgamma(0.25);
  const double right = gamma * gamma / (4 * std::sqrt(std::numbers::pi));
  CHECK(quarter_period(half) == Catch::Approx(right).epsilon(10 * rounding));
  CHECK(elliptic_integral(0.7, 1) == Catch::Approx(0.7).epsilon(rounding));
  for (const double complement : {0.9, 0.5, 0.01, 1e-6})
  {
    // Amplitudes whose tangents have the product 1/k' share the quarter period; one close to a
    // right angle is known to a rounding, and its integral to 1/k' times that.
    const double other = std::atan2(1, complement * std::tan(0.7));
    const double sum = elliptic_integral(0.7, complement) + elliptic_integral(other, complement);
    CHECK(sum == Catch::Approx(quarter_period(complement)).epsilon(4 * rounding / complement));
  }
}

TEST_CASE("the racket flips at 1.4906, 4.2437 and 6.9968 s", "[case:I4]")
{
  const std::array<double, 3> right{1.4906, 4.2437, 6.9968};
  const std::array<double, 3> closed = flip_times({1, 2, 3}, {0.01, 10, 0.01});
  const SpinRun run = spin_run(tennis_racket(), method_called("turned_finely"), 10, 60);
  REQUIRE(run.flips.size() == 4);
  for (std::size_t i = 0; i < 3; ++i)
  {
    CHECK(std::abs(closed[i] - right[i]) <= 5e-5);
    CHECK(std::abs(run.flips[i] - closed[i]) <= 1e-4); // a straight line between two steps
  }
}

TEST_CASE("the closed form and turned_finely agree on the flips of other bodies to 1e-4 s")
{
  for (const FreeSpin& scene :
       {FreeSpin{"", {1, 1.5, 2}, {5, 5, 5}}, FreeSpin{"", {0.04, 1, 1.04}, {1, 7, 5}},
        FreeSpin{"", {1, 2, 3}, {0.03, 10, -0.01}}, FreeSpin{"", {1, 2, 3}, {0.1, -8, 0.1}}})
  {
    const std::array<double, 3> closed = flip_times(scene.moments, scene.spin);
    const SpinRun run = spin_run(scene, method_called("turned_finely"), 10, 480);
    REQUIRE(run.flips.size() >= 3);
    for (std::size_t i = 0; i < 3; ++i)
    {
      CHECK(std::abs(run.flips[i] - closed[i]) <= 1e-4);
    }
  }
}
// [flip_times]

// [I4]
TEST_CASE("the racket, 10 s at 60 Hz: energy × 2.585, × 0.526, or no flip at all", "[case:I4]")
{
  const auto run = [](const std::string& name)
  { return spin_run(tennis_racket(), method_called(name), 10, 60); };
  CHECK(run("explicit").energy_ratio == Catch::Approx(2.585).margin(0.0005));
  CHECK(run("implicit, 1 Newton step").energy_ratio == Catch::Approx(0.526).margin(0.0005));
  CHECK(run("no term").flips.empty());
  // Kept in length, the explicit term's momentum leaves its place, and the flips come late.
  const SpinRun clamped = run("explicit, clamped");
  CHECK(clamped.energy_drift <= 1e-6);
  CHECK(clamped.momentum_drift <= 1e-10);
  CHECK(clamped.momentum_turn > 0.05);
  CHECK(clamped.flips[2] > 1.1 * flip_times({1, 2, 3}, {0.01, 10, 0.01})[2]);
}

TEST_CASE("what holds and what fails at free spins", "[case:I4][long]")
{
  check_verdicts(
      spin_verdicts(), names_of(spin_methods()),
      {{"I4",
        {"implicit midpoint", "Runge–Kutta", "axes in turn", "turned", "turned_with_energy",
         "turned_finely"}},
       {"the same for 100 s",
        {"implicit midpoint", "turned", "turned_with_energy", "turned_finely"}},
       {"a sword, moments 1, 0.0008, 1.0007, 10 rad/s",
        {"implicit midpoint", "Runge–Kutta", "turned", "turned_with_energy", "turned_finely"}},
       {"a plank, moments 0.04, 1, 1.04, 170 rad/s",
        {"turned", "turned_with_energy", "turned_finely"}},
       {"a coin, moments 1, 1, 2, 9 rad/s",
        {"implicit midpoint", "turned", "turned_with_energy", "turned_finely"}},
       {"a grain, a plank of 1e-40 kg m², 4e6 rad/s",
        {"turned", "turned_with_energy", "turned_finely"}}});
}
// [I4]

// [sword]
TEST_CASE("one axis after the other gives a sword 100 times its energy; turned keeps it to 1e-6")
{
  const FreeSpin sword{"", {1, 8e-4, 1.0007}, {7, 3, 7}};
  CHECK(spin_run(sword, method_called("axes in turn"), 10, 60).energy_drift > 100);
  CHECK(spin_run(sword, method_called("turned"), 10, 60).energy_drift <= 1e-6);
}
// [sword]

// [cost]
TEST_CASE(
    "at 60 Hz turned is ten times nearer than axes in turn; finely, 15 Hz beats it by far",
    "[long]")
{
  CHECK(orientation_error("turned", 60) < 0.1 * orientation_error("axes in turn", 60));
  CHECK(orientation_error("turned_finely", 15) < 0.1 * orientation_error("turned", 60));
  CHECK(orientation_error("turned_finely", 60) < 1e-6);
}
// [cost]

TEST_CASE("the spin's first axis is that whose inverse moment is farthest from the middle one's")
{
  // In units of the largest, one over the moments: 4, 2, 1 and 5, 4, 1.
  struct Of
  {
    std::array<double, 3> moments;
    double ball, first, third; ///< rates
    double about;              ///< the moment about the first axis
  };
  for (const Of& of : {Of{{1, 2, 4}, 2, 2, -1, 1}, Of{{4, 5, 20}, 4, -3, 1, 20}})
  {
    std::array<double, 3> moments = of.moments;
    do
    {
      const SpinAxes<double> axes = spin_axes<double>({moments[0], moments[1], moments[2]});
      CAPTURE(moments);
      CHECK(axes.ball_rate == Catch::Approx(of.ball));
      CHECK(axes.main.rate == Catch::Approx(of.first));
      CHECK(axes.third.rate == Catch::Approx(of.third));
      CHECK(moments[static_cast<std::size_t>(axes.main.index)] == of.about);
    } while (std::next_permutation(moments.begin(), moments.end()));
  }
}

// [any_spin]
TEMPLATE_TEST_CASE(
    "no moments, no spin and no step make a body that is not a number", "", float, double)
{
  std::vector<TestType> sizes{0, std::numeric_limits<TestType>::denorm_min()};
  for (int power = -36; power <= 36; power += 8)
  {
    sizes.push_back(static_cast<TestType>(std::pow(10, power)));
  }
  const Quaternion<TestType> start(TestType(0.5), TestType(0.5), TestType(-0.5), TestType(0.5));
  for (const TestType a : sizes)
  {
    for (const TestType b : sizes)
    {
      for (const TestType spin : sizes)
      {
        for (const TestType step : {TestType(1e-30), TestType(1) / 60, TestType(1e30)})
        {
          CAPTURE(a, b, spin, step);
          const Spinning<TestType> body{start, {spin, a, -spin}};
          const Spinning<TestType> after = turned<TestType>(body, {a, b, 1}, step);
          REQUIRE(after.orientation.coeffs().allFinite());
          REQUIRE(after.angular_velocity.allFinite());
        }
      }
    }
  }
}

TEST_CASE("moments 2^-130 times as large make no difference, to the last bit")
{
  Spinning<double> body{Quaternion<double>::Identity(), {1, 7, 5}}, tiny = body;
  const Vector3<double> moments(0.04, 1, 1.04);
  for (int i = 0; i < 600; ++i)
  {
    body = turned<double>(body, moments, 1 / 60.0);
    tiny = turned<double>(tiny, std::ldexp(1, -130) * moments, 1 / 60.0);
  }
  CHECK(body.orientation.coeffs() == tiny.orientation.coeffs());
  CHECK(body.angular_velocity == tiny.angular_velocity);
}

TEST_CASE("at a million rad/s |L| stays, and the energy within the closest moments' ratio 3/2")
{
  const FreeSpin wild{"", {1, 2, 3}, {6e5, 6e5, 6e5}};
  const SpinRun run = spin_run(wild, method_called("turned"), 10, 60);
  CHECK(run.momentum_drift <= 1e-10);
  CHECK(run.momentum_turn <= 1e-10);
  CHECK(run.energy_drift <= 0.5);
}
// [any_spin]

// [truth]
TEST_CASE("the truth of the chart is right to 1e-9: half the step changes no more", "[long]")
{
  using Long = long double;
  Spinning<Long> body{Quaternion<Long>::Identity(), tennis_racket().spin.cast<Long>()};
  for (int i = 0; i < 10 * 1920; ++i)
  {
    body = turned_finely<Long>(body, {1, 2, 3}, Long(1) / 1920);
  }
  const Quaternion<double> right = true_orientation(tennis_racket(), 10);
  CHECK(angle_between(body.orientation.cast<double>(), right) <= 1e-9);
}
// [truth]
