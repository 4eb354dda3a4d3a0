/// \file
/// What holds for the impulse of a bounce: formulas R1 to R5, R26 and R33, and the cases in which
/// other ways to resolve a collision fail.

#include "05_resolution/bounce_cases.hpp"
#include "05_resolution/conserved.hpp"
#include "05_resolution/impulse.hpp"
#include "05_resolution/impulse_pitfalls.hpp"
#include "05_resolution/impulse_scenes.hpp"
#include "05_resolution/response_cases.hpp"
#include "common/math/rational.hpp"
#include "common/math/rotation.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <map>
#include <random>

using namespace cookbook;

namespace
{

/// A few roundings of numbers of size one: double's unit roundoff is 1.1e-16.
constexpr double rounding = 1e-15;

template <class Real>
Vector3<Real> vec(const Real& x, const Real& y, const Real& z)
{
  return {x, y, z};
}

/// The unit cube of 1 kg with its centre at the origin, down at 1 m/s, above something immovable.
template <class Real>
BodyPair<Real> falling_on_ground()
{
  const Real half = Real(1) / Real(2);
  const MassProperties<Real> cube = solid_box<Real>(1, Vector3<Real>::Constant(half));
  const Motion<Real> down{Vector3<Real>::Zero(), vec<Real>(0, -1, 0), Vector3<Real>::Zero()};
  return {
      movable<Real>(down, cube, Matrix3<Real>::Identity()), immovable<Real>(Vector3<Real>::Zero())};
}

/// A body of mass 1 and moments 1 at the origin, that moves along y and turns about z, above
/// something immovable.
template <class Real>
BodyPair<Real> unit_body(const Real& velocity, const Real& spin)
{
  const Motion<Real> motion{
      Vector3<Real>::Zero(), vec<Real>(0, velocity, 0), vec<Real>(0, 0, spin)};
  return {{motion, Real(1), Matrix3<Real>::Identity()}, immovable<Real>(Vector3<Real>::Zero())};
}

/// Two bodies about to meet, with all that is needed to weigh them.
struct RandomMeeting
{
  BodyPair<Rational> bodies;
  Rational mass_a, mass_b;
  Matrix3<Rational> inertia_a, inertia_b;
  Vector3<Rational> normal, point;

  Conserved<Rational> sums(const BodyPair<Rational>& moving) const
  {
    return conserved(moving.a.motion, mass_a, inertia_a) +
           conserved(moving.b.motion, mass_b, inertia_b);
  }
};

/// Exact bodies and contacts from whole numbers, the same ones every time.
class RandomMeetings
{
public:
  RandomMeeting next()
  {
    RandomMeeting meeting;
    std::tie(meeting.bodies.a, meeting.mass_a, meeting.inertia_a) = body();
    std::tie(meeting.bodies.b, meeting.mass_b, meeting.inertia_b) = body();
    meeting.normal = rotation().col(0);
    meeting.point = vector();
    if (parting_speed(meeting.bodies, meeting.normal, meeting.point) > 0)
    {
      meeting.normal = -meeting.normal;
    }
    return meeting;
  }

private:
  int whole(int least, int most)
  {
    return least + static_cast<int>(random_() % static_cast<unsigned>(most - least + 1));
  }
  Vector3<Rational> vector()
  {
    const int x = whole(-9, 9), y = whole(-9, 9);
    return Vector3<Rational>(x, y, whole(-9, 9)) / Rational(4);
  }
  Matrix3<Rational> rotation()
  {
    const int x = whole(-5, 5), y = whole(-5, 5);
    return rational_rotation<Rational>(whole(1, 5), x, y, whole(-5, 5));
  }
  std::tuple<Body<Rational>, Rational, Matrix3<Rational>> body()
  {
    const int x = whole(1, 9), y = whole(1, 9);
    const MassProperties<Rational> properties{whole(1, 9), {x, y, whole(1, 9)}};
    const Matrix3<Rational> axes = rotation();
    const Vector3<Rational> center = vector(), velocity = vector();
    const Body<Rational> made = movable<Rational>({center, velocity, vector()}, properties, axes);
    return {made, properties.mass, world_inertia(properties.moments, axes)};
  }
  std::mt19937 random_{5};
};

} // namespace

