/// \file
/// Springs: frequency and damping asked and got, closed forms, and that none gains energy.

#include "05_resolution/integrators/implicit_integrators.hpp"
#include "05_resolution/small_world/small_world.hpp"
#include "07_constraints/springs/exact_spring.hpp"
#include "07_constraints/springs/small_spring.hpp"
#include "07_constraints/springs/springs.hpp"
#include "07_constraints/springs/trial/spring_measure.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace cookbook;

namespace
{

const double pi = std::numbers::pi;

/// The way of a name.
SpringWay way_named(const std::string& name)
{
  const std::vector<SpringWay> ways = spring_ways();
  return *std::find_if(
      ways.begin(), ways.end(), [&](const SpringWay& way) { return way.name == name; });
}

/// How far frequency [1] and damping ratio [1] are off at most, for springs from 1 Hz to `most` and
/// ratios from 0 to 2.
struct SpringErrors
{
  double frequency = 0, ratio = 0;
};

SpringErrors errors_of(const std::string& name, double most, double step)
{
  SpringErrors errors;
  for (double frequency = 1; frequency <= most; frequency += 0.5)
  {
    for (int tenths = 0; tenths <= 20; ++tenths)
    {
      const SpringAsked asked{frequency, tenths / 10.0, step};
      const SpringAsked got = got_of(factors_of(way_named(name), asked), step);
      errors.frequency = std::max(errors.frequency, std::abs(got.frequency / frequency - 1));
      errors.ratio = std::max(errors.ratio, std::abs(got.damping_ratio - asked.damping_ratio));
    }
  }
  return errors;
}

/// The largest stretch in some steps of one way, from a stretch of one at rest.
double widest(const SpringWay& way, const SpringAsked& asked, int steps)
{
  PhasePoint<double> at{1, 0};
  double most = 0;
  for (int i = 0; i < steps; ++i)
  {
    at = way.step(at, asked);
    most = std::max(most, std::abs(at.position));
  }
  return most;
}

/// The largest stretch within ten seconds of a mass that several springs hold, one after the other.
double widest_of_many(int springs, const SpringCoefficients<double>& one)
{
  double x = 1, v = 0, most = 0;
  for (int step = 0; step < 600; ++step)
  {
    for (int i = 0; i < springs; ++i)
    {
      v = one.keeps * v + one.pulls * x;
    }
    x += v / 60;
    most = std::max(most, std::abs(x));
  }
  return most;
}

} // namespace

// [R37]
TEST_CASE("400 N/m and 8 N s/m on 4 kg are 10 rad/s and a damping ratio of 0.1", "[R37]")
{
  const SpringNumbers<double> spring = spring_numbers(400.0, 8.0, 4.0);
  CHECK(spring.frequency == Catch::Approx(10 / (2 * pi)).epsilon(1e-14));
  CHECK(spring.damping_ratio == Catch::Approx(0.1).epsilon(1e-14));
}

TEST_CASE("the impulse of a short step is the force k x + c v times the step, to 1e-6", "[R37]")
{
  const auto [frequency, ratio] = spring_numbers(400.0, 8.0, 4.0);
  const double step = 1e-8, x = 0.3, v = -2;
  const auto spring = spring_coefficients(frequency, ratio, step);
  const double force = -(400 * x + 8 * v);
  CHECK(spring_impulse(spring, 4.0, x, v) / step == Catch::Approx(force).epsilon(1e-6));
}
// [R37]

