/// \file
/// What holds for a bounce at several points, and the cases in which other ways to resolve a
/// collision fail.

#include "05_resolution/impulse/impulse.hpp"
#include "05_resolution/impulse/trial/bounce_cases.hpp"
#include "05_resolution/impulse/trial/conserved.hpp"
#include "05_resolution/impulse/trial/impulse_cases.hpp"
#include "05_resolution/impulse/trial/impulse_pitfalls.hpp"
#include "05_resolution/impulse/trial/impulse_scenes.hpp"
#include "common/math/rotation.hpp"
#include "tools/exact/exact.hpp"

#include "tests/05_resolution/meetings.hpp"
#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <cmath>
#include <map>
#include <random>

using namespace cookbook;

// [landings]
TEST_CASE("a cube of 1 kg lands flat, on an edge, on a corner, with e = 0.5", "[R2]")
{
  // The manifold is a nanometre deep: its points are off by up to two, each worth 9 rad/s a metre.
  const double tolerance = 2e-8;
  const auto after = [](const Landing& landing)
  { return bounce(landing.bodies, landing.manifold, 0.5, 40).a.motion; };
  const std::vector<Landing> all = landings();
  CHECK(all[0].manifold.points.size() == 4);
  CHECK(std::abs(after(all[0]).velocity.y() - 0.5) <= tolerance);
  CHECK(after(all[0]).angular_velocity.norm() <= tolerance);
  // The edge is 0.1 m beside the centre: K = 1 + 6 · 0.01.
  CHECK(all[1].manifold.points.size() == 2);
  CHECK(std::abs(after(all[1]).velocity.y() - (1.5 / 1.06 - 1)) <= tolerance);
  CHECK(std::abs(after(all[1]).angular_velocity.norm() - 0.6 * 1.5 / 1.06) <= tolerance);
  // The corner is (-1/22, 1/22) m beside the centre: K = 1 + 6 · 2/22² = 124/121.
  CHECK(all[2].manifold.points.size() == 1);
  CHECK(std::abs(after(all[2]).velocity.y() - (1.5 * 121 / 124 - 1)) <= tolerance);
  CHECK(
      std::abs(after(all[2]).angular_velocity.norm() - 9 * 121 / 124.0 * std::sqrt(2) / 22) <=
      tolerance);
}
// [landings]

// [bounce]
TEST_CASE("at one point a bounce of one pass is a collision, exactly", "[R5]")
{
  RandomMeetings random;
  for (int i = 0; i < 50; ++i)
  {
    const RandomMeeting meeting = random.next();
    Manifold<Rational> manifold{meeting.normal, 0, {}};
    manifold.points.push_back({meeting.point, 0, 0});
    const BodyPair<Rational> once =
        resolve_collision<Rational>(meeting.bodies, meeting.normal, meeting.point, Rational(1) / 3);
    const BodyPair<Rational> same = bounce<Rational>(meeting.bodies, manifold, Rational(1) / 3, 1);
    CHECK(same.a.motion.velocity == once.a.motion.velocity);
    CHECK(same.b.motion.angular_velocity == once.b.motion.angular_velocity);
  }
}

TEST_CASE("a point gets back what it no longer needs, and not more", "[R5]")
{
  // Left of the centre the body comes down at 1, right of it at 1/10. A push of 4/5 on the left
  // alone stops the left and lifts the right; pushing the right first must leave no trace.
  const Rational half = Rational(1) / 2;
  const BodyPair<Rational> bodies = unit_body<Rational>(Rational(-11) / 20, Rational(9) / 10);
  const Manifold<Rational> manifold =
      landing_at<Rational>({vec<Rational>(half, 0, 0), vec<Rational>(-half, 0, 0)});
  const Motion<Rational> after = bounce<Rational>(bodies, manifold, 0, 2).a.motion;
  CHECK(after.velocity.y() == Rational(1) / 4);
  CHECK(after.angular_velocity.z() == half);
}

