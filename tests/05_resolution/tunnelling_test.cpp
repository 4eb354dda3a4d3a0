/// \file
/// What holds for fast balls and walls: formulas R17 and R18, and the cases in which ways to move
/// them on fail.

#include "05_resolution/tunnelling/trial/tunnelling_box_cases.hpp"
#include "05_resolution/tunnelling/trial/tunnelling_cases.hpp"
#include "05_resolution/tunnelling/tunnelling.hpp"
#include "common/math/rotation.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <array>
#include <bit>
#include <cstdint>

using namespace cookbook;

namespace
{

/// A few roundings of numbers of size one: double's unit roundoff is 1.1e-16.
constexpr double rounding = 1e-15;

/// Balls of 1/16 m at a wall of 1/4 m, 64 steps a second: every number is exact.
Shots exact_shots(double speed)
{
  return {wide_wall(0.25), 0.0625, {speed, 0, 0}, 0, 1, 1.0 / 64, 256};
}

/// Whether a ball that flies on as if no wall were there overlaps it at the end of any step.
bool is_seen(const Shots& shots, int i)
{
  MovingSphere<double> flight = shots.start(i);
  for (int step = 0; step < shots.steps(); ++step)
  {
    flight = moved(flight, shots.step);
    if (sphere_box(flight.sphere, shots.wall))
    {
      return true;
    }
  }
  return false;
}

int count_seen(const Shots& shots)
{
  int seen = 0;
  for (int i = 0; i < shots.count; ++i)
  {
    seen += is_seen(shots, i) ? 1 : 0;
  }
  return seen;
}

std::array<std::uint64_t, 3> bits(const Vector3<double>& v)
{
  return {
      std::bit_cast<std::uint64_t>(v.x()), std::bit_cast<std::uint64_t>(v.y()),
      std::bit_cast<std::uint64_t>(v.z())};
}

/// The floor, the ceiling and the walls of a room: a cube of 1 m, 2 cm thick.
std::vector<Obb<double>> room_walls()
{
  std::vector<Obb<double>> walls;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : {-0.51, 0.51})
    {
      Vector3<double> half_extents = Vector3<double>::Constant(0.52);
      half_extents[axis] = 0.01;
      walls.push_back(
          {side * Vector3<double>::Unit(axis), Matrix3<double>::Identity(), half_extents});
    }
  }
  return walls;
}

} // namespace

// [R17]
TEST_CASE("a gap of 0.5 m and a step of 1/4 s leave 2 m/s of 8, and what is slower alone", "[R17]")
{
  using Vector = Vector3<double>;
  const Vector normal(1, 0, 0);
  CHECK(speculative_velocity<double>({8, 3, -4}, normal, 0.5, 0.25) == Vector(2, 3, -4));
  for (const double slower : {2.0, 1.0, 0.0, -8.0})
  {
    const Vector velocity(slower, 3, -4);
    CHECK(speculative_velocity<double>(velocity, normal, 0.5, 0.25) == velocity);
  }
}

TEST_CASE("a braked ball touches after the step, without overlap", "[R17]")
{
  const Shots shots = straight_at(0.02, 1000, 0);
  const MovingSphere<double> start = shots.start(0), there = moved(start, shots.step);
  const double infinite = std::numeric_limits<double>::infinity();
  const MovingSphere<double> after = speculative_step(there, shots.wall, 0.0, shots.step, infinite);
  // Places of up to 33 m, each rounded.
  CHECK(std::abs(direction_to(after.sphere, shots.wall).length) <= 33 * rounding);
}
// [R17]

// [R18]
TEST_CASE("1/4 m of wall, 1/16 m of ball, 1/64 s: seen up to 24 m/s, not beyond", "[R18]")
{
  CHECK(no_tunnel_speed(0.25, 0.0625, 1.0 / 64) == 24);
  for (const double speed : {1.0, 8.0, 16.0, 23.0, 24.0})
  {
    CHECK(count_seen(exact_shots(speed)) == 256);
  }
  // Of the places that a ball may come to, evenly spread over v h, w + 2 r are in the wall.
  CHECK(count_seen(exact_shots(24.5)) == 251); // 256 · 24 / 24.5 is 250.8
  CHECK(count_seen(exact_shots(48)) == 128);
  CHECK(count_seen(exact_shots(96)) == 64);
}