// [R26]
TEST_CASE("a box of 12 kg, 2 by 4 by 6 m, has moments 52, 40, 20; a ball of 5 kg, 2 m, 8", "[R26]")
{
  CHECK(solid_box<double>(12, {1, 2, 3}).moments == Vector3<double>(52, 40, 20));
  CHECK(solid_sphere<double>(5, 2).moments == Vector3<double>(8, 8, 8));
  CHECK(solid_box<double>(12, {1, 2, 3}).mass == 12);
  CHECK(solid_sphere<double>(5, 2).mass == 5);
}

TEST_CASE(
    "a rod of 3 kg, a hundred million times as long as wide, has 2e-16 kg m² about it", "[R26]")
{
  const Vector3<double> moments = solid_box<double>(3, {1, 1e-8, 1e-8}).moments;
  CHECK(moments.x() == Catch::Approx(2e-16).epsilon(rounding));
}

TEST_CASE("eight cubes, moved to the corners of one of twice their side, weigh in as it", "[R26]")
{
  // Each small cube of 1 kg and half extent 1 stands at (±1, ±1, ±1): about x it adds its own
  // moment and 1 kg times the squared distance 1 + 1 of its centre from the axis.
  const Rational small = solid_box<Rational>(1, Vector3<Rational>::Constant(1)).moments.x();
  const Rational whole = solid_box<Rational>(8, Vector3<Rational>::Constant(2)).moments.x();
  CHECK(whole == 8 * (small + 2));
}
// [R26]

// [R1]
TEST_CASE("a unit cube hit at a corner feels like a quarter of its mass: K = 4", "[R1]")
{
  const BodyPair<double> bodies = falling_on_ground<double>();
  const Vector3<double> down(0, -1, 0);
  CHECK(inverse_mass_at(bodies, down, {0.5, -0.5, 0.5}) == Catch::Approx(4).epsilon(rounding));
  CHECK(inverse_mass_at(bodies, down, {0, -0.5, 0}) == 1);
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
    CHECK(inverse_mass_at(meeting.bodies, meeting.normal, meeting.point) == k);
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
  CHECK(std::abs(bounce_impulse(bodies, down, corner, half) - TestType(0.375)) <= some);
  const Motion<TestType> after = collide(bodies, down, corner, half).a.motion;
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
    CHECK(bounce_impulse(bodies, down, corner, 1.0) == 0);
    const Motion<double> after = collide(bodies, down, corner, 1.0).a.motion;
    CHECK(after.velocity == Vector3<double>(0, up, 0));
    CHECK(after.angular_velocity == Vector3<double>(0, 0, 0));
  }
}

TEST_CASE("two immovable bodies that run into each other get no impulse", "[R2]")
{
  BodyPair<double> bodies{immovable<double>({0, 1, 0}), immovable<double>({0, -1, 0})};
  bodies.a.motion.velocity = {0, -1, 0};
  const Vector3<double> down(0, -1, 0), point(0, 0, 0);
  CHECK(inverse_mass_at(bodies, down, point) == 0);
  CHECK(bounce_impulse(bodies, down, point, 1.0) == 0);
  CHECK(collide(bodies, down, point, 1.0).a.motion.velocity == Vector3<double>(0, -1, 0));
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
        meeting.sums(collide(meeting.bodies, meeting.normal, meeting.point, restitution));
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
      movable<double>({{0, 0, 0}, {1, 2, -1}, {3, -2, 1}}, box, axes_a),
      movable<double>({{1, 0, 0}, {-2, 1, 0}, {0, 4, -3}}, ball, axes_b)};
  const auto sums = [&](const BodyPair<double>& moving)
  {
    return conserved(moving.a.motion, box.mass, world_inertia(box.moments, axes_a)) +
           conserved(moving.b.motion, ball.mass, world_inertia(ball.moments, axes_b));
  };
  const Vector3<double> normal(0.8, 0.6, 0), point(0.6, 0.1, 0.2);
  const BodyPair<double> after = collide(bodies, normal, point, 0.3);
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
    const Rational v = parting_speed(meeting.bodies, meeting.normal, meeting.point);
    const Rational k = inverse_mass_at(meeting.bodies, meeting.normal, meeting.point);
    const BodyPair<Rational> after = collide(meeting.bodies, meeting.normal, meeting.point, e);
    CHECK(
        meeting.sums(after).energy - meeting.sums(meeting.bodies).energy ==
        -(1 - e * e) * v * v / (2 * k));
  }
}

