/// \file
/// What holds for the impulse of a bounce at one point: formulas R1 to R5 and R33.

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

#include <cmath>
#include <map>
#include <random>

using namespace cookbook;

// [R1]
TEST_CASE("a unit cube hit at a corner feels like a quarter of its mass: K = 4", "[R1]")
{
  const BodyPair<double> bodies = falling_on_ground<double>();
  const Vector3<double> down(0, -1, 0);
  const auto felt_at = [&](const Vector3<double>& point)
  { return inverse_mass_at(bodies.a, bodies.b, down, arms_to(bodies, point)); };
  CHECK(felt_at({0.5, -0.5, 0.5}) == Catch::Approx(4).epsilon(rounding));
  CHECK(felt_at({0, -0.5, 0}) == 1);
}

TEST_CASE("K of 100 exact pairs is n · ((I⁻¹ (r × n)) × r) and inverse masses, summed", "[R1]")
{
  RandomMeetings random;
  for (int i = 0; i < 100; ++i)
  {
    const RandomMeeting meeting = random.next();
    const auto share = [&](const Body<Rational>& body, const Matrix3<Rational>& inertia)
    {
      const Vector3<Rational> r = meeting.point - body.motion.center;
      const Vector3<Rational> turn = inertia.inverse() * r.cross(meeting.normal);
      return Rational(meeting.normal.dot(turn.cross(r)));
    };
    const Rational k = 1 / meeting.mass_a + 1 / meeting.mass_b +
                       share(meeting.bodies.a, meeting.inertia_a) +
                       share(meeting.bodies.b, meeting.inertia_b);
    CHECK(meeting.inverse_mass() == k);
  }
}
// [R1]

// [R2]
TEMPLATE_TEST_CASE("a unit cube at -1 m/s on one corner, e = 0.5: j = 0.375", "[R2]", float, double)
{
  const BodyPair<TestType> bodies = falling_on_ground<TestType>();
  const Vector3<TestType> down(0, -1, 0);
  const Vector3<TestType> corner(TestType(0.5), TestType(-0.5), TestType(0.5));
  const TestType half = TestType(0.5);
  // A cube's moment, 1/6, is no binary fraction: a few roundings.
  const TestType some = 8 * std::numeric_limits<TestType>::epsilon();
  const Arms<TestType> arms = arms_to(bodies, corner);
  const TestType impulse = bounce_impulse(bodies.a, bodies.b, down, arms, half);
  CHECK(std::abs(impulse - TestType(0.375)) <= some);
  const Motion<TestType> after = resolve_collision(bodies, down, corner, half).a.motion;
  const Vector3<TestType> velocity(0, TestType(-0.625), 0);
  const Vector3<TestType> spin(TestType(1.125), 0, TestType(-1.125));
  CHECK((after.velocity - velocity).norm() <= some);
  CHECK((after.angular_velocity + spin).norm() <= 2 * some);
}

TEST_CASE("surfaces that part or rest get no impulse, and stay as they are", "[R2]")
{
  BodyPair<double> bodies = falling_on_ground<double>();
  const Vector3<double> down(0, -1, 0), corner(0.5, -0.5, 0.5);
  for (const double up : {0.0, 1e-300, 1.0})
  {
    bodies.a.motion.velocity.y() = up;
    CHECK(bounce_impulse(bodies.a, bodies.b, down, arms_to(bodies, corner), 1.0) == 0);
    const Motion<double> after = resolve_collision(bodies, down, corner, 1.0).a.motion;
    CHECK(after.velocity == Vector3<double>(0, up, 0));
    CHECK(after.angular_velocity == Vector3<double>(0, 0, 0));
  }
}

TEST_CASE("two immovable bodies that run into each other get no impulse", "[R2]")
{
  BodyPair<double> bodies{static_body<double>({0, 1, 0}), static_body<double>({0, -1, 0})};
  bodies.a.motion.velocity = {0, -1, 0};
  const Vector3<double> down(0, -1, 0), point(0, 0, 0);
  const Arms<double> arms = arms_to(bodies, point);
  CHECK(inverse_mass_at(bodies.a, bodies.b, down, arms) == 0);
  CHECK(bounce_impulse(bodies.a, bodies.b, down, arms, 1.0) == 0);
  CHECK(resolve_collision(bodies, down, point, 1.0).a.motion.velocity == Vector3<double>(0, -1, 0));
  const Manifold<double> manifold = landing_at<double>({point});
  CHECK(bounce(bodies, manifold, 1.0, 3).a.motion.velocity == Vector3<double>(0, -1, 0));
}
// [R2]