TEST_CASE("up to 12 m/s a ball is pushed out where it came in, not beyond", "[R18]")
{
  CHECK(no_push_through_speed(0.25, 0.0625, 1.0 / 64) == 12);
  const FlightMethod discrete = flight_methods()[0];
  for (const double speed : {1.0, 8.0, 11.0, 12.0})
  {
    CHECK(share_passed(exact_shots(speed), discrete) == 0);
  }
  // The same count, of the nearer half of the wall: 1 − 12 / v pass.
  CHECK(share_passed(exact_shots(16), discrete) == 0.25);
  CHECK(share_passed(exact_shots(24), discrete) == 0.5);
  CHECK(share_passed(exact_shots(48), discrete) == 0.75);
}

TEST_CASE("a ball that is seen 1/32 m deep is put where it touches, and bounces: -3/16 m, -4 m/s")
{
  const Obb<double> wall{{0, 0, 0}, Matrix3<double>::Identity(), {0.125, 8, 8}};
  const MovingSphere<double> coming{{{-0.28125, 0, 0}, 0.0625}, {8, 0, 0}};
  const MovingSphere<double> after = discrete_step<double>(coming, wall, 0.5, 1.0 / 64);
  CHECK(after.sphere.center == Vector3<double>(-0.1875, 0, 0));
  CHECK(after.velocity == Vector3<double>(-4, 0, 0));
}

TEST_CASE("eight substeps are as good as an eighth of the speed", "[R18]")
{
  const FlightMethod eight = flight_methods()[1];
  CHECK(share_passed(exact_shots(96), eight) == 0);
  CHECK(share_passed(exact_shots(192), eight) == 0.5);
}

TEST_CASE(
    "a ball that moves by its radius a step at most is turned back by any wall", "[R18][long]")
{
  const FlightMethod discrete = flight_methods()[0];
  for (const double thickness : {0x1p-40, 0x1p-20, 0x1p-7, 1.0, 64.0})
  {
    for (const double speed : {4.0, 1.0, 0.25})
    {
      Shots shots = exact_shots(speed);
      shots.wall = wide_wall(thickness);
      CHECK(share_passed(shots, discrete) == 0);
    }
  }
}
// [R18]

// [never_passes]
TEST_CASE(
    "swept, no ball of 5 cm at 1 to 1,000 m/s passes 2 cm, and all keep their restitution",
    "[case:J1][long]")
{
  for (const double restitution : {0.0, 0.5, 0.8, 1.0})
  {
    for (const Shots& shots : all_speeds(restitution))
    {
      const Vector3<double> velocity = shots.velocity;
      const Vector3<double> right(-restitution * velocity.x(), velocity.y(), velocity.z());
      for (int i = 0; i < shots.count; ++i)
      {
        const MovingSphere<double> after = flown(shots, swept_method(), i);
        // Places of up to 50 m, each rounded.
        REQUIRE(after.sphere.center.x() <= -0.06 + 50 * rounding);
        REQUIRE((after.velocity - right).norm() <= 4 * rounding * velocity.norm());
      }
    }
  }
}

TEST_CASE("a ball of 1/16 at 50 to 5,000 units a step stops in front of a wall of 1/4", "[case:J2]")
{
  for (int speed = 50; speed <= 5000; speed += 50)
  {
    const Shots shots = sixteenth(speed);
    REQUIRE(share_passed(shots, swept_method()) == 0);
    // Places of up to 10,000 units, each rounded.
    const MovingSphere<double> after = flown(shots, swept_method(), speed % 97);
    REQUIRE(std::abs(after.sphere.center.x() + 0.125 + 0.0625) <= 1e4 * rounding);
  }
}