TEST_CASE("a point that parts already is kept from coming back, but not sent off faster", "[R5]")
{
  // Left comes down at 1, right goes up at 1/10; with e = 1 left is to go up at 1, right to stop
  // going down: v - 2 w = 1 and v + 2 w = 0.
  const BodyPair<double> bodies = unit_body(-0.45, 0.275);
  const Manifold<double> manifold = landing_at<double>({{-2, 0, 0}, {2, 0, 0}});
  const Motion<double> after = bounce(bodies, manifold, 1.0, 40).a.motion;
  // Each pass leaves 9/25 of the error: 40 passes leave less than a rounding.
  CHECK(after.velocity.y() == Catch::Approx(0.5).epsilon(10 * rounding));
  CHECK(after.angular_velocity.z() == Catch::Approx(-0.25).epsilon(10 * rounding));
}

TEST_CASE("a wheel on a fixed axle is turned by the points beside its axle only", "[R5]")
{
  // The first point's lever is zero, and no push moves it; the second comes down at 2.
  BodyPair<double> bodies = unit_body(0.0, -1.0);
  bodies.a.inverse_mass = 0;
  const Manifold<double> manifold = landing_at<double>({{0, -2, 0}, {2, 0, 0}});
  const Motion<double> after = bounce(bodies, manifold, 0.5, 1).a.motion;
  CHECK(after.velocity == Vector3<double>(0, 0, 0));
  CHECK(after.angular_velocity == Vector3<double>(0, 0, 0.5));
}

TEST_CASE("a bounce of two movable bodies at two points keeps their momenta, exactly", "[R3]")
{
  RandomMeetings random;
  const RandomMeeting meeting = random.next();
  Manifold<Rational> manifold{meeting.normal, 0, {}};
  manifold.points.push_back({meeting.point, 0, 0});
  manifold.points.push_back({meeting.point + meeting.normal.cross(vec<Rational>(1, 2, 4)), 0, 0});
  const Conserved<Rational> before = meeting.sums(meeting.bodies);
  const BodyPair<Rational> bounced = bounce<Rational>(meeting.bodies, manifold, 1, 3);
  CHECK(meeting.sums(bounced).momentum == before.momentum);
  CHECK(meeting.sums(bounced).angular_momentum == before.angular_momentum);
  CHECK(bounced.a.motion.velocity != meeting.bodies.a.motion.velocity);
}
// [bounce]

// [S14]
TEST_CASE("one pass over four corners: 61/64 m/s, or 4583311/3418801 closer in", "[case:S14]")
{
  const std::vector<BounceCase<Rational>> cases = bounce_cases<Rational>();
  const auto up = [&](const BounceCase<Rational>& one, int passes)
  { return bounce<Rational>(one.bodies, one.manifold, 1, passes).a.motion.velocity.y(); };
  CHECK(up(cases[0], 1) == Rational(61) / 64);
  CHECK(up(cases[1], 1) == Rational(4583311) / 3418801); // higher than it came from
  CHECK(abs(up(cases[0], 4) - 1) <= Rational(1) / 1000);
  CHECK(abs(up(cases[1], 4) - 1) <= Rational(1) / 1000);
}

TEST_CASE("points listed round the square: 119/128 m/s in one pass, 1 in four", "[case:S14]")
{
  BounceCase<Rational> square = bounce_cases<Rational>()[0];
  std::swap(square.manifold.points[2], square.manifold.points[3]);
  const auto up = [&](int passes)
  { return bounce<Rational>(square.bodies, square.manifold, 1, passes).a.motion.velocity.y(); };
  CHECK(up(1) == Rational(119) / 128);
  CHECK(abs(up(4) - 1) <= Rational(1) / 1000);
}

TEST_CASE(
    "each corner in turn keeps the energy and turns an eighth of the speed to spin", "[case:S14]")
{
  const BounceCase<Rational> square = bounce_cases<Rational>()[0];
  const Motion<Rational> after =
      bounce_in_turn<Rational>(square.bodies, square.manifold, 1).a.motion;
  CHECK(after.velocity.y() == Rational(7) / 8);
  CHECK(after.angular_velocity.squaredNorm() == Rational(90) / 64);
  CHECK(
      after.velocity.squaredNorm() / 2 + after.angular_velocity.squaredNorm() / 12 ==
      Rational(1) / 2);
}

TEST_CASE("40 passes bring a flat cube up at 1 m/s without spin, to rounding", "[case:S14]")
{
  for (const BounceCase<double>& one : bounce_cases<double>())
  {
    const Motion<double> after = bounce(one.bodies, one.manifold, 1.0, 40).a.motion;
    CHECK(after.velocity.y() == Catch::Approx(1).epsilon(10 * rounding));
    CHECK(after.angular_velocity.norm() <= 10 * rounding);
  }
}
// [S14]