// [R38]
TEST_CASE("what the three Eulers do to a spring in a step is their closed forms, to 1e-12", "[R38]")
{
  for (const double z : {0.01, 0.1, 0.5, 1.0, 1.9, 2.5, 10.0})
  {
    for (const double ratio : {0.0, 0.1, 0.5, 2.0})
    {
      const SpringAsked asked{z / (2 * pi), ratio, 1};
      CAPTURE(z, ratio);
      const StepFactors by_explicit = factors_of(way_named("explicit Euler"), asked);
      CHECK(by_explicit.trace == Catch::Approx(2 - 2 * ratio * z).margin(1e-12));
      CHECK(by_explicit.determinant == Catch::Approx(1 - 2 * ratio * z + z * z).margin(1e-12));
      const StepFactors symplectic = factors_of(way_named("symplectic Euler"), asked);
      CHECK(symplectic.trace == Catch::Approx(2 - 2 * ratio * z - z * z).margin(1e-12));
      CHECK(symplectic.determinant == Catch::Approx(1 - 2 * ratio * z).margin(1e-12));
      const StepFactors by_implicit = factors_of(way_named("implicit Euler"), asked);
      const double d = 1 + 2 * ratio * z + z * z;
      CHECK(by_implicit.determinant == Catch::Approx(1 / d).epsilon(1e-12));
      CHECK(by_implicit.trace == Catch::Approx(2 * (1 + ratio * z) / d).epsilon(1e-12));
    }
  }
}
// [R38]

TEST_CASE("an undamped spring grows in a step as the figure's closed forms say, to 1e-6", "[R38]")
{
  const double most = std::numeric_limits<double>::infinity();
  for (double z = 0.0625; z < 4; z += 0.125)
  {
    const SpringAsked asked{z / (2 * pi), 0, 1};
    CAPTURE(z);
    const auto growth = [&](const std::string& name)
    { return factors_of(way_named(name), asked).growth(); };
    CHECK(growth("explicit Euler") == Catch::Approx(explicit_growth(z)).epsilon(1e-6));
    CHECK(growth("symplectic Euler") == Catch::Approx(symplectic_growth(z)).epsilon(1e-6));
    CHECK(growth("implicit Euler") == Catch::Approx(implicit_growth(z)).epsilon(1e-6));
    CHECK(growth("one impulse") == Catch::Approx(exact_growth(z, pi / 2)).epsilon(1e-6));
    CHECK(growth("two impulses") == Catch::Approx(exact_growth(z, pi)).epsilon(1e-6));
    CHECK(exact_growth(z, most) == 1);
  }
}

TEST_CASE("the two numbers of the Eulers are the steps of chapter 5, to 1e-12", "[R38]")
{
  const SpringAsked asked{3, 0.3, 1.0 / 60};
  const double w = 2 * pi * asked.frequency;
  const auto acceleration = [&](double x, double v)
  { return -w * w * x - 2 * asked.damping_ratio * w * v; };
  const PhasePoint<double> from{0.2, -1};
  const auto check = [&](const std::string& name, const PhasePoint<double>& right)
  {
    const PhasePoint<double> got = way_named(name).step(from, asked);
    CHECK(got.position == Catch::Approx(right.position).epsilon(1e-12));
    CHECK(got.velocity == Catch::Approx(right.velocity).epsilon(1e-12));
  };
  check("explicit Euler", explicit_euler(from, asked.step, acceleration));
  check("symplectic Euler", symplectic_euler(from, asked.step, acceleration));
  check("implicit Euler", implicit_euler(from, asked.step, acceleration));
}

TEST_CASE(
    "a compliance of 1/k, XPBD's, is implicit Euler's spring without damping, to 1e-12", "[R38]")
{
  const double step = 1.0 / 60, mass = 2, w = 2 * pi * 3, compliance = 1 / (mass * w * w);
  const double x = 0.2, v = -1, predicted = x + step * v;
  const double impulse = -predicted / (1 / mass + compliance / (step * step)); // times the step
  const PhasePoint<double> got = way_named("implicit Euler").step({x, v}, {3, 0, step});
  CHECK(got.position == Catch::Approx(predicted + impulse / mass).epsilon(1e-12));
}

// [explodes]
TEST_CASE(
    "explicit Euler makes 10 Hz a spring of 1e19 times the energy in a second, at 60 Hz", "[R38]")
{
  const SpringAsked asked{10, 0, 1.0 / 60};
  PhasePoint<double> at{1, 0};
  const double start = energy_of(at, asked);
  for (int step = 0; step < 60; ++step)
  {
    at = way_named("explicit Euler").step(at, asked);
  }
  const double z = 2 * pi * 10 / 60;
  CHECK(energy_of(at, asked) / start == Catch::Approx(std::pow(1 + z * z, 60)).epsilon(1e-9));
  CHECK(energy_of(at, asked) / start > 1e19);
}