// [R3]
TEST_CASE("200 random bounces keep momentum and angular momentum, exactly", "[R3]")
{
  RandomMeetings random;
  for (int i = 0; i < 200; ++i)
  {
    const RandomMeeting meeting = random.next();
    const Rational restitution = Rational(i % 5) / 4;
    const Conserved<Rational> before = meeting.sums(meeting.bodies);
    const Conserved<Rational> after =
        meeting.sums(resolve_collision(meeting.bodies, meeting.normal, meeting.point, restitution));
    CHECK(after.momentum == before.momentum);
    CHECK(after.angular_momentum == before.angular_momentum);
  }
}

TEST_CASE("2 kg at (1,0,0), 3 m/s along y, spin 4 about z: 6 kg m/s, 26 kg m²/s, 49 J", "[R3]")
{
  const Motion<double> motion{{1, 0, 0}, {0, 3, 0}, {0, 0, 4}};
  const Matrix3<double> axes = rational_rotation<double>(1, 0, 0, 1); // a quarter turn about z
  const Conserved<double> sums = conserved(motion, 2.0, world_inertia<double>({1, 2, 5}, axes));
  CHECK(sums.momentum == Vector3<double>(0, 6, 0));
  CHECK(sums.angular_momentum == Vector3<double>(0, 0, 26));
  CHECK(sums.energy == 49);
  CHECK(world_inertia<double>({1, 2, 5}, axes).diagonal() == Vector3<double>(2, 1, 5));
}

TEST_CASE("in double, two tumbling bodies keep their momenta to rounding", "[R3]")
{
  const Matrix3<double> axes_a = rational_rotation<double>(1, 2, 3, 4);
  const Matrix3<double> axes_b = rational_rotation<double>(4, -1, 2, 1);
  const MassProperties<double> box = solid_box<double>(3, {0.3, 0.2, 0.7});
  const MassProperties<double> ball = solid_sphere<double>(0.7, 0.4);
  const BodyPair<double> bodies{
      dynamic_body<double>({{0, 0, 0}, {1, 2, -1}, {3, -2, 1}}, box, axes_a),
      dynamic_body<double>({{1, 0, 0}, {-2, 1, 0}, {0, 4, -3}}, ball, axes_b)};
  const auto sums = [&](const BodyPair<double>& moving)
  {
    return conserved(moving.a.motion, box.mass, world_inertia(box.moments, axes_a)) +
           conserved(moving.b.motion, ball.mass, world_inertia(ball.moments, axes_b));
  };
  const Vector3<double> normal(0.8, 0.6, 0), point(0.6, 0.1, 0.2);
  const BodyPair<double> after = resolve_collision(bodies, normal, point, 0.3);
  // Some thirty operations on numbers up to ten.
  CHECK((sums(after).momentum - sums(bodies).momentum).norm() <= 30 * rounding);
  CHECK((sums(after).angular_momentum - sums(bodies).angular_momentum).norm() <= 30 * rounding);
  CHECK(after.a.motion.velocity != bodies.a.motion.velocity);
}
// [R3]

// [R4]
TEST_CASE("200 random bounces lose exactly (1 - e²) v² / 2K of energy", "[R4]")
{
  RandomMeetings random;
  for (int i = 0; i < 200; ++i)
  {
    const RandomMeeting meeting = random.next();
    const Rational e = Rational(i % 5) / 4;
    const Rational v = meeting.separating_velocity_of(meeting.bodies);
    const Rational k = meeting.inverse_mass();
    const BodyPair<Rational> after =
        resolve_collision(meeting.bodies, meeting.normal, meeting.point, e);
    CHECK(
        meeting.sums(after).energy - meeting.sums(meeting.bodies).energy ==
        -(1 - e * e) * v * v / (2 * k));
  }
}

TEST_CASE("balls of 1 kg and 2 kg that meet at 1.2 m/s, e = 0.5, lose 0.36 J of 2 J", "[R4]")
{
  const TwoBalls balls = two_balls(2);
  const BodyPair<double> after = resolve_collision(
      balls.bodies, balls.manifold.normal, balls.manifold.points[0].position, 0.5);
  CHECK(conserved(balls, balls.bodies).energy == Catch::Approx(2).epsilon(rounding));
  CHECK(conserved(balls, after).energy == Catch::Approx(1.64).epsilon(rounding));
}
// [R4]

