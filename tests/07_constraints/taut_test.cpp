/// \file
/// Taut chains, bridges, beams and loops under the direct solver: the tension limit, closed forms,
/// energy.

#include "05_resolution/integrators/integrators.hpp"
#include "06_world/ball_joint/trial/joint_pendulum.hpp"
#include "06_world/game_world/trial/joint_opening.hpp"
#include "07_constraints/articulated/double_pendulum.hpp"
#include "07_constraints/taut/trial/taut_run.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

using namespace cookbook;

namespace
{

const Vector2<double> half_right(std::sqrt(0.5), std::sqrt(0.5)), level(1, 0);

/// What becomes of a chain in a time [s].
TautRun ran(const TrialChain& chain, double seconds, const WorldSolver& by = directly())
{
  GameWorld world = world_of(chain, by);
  return run_chain(world, seconds);
}

/// A body of 1 kg on a hook by so many joints of a kind at one point, 10 s later.
template <class Kind>
double gap_of_doubled(int joints)
{
  Scene scene{.bodies = {box_body("hook", {0.1, 0.1, 0.1}, {0, 5, 0}, 0)}};
  scene.bodies.push_back(box_body("beam", {0.25, 0.05, 0.05}, {0.25, 5, 0}));
  GameWorld world(without_contacts(scene), directly());
  JointSet<Kind> set;
  for (int i = 0; i < joints; ++i)
  {
    set.add(trial_joint<Kind>(world, 0, 1, {0, 5, 0}));
  }
  world.add(set);
  for (int i = 0; i < 600; ++i)
  {
    world.step();
  }
  return std::abs(world.body(1).motion.center.y() - 5);
}

/// Two cranks of 1 m and 1 kg with a coupler of 2 kg between their ends, on hinges, let go level.
GameWorld four_bars()
{
  Scene scene{.bodies = {box_body("frame", {1, 0.1, 0.1}, {0, 5, 0}, 0)}};
  scene.bodies.push_back(box_body("left", {0.5, 0.05, 0.05}, {-0.5, 5, 0}));
  scene.bodies.push_back(box_body("right", {0.5, 0.05, 0.05}, {1.5, 5, 0}));
  scene.bodies.push_back(box_body("coupler", {1, 0.05, 0.05}, {1, 5, 0}, 2));
  GameWorld world(without_contacts(scene), directly());
  JointSet<HingeJoint> hinges;
  hinges.add(trial_joint<HingeJoint>(world, 0, 1, {-1, 5, 0}));
  hinges.add(trial_joint<HingeJoint>(world, 0, 2, {1, 5, 0}));
  hinges.add(trial_joint<HingeJoint>(world, 1, 3, {0, 5, 0}));
  hinges.add(trial_joint<HingeJoint>(world, 2, 3, {2, 5, 0}));
  world.add(hinges);
  return world;
}

} // namespace

// [R63]
TEST_CASE(
    "n explicit solves a frame hold a nudged chain of 20 links whose limit is n, n - 1 burst it, "
    "and so do n where the limit is 1.05 n",
    "[R63][long]")
{
  const double inertia = (0.25 + 0.01) / 12, hanging = 19.5; // [kg m²], [kg] below the top link
  for (int n = 2; n <= 5; ++n)
  {
    const double pull = 4 * n * n * 3600 * inertia / 0.5; // (h/2) ω = n
    CHECK(tension_limit({pull, 0.5, inertia}, 1.0 / 60) == Catch::Approx(n));
    const auto gap = [&](double limit, int solves)
    {
      const double load = pull * limit * limit / 9.81 - hanging;
      return ran({.load = load, .nudge = 0.1}, 10, explicitly(solves)).gap;
    };
    CAPTURE(n);
    CHECK(gap(1, n) <= 1e-7);
    CHECK(std::isinf(gap(1, n - 1)));
    CHECK(std::isinf(gap(1.05, n)));
  }
}
// [R63]