TEST_CASE(
    "symplectic Euler holds an undamped spring of 19 Hz at 60 Hz, and 20 Hz explodes", "[R38]")
{
  CHECK(widest(way_named("symplectic Euler"), {19, 0, 1.0 / 60}, 6000) < 20);
  CHECK(widest(way_named("symplectic Euler"), {20, 0, 1.0 / 60}, 600) > 1e100);
}
// [explodes]

// [R39]
TEST_CASE(
    "one impulse: springs of 1 to 15 Hz at 60 Hz, and of 1 to 60 Hz in four substeps", "[R39]")
{
  for (const auto& [most, step] : {std::pair{15.0, 1.0 / 60}, std::pair{60.0, 1.0 / 240}})
  {
    const SpringErrors errors = errors_of("one impulse", most, step);
    CHECK(errors.frequency <= 1e-6); // of the frequency
    CHECK(errors.ratio <= 1e-6);
  }
}

TEST_CASE("implicit Euler damps a spring of 5 Hz at 60 Hz by 0.24 that is asked for none", "[R39]")
{
  const SpringErrors errors = errors_of("implicit Euler", 30, 1.0 / 60);
  CHECK(errors.frequency > 0.5);
  CHECK(errors.ratio > 0.6);
  const SpringAsked got =
      got_of(factors_of(way_named("implicit Euler"), {5, 0, 1.0 / 60}), 1.0 / 60);
  CHECK(got.damping_ratio == Catch::Approx(0.244).margin(0.001));
}
// [R39]

TEST_CASE("one impulse: no spring from 1e-4 to 1e6 Hz grows, none swings to more than √2", "[R39]")
{
  for (double frequency = 1e-4; frequency <= 1e6; frequency *= 1.7)
  {
    for (const double ratio : {0.0, 0.01, 0.5, 1.0, 2.0})
    {
      const SpringAsked asked{frequency, ratio, 1.0 / 60};
      CAPTURE(frequency, ratio);
      CHECK(factors_of(way_named("one impulse"), asked).growth() <= 1 + 1e-7);
      CHECK(widest(way_named("one impulse"), asked, 2000) <= std::sqrt(2.0) + 1e-9);
    }
  }
}

TEST_CASE("a spring of 1e6 Hz is a rigid joint: its stretch is gone after a step", "[R39]")
{
  const auto [keeps, pulls] = spring_coefficients(1e6, 0.0, 1.0 / 60);
  CHECK(keeps <= 1e-300);
  CHECK(pulls == Catch::Approx(-60).epsilon(1e-12));
}

TEST_CASE(
    "coefficients have no jump where a spring begins to be damped, nor at a ratio of 1", "[R39]")
{
  const double step = 1.0 / 60;
  const auto apart = [](const auto& one, const auto& other)
  { return std::max(std::abs(one.keeps - other.keeps), std::abs(one.pulls - other.pulls)); };
  CHECK(
      apart(
          spring_coefficients(15 - 1e-12, 0.0, step), spring_coefficients(15 + 1e-12, 0.0, step)) <
      1e-3);
  CHECK(
      apart(spring_coefficients(7.0, 1 - 1e-12, step), spring_coefficients(7.0, 1.0, step)) < 1e-9);
}

TEST_CASE("a frequency of zero is no spring; what no spring has is refused by its name", "[R39]")
{
  const auto none = spring_coefficients(0.0, 0.5, 1.0 / 60);
  CHECK(none.keeps == 1);
  CHECK(none.pulls == 0);
  const auto refused = [](double frequency, double ratio, double step, const std::string& words)
  {
    CHECK_THROWS_WITH(
        spring_coefficients(frequency, ratio, step),
        Catch::Matchers::ContainsSubstring(words + " is "));
    CHECK_THROWS_AS(spring_flow(frequency, ratio, step), std::invalid_argument);
  };
  refused(-1, 0, 1.0 / 60, "frequency");
  refused(1, std::nan(""), 1.0 / 60, "damping_ratio");
  refused(1, 0, 0, "step");
}