TEST_CASE("swept, none passes a wall of a tenth of a millimetre, turned, a hundred kilometres out")
{
  const Matrix3<double> axes = rational_rotation<double>(1, 2, 3, 4);
  const Vector3<double> distant(1e5, -1e5, 1e5);
  const Obb<double> wall{distant, axes, {5e-5, 500, 500}};
  const Vector3<double> normal = axes.col(0);
  for (int i = 0; i < 200; ++i)
  {
    const Vector3<double> velocity = 1000 * normal + (i - 100) * axes.col(1);
    const Vector3<double> start = distant - (0.05 + 5e-5 + 0.01 + 0.08 * i) * normal;
    MovingSphere<double> flight{{start, 0.05}, velocity};
    for (int step = 0; step < 3; ++step)
    {
      flight = swept_step<double>(flight, {&wall, 1}, 1, 1.0 / 60);
    }
    // Coordinates of 1e5 m are rounded at 1.5e-11.
    REQUIRE(normal.dot(flight.sphere.center - distant) <= -0.05);
    REQUIRE(normal.dot(flight.velocity) == Catch::Approx(-1000).epsilon(1e-12));
  }
}

TEST_CASE("a ball of 5 cm stays in a room of 1 m for 10 s, at 1,000 m/s or what is left")
{
  const std::vector<Obb<double>> walls = room_walls();
  for (const double restitution : {0.0, 0.5, 0.9, 1.0})
  {
    MovingSphere<double> flight{{{0.1, 0.2, 0.05}, 0.05}, {600, 640, 480}};
    for (int step = 0; step < 600; ++step)
    {
      flight = swept_step<double>(flight, walls, restitution, 1.0 / 60);
      REQUIRE(flight.sphere.center.cwiseAbs().maxCoeff() <= 0.45 + 20 * rounding);
    }
    // About 11,000 bounces, each rounded a few times.
    CHECK((restitution > 0 || flight.velocity.norm() == 0));
    CHECK((restitution < 1 || std::abs(flight.velocity.norm() - 1000) <= 1000 * 11000 * 4e-16));
  }
}

TEST_CASE("a ball that slides along a turned wall with e = 0 goes on")
{
  const Matrix3<double> axes = rational_rotation<double>(1, 2, 3, 4);
  const Obb<double> wall{{0.3, 0.2, 0.1}, axes, {0.01, 500, 500}};
  const Vector3<double> normal = axes.col(0), along = axes.col(1);
  MovingSphere<double> flight{{wall.center - 0.07 * normal, 0.05}, 100 * along + 60 * normal};
  for (int step = 1; step <= 60; ++step)
  {
    flight = swept_step<double>(flight, {&wall, 1}, 0, 1.0 / 60);
    REQUIRE(along.dot(flight.sphere.center - wall.center) == Catch::Approx(100 * step / 60.0));
    // Coordinates of up to 100 m are rounded in every step.
    REQUIRE(normal.dot(flight.sphere.center - wall.center) <= -0.06 + 100 * step * rounding);
  }
}

TEST_CASE("between plates a nanometre farther apart than itself a ball waits after 32 bounces")
{
  const double out = 0.06 + 1e-9;
  const Obb<double> wall = wide_wall(0.02);
  std::vector<Obb<double>> plates{wall, wall};
  plates[0].center.x() = -out;
  plates[1].center.x() = out;
  MovingSphere<double> flight{{{0, 0, 0}, 0.05}, {1000, 0, 0}};
  flight = swept_step<double>(flight, plates, 1, 1.0 / 60);
  CHECK(std::abs(flight.sphere.center.x()) <= 1e-9 + rounding);
  CHECK(std::abs(flight.velocity.x()) == Catch::Approx(1000).epsilon(100 * rounding));
}
// [never_passes]