// [wide_nudge]
TEST_CASE("a nudge of .5 m/s bursts four explicit solves a frame at a limit of 3.5", "[R63][long]")
{
  CHECK(std::isinf(ran({.load = 759.7, .nudge = 0.5}, 10, explicitly(4)).gap));
  CHECK(ran({.load = 759.7, .nudge = 0.5}, 10).gap <= 1e-7); // as it comes
}
// [wide_nudge]

// [soft_stretch]
TEST_CASE(
    "a chain of 10 m stretches by .29 and .48 m under .1 and 1 t in 4 soft steps, in 16 by .02 "
    "and .1 m",
    "[long]")
{
  CHECK(stretch_of({.load = 100}, softly(4)) == Catch::Approx(0.283).epsilon(0.02));
  CHECK(stretch_of({.load = 1000}, softly(4)) == Catch::Approx(0.479).epsilon(0.02));
  CHECK(stretch_of({.load = 100}, softly(16)) == Catch::Approx(0.019).epsilon(0.02));
  CHECK(stretch_of({.load = 1000}, softly(16)) == Catch::Approx(0.094).epsilon(0.02));
  CHECK(std::isinf(ran({.load = 1000, .nudge = 0.5}, 10, softly(4)).gap)); // at the limit
}
// [soft_stretch]

// [hanging]
TEST_CASE(
    "20 links under 1 t come apart by 100 nm, nudged and swung; the swing keeps .999", "[long]")
{
  CHECK(ran({.load = 1000}, 2).gap <= 1e-7);
  CHECK(ran({.load = 1000, .nudge = 0.5}, 5).gap <= 1e-7);
  const TautRun swung = ran({.load = 1000, .towards = half_right}, 5);
  CHECK(swung.gap <= 1e-6);
  CHECK(swung.left >= 0.999);
  CHECK(swung.most <= 1.002);
}
// [hanging]

TEST_CASE("links of 1 kg and 1 g in turn come apart by less than 1 µm, nudged and swung", "[long]")
{
  CHECK(ran({.light = 0.001, .nudge = 0.5}, 3).gap <= 1e-6);
  CHECK(ran({.light = 0.001, .towards = half_right}, 3).gap <= 1e-6);
}

// [R64]
TEST_CASE(
    "past the limit of 16 solves implicit steps hold: 1,000 t, and 1 t from 90°", "[R64][long]")
{
  const TrialChain heavy{.load = 1e6, .nudge = 0.5};
  CHECK(ran(heavy, 2).gap <= 1e-4);
  CHECK(std::isinf(ran(heavy, 5, explicitly(16)).gap));
  const TrialChain whip{.load = 1000, .towards = level};
  const TautRun held = ran(whip, 5);
  CHECK(held.gap <= 2e-4);
  CHECK(held.left >= 0.9);
  CHECK(held.most <= 1.01);
  CHECK(ran(whip, 20, explicitly(6)).most >= 2);
}
// [R64]

// [bent_twice]
TEST_CASE(
    "ten links without a load fall from 90° for 30 s with no more than 1.05 of their energy",
    "[R64][long]")
{
  const TautRun whip = ran({.links = 10, .towards = level}, 30);
  CHECK(whip.gap <= 1e-3);
  CHECK(whip.most <= 1.05);
}
// [bent_twice]

TEST_CASE(
    "a chain of 100 links falls from 90° with no more energy than it had, in 10 s", "[R64][long]")
{
  const TautRun whip = ran({.links = 100, .towards = level}, 10);
  CHECK(whip.gap <= 0.01);
  CHECK(whip.most <= 1.01);
}

// [R65]
TEST_CASE("a bridge of 30 planks under 50 kg sags as its closed form, to 10 µm", "[R65][long]")
{
  const HangingBridge bridge{.load = 50 * 9.81};
  double reach = 0;
  for (const Vector2<double>& plank : half_bridge(bridge))
  {
    reach += bridge.length * plank.x();
  }
  CHECK(2 * reach == Catch::Approx(bridge.span).epsilon(1e-12));
  CHECK(bridge_error(bridge) <= 1e-5);
}
// [R65]