// [R40]
TEST_CASE("two impulses: springs of 1 to 30 Hz with ratios of 0 to 2 are right at 60 Hz", "[R40]")
{
  const SpringErrors errors = errors_of("two impulses", 30, 1.0 / 60);
  CHECK(errors.frequency <= 1e-6);
  CHECK(errors.ratio <= 1e-6);
}

TEST_CASE(
    "two impulses: no spring up to 1e6 Hz gains energy in any step, whatever its state", "[R40]")
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  double most = 0;
  for (int i = 0; i < inputs(20'000, 2'000); ++i)
  {
    const double frequency = std::pow(10, 1 + 5 * unit(random));
    const SpringAsked asked{frequency, i % 3 == 0 ? 0 : 1 + unit(random), 1.0 / 60};
    const double fast = i % 2 == 0 ? 1 : 2 * pi * frequency;
    const PhasePoint<double> at{unit(random), fast * unit(random)};
    const PhasePoint<double> next = way_named("two impulses").step(at, asked);
    most = std::max(most, energy_of(next, asked) / energy_of(at, asked));
  }
  CHECK(most <= 1 + 1e-9);
}

TEST_CASE("two impulses: an undamped spring of 29 Hz is where cos(ω t) says after 10 s", "[R40]")
{
  const SpringAsked asked{29, 0, 1.0 / 60};
  PhasePoint<double> at{1, 0};
  for (int step = 0; step < 600; ++step)
  {
    at = way_named("two impulses").step(at, asked);
  }
  CHECK(at.position == Catch::Approx(std::cos(2 * pi * 29 * 10)).margin(1e-9));
  CHECK(energy_of(at, asked) == Catch::Approx(energy_of({1, 0}, asked)).epsilon(1e-9));
}
// [R40]

// [bodies]
TEST_CASE(
    "two bodies of 2 and 3 kg on a spring of 5 Hz in the small world swing by cos(ω t)", "[R40]")
{
  using namespace small_world;
  const double step = 1.0 / 60;
  World world;
  world.gravity.setZero();
  add(world, sphere({0, 0, 0}, 0.1, 2));
  add(world, sphere({1.2, 0, 0}, 0.1, 3));
  RigidBody &a = world.bodies[0], &b = world.bodies[1];
  const SpringFlow<double> flow = spring_flow(5.0, 0.0, step);
  for (int i = 1; i <= 120; ++i)
  {
    const SpringPose<double> pose = spring_pose<double>(a, b, {a.motion.center, b.motion.center});
    const auto [before, after] = spring_kicks(flow, {pose.length - 1, pose.speed}, step);
    apply_impulse<double>(a, b, pose.arms, pose.mass * before * pose.along);
    small_world::step(world, step);
    apply_impulse<double>(a, b, pose.arms, pose.mass * after * pose.along);
    const double stretch = b.motion.center.x() - a.motion.center.x() - 1;
    CHECK(stretch == Catch::Approx(0.2 * std::cos(2 * pi * 5 * i * step)).margin(1e-9));
  }
}

TEST_CASE("a spring between corners of two turning boxes keeps their momenta to 1e-12", "[R39]")
{
  using namespace small_world;
  RigidBody a = box({0, 0, 0}, {0.1, 0.2, 0.3}, 1), b = box({1, 0.5, 0}, {0.3, 0.1, 0.2}, 4);
  a.motion.angular_velocity = {1, 2, 3};
  b.motion.velocity = {-1, 0, 2};
  const auto momenta = [&]
  {
    Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
    for (const RigidBody* body : {&a, &b})
    {
      const Vector3<double> momentum = body->motion.velocity / body->inverse_mass;
      const Vector3<double> spin = body->inverse_inertia.inverse() * body->motion.angular_velocity;
      sum.head<3>() += momentum;
      sum.tail<3>() += body->motion.center.cross(momentum) + spin;
    }
    return sum;
  };
  const Eigen::Matrix<double, 6, 1> before = momenta();
  const auto spring = spring_coefficients(8.0, 0.3, 1.0 / 60);
  const double impulse =
      apply_spring<double>(a, b, {{0.1, 0.2, 0.3}, {0.7, 0.4, -0.2}}, 0.5, spring);
  CHECK(std::abs(impulse) > 0.1);
  CHECK((momenta() - before).norm() <= 1e-12);
}
// [bodies]