// [R5]
TEST_CASE("200 random bounces part at e times the speed of approach, exactly", "[R5]")
{
  RandomMeetings random;
  for (int i = 0; i < 200; ++i)
  {
    const RandomMeeting meeting = random.next();
    const Rational e = Rational(i % 5) / 4;
    const Rational v = meeting.separating_velocity_of(meeting.bodies);
    const BodyPair<Rational> after =
        resolve_collision(meeting.bodies, meeting.normal, meeting.point, e);
    CHECK(meeting.separating_velocity_of(after) == -e * v);
  }
}

TEST_CASE("a glancing hit changes velocities along the normal only", "[R5]")
{
  const TwoBalls balls = two_balls(2);
  const BodyPair<double> after = resolve_collision(
      balls.bodies, balls.manifold.normal, balls.manifold.points[0].position, 0.5);
  // n = (0.6, 0.8), v_n = -1.2, K = 1 + 1/2, so j = 1.2.
  CHECK((after.a.motion.velocity - Vector3<double>(1.28, -0.96, 0)).norm() <= 4 * rounding);
  CHECK((after.b.motion.velocity - Vector3<double>(0.36, 0.48, 0)).norm() <= 4 * rounding);
}
// [R5]

// [R33]
TEST_CASE("head-on with e = 1, balls take the velocities of the closed form, exactly", "[R33]")
{
  const auto after = [](int mass_a, int mass_b, const Rational& v)
  {
    const Vector3<Rational> zero = Vector3<Rational>::Zero();
    const Matrix3<Rational> upright = Matrix3<Rational>::Identity();
    const BodyPair<Rational> bodies{
        dynamic_body<Rational>(
            {zero, vec<Rational>(v, 0, 0), zero}, solid_sphere<Rational>(mass_a, 1), upright),
        dynamic_body<Rational>(
            {vec<Rational>(2, 0, 0), zero, zero}, solid_sphere<Rational>(mass_b, 1), upright)};
    const BodyPair<Rational> result =
        resolve_collision<Rational>(bodies, vec<Rational>(1, 0, 0), vec<Rational>(1, 0, 0), 1);
    return std::pair(result.a.motion.velocity.x(), result.b.motion.velocity.x());
  };
  CHECK(after(1, 1, 3) == std::pair<Rational, Rational>(0, 3)); // they swap
  CHECK(after(2, 1, 3) == std::pair<Rational, Rational>(1, 4));
  CHECK(after(1, 2, 3) == std::pair<Rational, Rational>(-1, 2));
  CHECK(after(999, 1, 1).second == Rational(1998) / 1000); // nearly twice as fast
}
// [R33]

// [rotation_left_out]
TEST_CASE("a hit of two balls needs no rotation: left out, nothing changes", "[R1]")
{
  const TwoBalls balls = two_balls(2);
  BodyPair<double> points = balls.bodies;
  points.a.inverse_inertia.setZero();
  points.b.inverse_inertia.setZero();
  const Vector3<double> normal = balls.manifold.normal;
  const Vector3<double> contact = balls.manifold.points[0].position;
  const BodyPair<double> with = resolve_collision(balls.bodies, normal, contact, 0.5);
  const BodyPair<double> without = resolve_collision(points, normal, contact, 0.5);
  CHECK((with.a.motion.velocity - without.a.motion.velocity).norm() <= rounding);
  CHECK((with.b.motion.velocity - without.b.motion.velocity).norm() <= rounding);
  CHECK(with.a.motion.angular_velocity.norm() <= 10 * rounding);
}
// [rotation_left_out]

// [rotation_needed]
TEST_CASE("a corner hit needs rotation: left out, a cube comes up instead of going on", "[R1]")
{
  const Landing landing = on_pebble();
  BodyPair<double> stiff = landing.bodies;
  stiff.a.inverse_inertia.setZero();
  const double with = bounce(landing.bodies, landing.manifold, 0.5, 1).a.motion.velocity.y();
  const double without = bounce(stiff, landing.manifold, 0.5, 1).a.motion.velocity.y();
  CHECK(with == Catch::Approx(-0.625).epsilon(rounding));
  CHECK(without == Catch::Approx(0.5).epsilon(rounding));
}
// [rotation_needed]