TEST_CASE("planks that hang straight, and two without a load, have the angles of statics", "[R65]")
{
  const HangingBridge two{.planks = 2, .length = 1, .weight = 1, .span = 1.2};
  const std::vector<Vector2<double>> half = half_bridge(two); // a triangle of 3, 4 and 5
  CHECK(half[0].x() == Catch::Approx(0.6));
  CHECK(half[0].y() == Catch::Approx(0.8));
  CHECK_THROWS_AS(sag_of({.planks = 2, .length = 1, .span = 2}), std::invalid_argument);
  CHECK_THROWS_AS(sag_of({.planks = 2, .length = 1, .span = 0}), std::invalid_argument);
}

// [loops]
TEST_CASE("ten welded beams of 5 m droop by less than 10 µm", "[long]")
{
  CHECK(droop_of_beams(10) <= 1e-5);
}

TEST_CASE(
    "four bars on hinges, three rows too many, swing with the period of their closed form",
    "[long]")
{
  GameWorld bars = four_bars();
  const double start = energy(bars.bodies(), bars.scene().gravity), crank = (1 + 0.01) / 12 + 0.25;
  const double mass = 4, reach = (2 * 0.5 + 2 * 1) / mass, moment = 2 * crank + 2;
  const double right = period_of(moment / mass, reach, 9.81, std::numbers::pi / 2);
  double gap = 0, last = 0, before = 0;
  int crossings = 0;
  for (int i = 0; i < 1200; ++i)
  {
    bars.step();
    gap = std::max(gap, joint_opening(bars).length);
    const double x = bars.body(1).motion.center.x() + 1; // of the left crank, from its hinge
    if (i > 0 && (x > 0) != (before > 0))
    {
      ++crossings;
      last = bars.time() - x / (x - before) / 60;
    }
    before = x;
  }
  CHECK(gap <= 1e-6);
  CHECK(4 * last / (2 * crossings - 1) == Catch::Approx(right).epsilon(1e-3));
  CHECK(
      energy(bars.bodies(), bars.scene().gravity) == Catch::Approx(start).margin(0.01 * 9.81 * 3));
}

TEST_CASE("two and three welds between the same two bodies hold as one")
{
  for (const int welds : {1, 2, 3})
  {
    CHECK(gap_of_doubled<WeldJoint>(welds) <= 1e-6);
  }
}
// [loops]

// [pendulum_period]
TEST_CASE("a pendulum from 90° has the period of the elliptic integral to 1e-4, at 60 Hz")
{
  const Swing swing =
      swing_of({.solver = "direct", .rate = 60, .amplitude = std::numbers::pi / 2, .duration = 60});
  CHECK(swing.period == Catch::Approx(swing.right).epsilon(1e-4));
  CHECK(swing.least >= -5e-3 * swing.swings_up);
  CHECK(swing.most <= 5e-3 * swing.swings_up);
}

TEST_CASE(
    "two links swing as Lagrange's equation says, to 1 cm in 5 s, and keep .999 for 60 s", "[long]")
{
  const TrialChain chain{.links = 2, .towards = {0.6, 0.8}};
  GameWorld world = world_of(chain);
  const SwingingLink rod{.mass = 1, .moment = (0.25 + 0.01) / 12, .center = 0.25, .length = 0.5};
  const DoublePendulum pendulum{rod, rod};
  const auto accelerations = [&](const Vector2<double>& angles, const Vector2<double>& speeds)
  { return angular_accelerations(pendulum, angles, speeds); };
  const double angle = std::atan2(0.6, 0.8);
  PhasePoint<Vector2<double>> at{{angle, angle}, {0, 0}};
  double apart = 0;
  for (int frame = 0; frame < 300; ++frame)
  {
    world.step();
    for (int i = 0; i < 16; ++i)
    {
      at = rk4(at, 1.0 / 960, accelerations);
    }
    const double x = 0.5 * std::sin(at.position.x()) + 0.25 * std::sin(at.position.y());
    apart = std::max(apart, std::abs(world.body(2).motion.center.x() - x));
  }
  CHECK(apart <= 0.01);
  const TautRun minute = ran(chain, 60);
  CHECK(minute.left >= 0.999);
  CHECK(minute.most <= 1.01);
}
// [pendulum_period]