TEST_CASE("balls of 1 kg and 2 kg that meet at 1.2 m/s, e = 0.5, lose 0.36 J of 2 J", "[R4]")
{
  const TwoBalls balls = two_balls(2);
  const BodyPair<double> after =
      collide(balls.bodies, balls.manifold.normal, balls.manifold.points[0].position, 0.5);
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
    const Rational v = parting_speed(meeting.bodies, meeting.normal, meeting.point);
    const BodyPair<Rational> after = collide(meeting.bodies, meeting.normal, meeting.point, e);
    CHECK(parting_speed(after, meeting.normal, meeting.point) == -e * v);
  }
}

TEST_CASE("a glancing hit changes velocities along the normal only", "[R5]")
{
  const TwoBalls balls = two_balls(2);
  const BodyPair<double> after =
      collide(balls.bodies, balls.manifold.normal, balls.manifold.points[0].position, 0.5);
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
        movable<Rational>(
            {zero, vec<Rational>(v, 0, 0), zero}, solid_sphere<Rational>(mass_a, 1), upright),
        movable<Rational>(
            {vec<Rational>(2, 0, 0), zero, zero}, solid_sphere<Rational>(mass_b, 1), upright)};
    const BodyPair<Rational> result =
        collide<Rational>(bodies, vec<Rational>(1, 0, 0), vec<Rational>(1, 0, 0), 1);
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
  const BodyPair<double> with = collide(balls.bodies, normal, contact, 0.5);
  const BodyPair<double> without = collide(points, normal, contact, 0.5);
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

// [landings]
TEST_CASE("a cube of 1 kg lands flat, on an edge, on a corner, with e = 0.5", "[R2]")
{
  // The manifold is a nanometre deep: its points are off by up to two, each worth 9 rad/s a metre.
  const double near = 2e-8;
  const auto after = [](const Landing& landing)
  { return bounce(landing.bodies, landing.manifold, 0.5, 40).a.motion; };
  const std::vector<Landing> all = landings();
  CHECK(all[0].manifold.points.size() == 4);
  CHECK(std::abs(after(all[0]).velocity.y() - 0.5) <= near);
  CHECK(after(all[0]).angular_velocity.norm() <= near);
  // The edge is 0.1 m beside the centre: K = 1 + 6 · 0.01.
  CHECK(all[1].manifold.points.size() == 2);
  CHECK(std::abs(after(all[1]).velocity.y() - (1.5 / 1.06 - 1)) <= near);
  CHECK(std::abs(after(all[1]).angular_velocity.norm() - 0.6 * 1.5 / 1.06) <= near);
  // The corner is (-1/22, 1/22) m beside the centre: K = 1 + 6 · 2/22² = 124/121.
  CHECK(all[2].manifold.points.size() == 1);
  CHECK(std::abs(after(all[2]).velocity.y() - (1.5 * 121 / 124 - 1)) <= near);
  CHECK(
      std::abs(after(all[2]).angular_velocity.norm() - 9 * 121 / 124.0 * std::sqrt(2) / 22) <=
      near);
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
        collide<Rational>(meeting.bodies, meeting.normal, meeting.point, Rational(1) / 3);
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

// [verdicts]
TEST_CASE("who holds and who fails at bounces of several points", "[case:S14][case:X18]")
{
  const std::vector<VerdictRow> rows = bounce_verdicts();
  // As published, each point in turn, one pass, four passes.
  const std::vector<std::vector<bool>> expected{
      {false, false, false, true},
      {false, false, false, true},
      {false, true, true, true},
      {false, true, true, true},
      {true, true, true, true}};
  REQUIRE(rows.size() == expected.size());
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    for (std::size_t method = 0; method < 4; ++method)
    {
      INFO(rows[row].what << ": " << rows[row].verdicts[method].what);
      CHECK(rows[row].verdicts[method].holds == expected[row][method]);
    }
  }
}

TEST_CASE("who holds and who fails at pushes", "[case:X19][case:X20][case:X26]")
{
  const std::vector<VerdictRow> rows = response_verdicts();
  // The last cube is so large that its determinant is above the threshold.
  const std::vector<bool> published_holds{false, false, false, false, true, false};
  REQUIRE(rows.size() == published_holds.size());
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    INFO(rows[row].what);
    CHECK(rows[row].verdicts[0].holds == published_holds[row]);
    CHECK(rows[row].verdicts[1].holds);
  }
}
// [verdicts]

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