// [load]
TEST_CASE(
    "a weight on a spring of 1 Hz and ratio 1 hangs 11 % too low at 60 Hz, and right with its load")
{
  using namespace small_world;
  const double step = 1.0 / 60;
  const auto spring = spring_coefficients(1.0, 1.0, step);
  const double right = 9.81 / (4 * pi * pi);
  const auto hangs = [&](double load)
  {
    RigidBody hook = sphere({0, 0, 0}, 0.1, 0), lamp = sphere({0, -1, 0}, 0.1, 2);
    for (int i = 0; i < 600; ++i)
    {
      apply_spring<double>(hook, lamp, {hook.motion.center, lamp.motion.center}, 1.0, spring, load);
      lamp.motion.velocity.y() -= step * 9.81;
      lamp.motion.center += step * lamp.motion.velocity;
    }
    return (-lamp.motion.center.y() - 1) / right;
  };
  CHECK(hangs(0) == Catch::Approx(1.109).margin(0.001));
  CHECK(hangs(load_speed(spring, 1.0, step, 9.81)) == Catch::Approx(1).epsilon(1e-9));
}
// [load]

// [small_spring]
TEST_CASE("in the small world a lamp hangs g/ω² low on springs of 1 to 40 Hz, to 1e-9", "[R39]")
{
  using namespace small_world;
  for (const double frequency : {1.0, 3.0, 40.0})
  {
    for (const double ratio : {0.3, 1.0, 2.0})
    {
      CAPTURE(frequency, ratio);
      World world;
      add(world, sphere({0, 3, 0}, 0.1, 0));
      add(world, sphere({0, 2.5, 0}, 0.1, 2));
      std::vector<SpringJoint> springs{{0, 1, {0, 0, 0}, {0, 0.1, 0}, 0.4, frequency, ratio}};
      for (int frame = 0; frame < 1200; ++frame)
      {
        step_joined(world, springs, 1.0 / 60);
      }
      const double right = 9.81 / std::pow(2 * pi * frequency, 2);
      CHECK(2.5 - world.bodies[1].motion.center.y() == Catch::Approx(right).epsilon(1e-9));
    }
  }
}
// [small_spring]

// [shared]
TEST_CASE(
    "three undamped springs of 15 Hz on one mass explode at 60 Hz; implicit ones do not", "[R39]")
{
  const auto one = spring_coefficients(15.0, 0.0, 1.0 / 60);
  CHECK(widest_of_many(1, one) <= 1 + 1e-9);
  CHECK(widest_of_many(3, one) > 1e100);
  CHECK(widest_of_many(3, implicit_spring(15.0, 0.0, 1.0 / 60)) < 1);
  CHECK(widest_of_many(4, spring_coefficients(9.9, 0.0, 1.0 / 60)) < 20);
}

TEST_CASE("two undamped springs of 10 Hz with two impulses each explode on one mass", "[R40]")
{
  const SpringFlow<double> flow = spring_flow(10.0, 0.0, 1.0 / 60);
  double x = 1, v = 0;
  for (int step = 0; step < 600; ++step)
  {
    const SpringKicks<double> one = spring_kicks(flow, {x, v}, 1.0 / 60);
    const SpringKicks<double> other = spring_kicks(flow, {x, v + one.before}, 1.0 / 60);
    x += (v + one.before + other.before) / 60;
    v += one.before + other.before + one.after + other.after;
  }
  CHECK(std::abs(x) > 1e6);
  CHECK(widest_of_many(2, spring_coefficients(10.0, 0.0, 1.0 / 60)) < 2); // with one impulse
}
// [shared]