// [near_misses]
TEST_CASE("3 cm beside the edge, at 1 to 1,000 m/s, swept balls keep every bit", "[case:J4]")
{
  for (int i = 0; i <= 60; ++i)
  {
    const Shots shots = beside(0.01, 0.03, std::pow(10, i / 20.0));
    for (int sphere = 0; sphere < shots.count; ++sphere)
    {
      MovingSphere<double> alone = shots.start(sphere);
      for (int step = 0; step < shots.steps(); ++step)
      {
        alone = moved(alone, shots.step);
      }
      const MovingSphere<double> flight = flown(shots, swept_method(), sphere);
      REQUIRE(bits(flight.velocity) == bits(shots.velocity));
      REQUIRE(bits(flight.sphere.center) == bits(alone.sphere.center));
    }
  }
}

TEST_CASE("speculative brakes them: by a third at 10 m/s, by 9 parts in 10 at 1,000", "[case:J4]")
{
  const FlightMethod speculative = flight_methods()[3];
  CHECK(most_velocity_lost(beside(0.01, 0.03, 1), speculative) == 0);
  CHECK(most_velocity_lost(beside(0.01, 0.03, 10), speculative) > 0.3);
  CHECK(most_velocity_lost(beside(0.01, 0.03, 1000), speculative) > 0.9);
  // 1 mm beside a corner, 10 m/s: a bounce at full speed is worse than a brake.
  CHECK(most_velocity_lost(beside(1, 0.001, 10), speculative) > 0.5);
  CHECK(most_velocity_lost(beside(1, 0.001, 10), flight_methods()[4]) > 0.9);
}
// [near_misses]

// [lost_bounce]
TEST_CASE("speculative leaves a ball of 10 m/s and e = 1 the gap over the step", "[case:J8]")
{
  // The last whole step ends (i + 0.5) % of a step before the wall: that is what is left to bounce.
  const Shots shots = straight_at(1, 10, 1);
  for (const int i : {0, 37, 99})
  {
    const double back = -flown(shots, flight_methods()[3], i).velocity.x();
    CHECK(back == Catch::Approx(10 * (i + 0.5) / 100).epsilon(1e-6));
    CHECK(-flown(shots, swept_method(), i).velocity.x() == Catch::Approx(10).epsilon(rounding));
  }
}
// [lost_bounce]

TEST_CASE(
    "which method stops, lets by and lets bounce which spheres",
    "[case:J1][case:J2][case:J4][case:J8][long]")
{
  check_verdicts(
      flight_verdicts(), names_of(flight_methods()),
      {{"J1", {"8 substeps", "speculative", "speculative, full bounce", "swept"}},
       {"the same at 100 m/s", {"speculative", "speculative, full bounce", "swept"}},
       {"the same at 1,000 m/s", {"speculative", "speculative, full bounce", "swept"}},
       {"a 2 cm wall, 1 to 1,000 m/s, to 80° askew",
        {"speculative", "speculative, full bounce", "swept"}},
       {"J2", {"speculative", "speculative, full bounce", "swept"}},
       {"the same, 5,000 units a step", {"speculative", "speculative, full bounce", "swept"}},
       {"J4", {"discrete", "8 substeps", "swept"}},
       {"past a 2 cm wall, 3 cm beside, 1,000 m/s",
        {"discrete", "8 substeps", "speculative, 2 cm", "swept"}},
       {"J8", {"discrete", "8 substeps", "speculative, full bounce", "swept"}},
       {"e = 0.8 on a 2 cm wall, 1,000 m/s", {"speculative, full bounce", "swept"}}});
}

TEST_CASE("which method finds when two boxes touch", "[case:J5][case:J6]")
{
  check_verdicts(
      box_sweep_verdicts(), names_of(box_sweep_methods()),
      {{"J5", {"overlap at the end", "turning left out", "swept_boxes"}},
       {"J6", {"halving, unchecked", "turning left out", "swept_boxes"}},
       {"the same for 30 s: right through it", {"turning left out", "swept_boxes"}},
       {"rod turns by 3 rad about its middle, peg 1 m off",
        {"halving, unchecked", "swept_boxes"}}});
}