// [X18]
TEST_CASE("divided by n, a ball's speed is scaled by (1 - (1+e)/n) n times a pass", "[case:X18]")
{
  const std::vector<BounceCase<Rational>> cases = bounce_cases<Rational>();
  const auto up = [&](const BounceCase<Rational>& one)
  { return bounce_divided<Rational>(one.bodies, one.manifold, 1, 5).a.motion.velocity.y(); };
  CHECK(up(cases[2]) == Rational(-1) / (1 << 20)); // n = 4: half of it is left, 20 times
  CHECK(up(cases[3]) == 0);                        // n = 2: it stops
  CHECK(up(cases[4]) == 1);                        // n = 1: right
}
// [X18]

TEST_CASE("what holds and what fails at bounces of several points", "[case:S14][case:X18]")
{
  check_verdicts(
      bounce_verdicts(), names_of(bounce_methods<double>()),
      {{"S14", {"bounce, 4 passes"}},
       {"the same on a pedestal, points at ±0.375", {"bounce, 4 passes"}},
       {"X18", {"each point in turn", "bounce, 1 pass", "bounce, 4 passes"}},
       {"ball, two points in one place",
        {"each point in turn", "bounce, 1 pass", "bounce, 4 passes"}},
       {"ball, one point",
        {"as published: divided, 5 passes", "each point in turn", "bounce, 1 pass",
         "bounce, 4 passes"}}});
}

TEST_CASE("what holds and what fails at pushes", "[case:X19][case:X20][case:X26]")
{
  // The last cube is so large that its determinant is above the threshold.
  check_verdicts(
      response_verdicts(), {"as published", "impulse.hpp"},
      {{"X19", {"impulse.hpp"}},
       {"X20", {"impulse.hpp"}},
       {"cube of 1 kg, side 0.2 m, turned [rad/s]", {"impulse.hpp"}},
       {"ball of 1 kg, radius 0.5 m, turned [rad/s]", {"impulse.hpp"}},
       {"cube of 1 kg, side 2 m, turned [rad/s]", {"as published", "impulse.hpp"}},
       {"X26", {"impulse.hpp"}}});
}

// [X19]
TEST_CASE("an upright rod turns about its length by 150 rad/s per N m s, not 2.97", "[case:X19]")
{
  const ResponseCase rod = upright_rod();
  CHECK(rod.ours == Catch::Approx(12 / 0.08).epsilon(10 * rounding));
  CHECK(rod.published == Catch::Approx(12 / 4.04).epsilon(10 * rounding));
}

TEST_CASE("turned and inverted is inverted and turned, exactly", "[case:X19]")
{
  const Vector3<Rational> moments(2, 3, 7);
  const Matrix3<Rational> axes = rational_rotation<Rational>(1, 2, 3, 4);
  const Matrix3<Rational> product =
      world_inverse_inertia(moments, axes) * world_inertia(moments, axes);
  CHECK(product == Matrix3<Rational>::Identity());
}
// [X19]

// [X20]
TEST_CASE("an absolute threshold takes unit-mass cubes below 1.013 m for singular", "[case:X20]")
{
  const auto published = [](double side)
  {
    const MassProperties<double> cube = solid_box<double>(1, Vector3<double>::Constant(side / 2));
    return turned_solid("", "", cube, 6 / (side * side));
  };
  for (const double side : {0.2, 1.0, 1.012})
  {
    CHECK(published(side).published == 1);
  }
  CHECK(published(1.014).published == Catch::Approx(published(1.014).right).epsilon(rounding));
  for (const double side : {0.001, 0.2, 1.0, 1.014, 1000.0})
  {
    CHECK(published(side).ours == Catch::Approx(published(side).right).epsilon(4 * rounding));
  }
  CHECK(turned_solid("", "", solid_sphere(1.0, 0.5), 10).published == 1);
}
// [X20]

// [X26]
TEST_CASE("6 N s give a ball of 2 kg 3 m/s, not 6", "[case:X26]")
{
  CHECK(pushed_ball().ours == 3);
  CHECK(pushed_ball().published == 6);
}
// [X26]
