/// \file
/// What holds for friction at a contact point: formulas R6, R27, R28 and R29, and the rules that
/// fail.

#include "05_resolution/friction/corner_friction.hpp"
#include "05_resolution/friction/friction.hpp"
#include "05_resolution/friction/trial/friction_pitfalls.hpp"
#include "05_resolution/friction/trial/friction_scenes.hpp"
#include "05_resolution/friction/trial/friction_verdicts.hpp"
#include "tools/exact/exact.hpp"

#include "tests/05_resolution/meetings.hpp"
#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <cmath>
#include <limits>
#include <vector>

using namespace cookbook;

namespace
{

using V = Vector3<double>;

using AlongSurface = Vector2<double>;

const V up(0, 1, 0);
const SurfaceAxes<double> floor_axes = surface_axes(up);

/// A vector of fractions, rounded.
V rounded(const Vector3<Rational>& v)
{
  return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}

Body<double> rounded(const Body<Rational>& body)
{
  Body<double> result;
  result.motion = {
      rounded(body.motion.center), rounded(body.motion.velocity),
      rounded(body.motion.angular_velocity)};
  result.inverse_mass = static_cast<double>(body.inverse_mass);
  for (int column = 0; column < 3; ++column)
  {
    result.inverse_inertia.col(column) =
        rounded(Vector3<Rational>(body.inverse_inertia.col(column)));
  }
  return result;
}

double energy(const Body<double>& body)
{
  const V& w = body.motion.angular_velocity;
  return body.motion.velocity.squaredNorm() / (2 * body.inverse_mass) +
         w.dot(body.inverse_inertia.inverse() * w) / 2;
}

/// A ball of 1 kg, its lowest point at the origin, that moves over the ground without spin.
BodyPair<double> over_ground(const V& velocity)
{
  const Solid ball = ball_at({0, 0.5, 0}, 1, 0.5);
  BodyPair<double> bodies{static_body<double>({0, 0, 0}), ball.body};
  bodies.b.motion.velocity = velocity;
  return bodies;
}

/// What it feels at its lowest point: K = 1 + r²/I = 7/2.
const SlidingMass<double> of_ball{Matrix2<double>::Identity() * 2 / 7, 2 / 7.0};

/// Friction after one more visit to the lowest point of a ball, in the world.
V visited(const BodyPair<double>& ball, const V& accumulated, double most)
{
  const Arms<double> arms = arms_to<double>(ball, {0, 0, 0});
  const AlongSurface sliding = sliding_velocity(ball.a, ball.b, floor_axes, arms);
  return floor_axes.in_world(
      friction_impulse<double>(sliding, of_ball, floor_axes.along(accumulated), most));
}

FrictionRule cone()
{
  return friction_rules().back();
}

} // namespace

// [R6]
TEMPLATE_TEST_CASE("an impulse (3, 4) within 2.5 is (1.5, 2)", "[R6]", float, double)
{
  using Vector = Vector2<TestType>;
  const Vector impulse(3, 4);
  CHECK(within_cone<TestType>(impulse, 10) == impulse);
  CHECK(within_cone<TestType>(impulse, 5) == impulse);
  CHECK(within_cone<TestType>(impulse, TestType(2.5)) == Vector(TestType(1.5), 2));
  CHECK(within_cone<TestType>(impulse, 0) == Vector(0, 0));
  CHECK(within_cone<TestType>(impulse, -1) == Vector(0, 0));
  CHECK(within_cone<TestType, 2>(Vector::Zero(), 0) == Vector(0, 0));
}

TEMPLATE_TEST_CASE(
    "the axes of a surface are across its normal and each other, of length 1", "[R6]", double,
    float)
{
  using Vector = Vector3<TestType>;
  const TestType rounding = 4 * std::numeric_limits<TestType>::epsilon();
  std::vector<Vector> normals{{0, TestType(0.6), TestType(-0.8)}, {TestType(1e-8), 0, -1}};
  for (int axis = 0; axis < 3; ++axis)
  {
    normals.push_back(Vector::Unit(axis));
    normals.push_back(-Vector::Unit(axis));
  }
  RandomMeetings random;
  for (int i = 0; i < 1'000; ++i)
  {
    normals.push_back(rounded(random.next().normal).template cast<TestType>());
  }
  for (const Vector& normal : normals)
  {
    const auto [u, w] = surface_axes(normal);
    CAPTURE(normal.transpose(), u.transpose(), w.transpose());
    REQUIRE(std::abs(u.dot(normal)) <= rounding);
    REQUIRE(std::abs(u.norm() - 1) <= rounding);
    REQUIRE((w - normal.cross(u)).norm() <= rounding);
  }
  const auto [u, w] = surface_axes<TestType>(Vector::Zero());
  CHECK(u == Vector::UnitX());
  CHECK(w == Vector::UnitY());
}

TEST_CASE(
    "along the axes of a surface (3, 5, 4) is what lies along it; back in the world (3, 0, 4)")
{
  const V whole(3, 5, 4);
  CHECK(floor_axes.along(whole).norm() == Catch::Approx(5).epsilon(rounding));
  CHECK((floor_axes.in_world(floor_axes.along(whole)) - V(3, 0, 4)).norm() <= rounding);
}

TEST_CASE("a ball that slides at (3, 0, 4) feels 2/7 of its mass: 10/7 N s make it roll", "[R6]")
{
  const BodyPair<double> bodies = over_ground({3, 0, 4});
  const Arms<double> arms = arms_to<double>(bodies, {0, 0, 0});
  const SlidingMass<double> felt = sliding_mass(bodies.a, bodies.b, floor_axes, arms);
  CHECK(felt.smallest == Catch::Approx(2 / 7.0).epsilon(rounding));
  CHECK((felt.matrix - of_ball.matrix).norm() <= rounding);
  const V enough = visited(bodies, {0, 0, 0}, 5);
  CHECK((enough + V(3, 0, 4) * 2 / 7).norm() <= rounding);
  BodyPair<double> rolls = bodies;
  apply_impulse(rolls.a, rolls.b, arms, enough);
  CHECK(sliding_velocity(rolls.a, rolls.b, floor_axes, arms).norm() <= 4 * rounding);
  CHECK((rolls.b.motion.velocity - V(3, 0, 4) * 5 / 7).norm() <= 4 * rounding);
  // No more than 1/2, straight against the sliding.
  const V little = visited(bodies, {0, 0, 0}, 0.5);
  CHECK((little + V(0.3, 0, 0.4)).norm() <= rounding);
}

TEST_CASE("when the normal impulse shrinks, friction hands back what it may not have given", "[R6]")
{
  const BodyPair<double> still = over_ground({0, 0, 0});
  const V given(0.3, 0, 0.4);
  CHECK(visited(still, given, 0.5) == given);
  CHECK((visited(still, given, 0.25) - given / 2).norm() <= rounding);
  CHECK(visited(still, given, 0) == V(0, 0, 0));
}

TEST_CASE("friction keeps momenta and takes energy, for 100 random pairs", "[R6][R3]")
{
  RandomMeetings random;
  for (int i = 0; i < 100; ++i)
  {
    const RandomMeeting meeting = random.next();
    const V normal = rounded(meeting.normal), point = rounded(meeting.point);
    const BodyPair<double> before{rounded(meeting.bodies.a), rounded(meeting.bodies.b)};
    const Arms<double> arms = arms_to(before, point);
    const SurfaceAxes<double> surface = surface_axes(normal);
    const SlidingMass<double> mass = sliding_mass(before.a, before.b, surface, arms);
    const AlongSurface sliding = sliding_velocity(before.a, before.b, surface, arms);
    const V impulse = surface.in_world(friction_impulse<double>(sliding, mass, {0, 0}, 0.5));
    BodyPair<double> after = before;
    apply_impulse(after.a, after.b, arms, impulse);
    CHECK(impulse.norm() <= 0.5 + rounding);
    CHECK(std::abs(impulse.dot(normal)) <= 100 * rounding);
    CHECK(energy(after.a) + energy(after.b) <= energy(before.a) + energy(before.b) + 1e-12);
    const V gained_a = (after.a.motion.velocity - before.a.motion.velocity) / before.a.inverse_mass;
    const V gained_b = (after.b.motion.velocity - before.b.motion.velocity) / before.b.inverse_mass;
    CHECK((gained_a + gained_b).norm() <= 1e-13);
  }
}

TEST_CASE("visited often, 100 points either stick or rub straight against their sliding", "[R6]")
{
  RandomMeetings random;
  int sliding = 0;
  for (int i = 0; i < 100; ++i)
  {
    const RandomMeeting meeting = random.next();
    const V normal = rounded(meeting.normal), point = rounded(meeting.point);
    Body<double> a = rounded(meeting.bodies.a), b = rounded(meeting.bodies.b);
    const Arms<double> arms = arms_to<double>({a, b}, point);
    const SurfaceAxes<double> surface = surface_axes(normal);
    const SlidingMass<double> mass = sliding_mass(a, b, surface, arms);
    AlongSurface sum = AlongSurface::Zero();
    for (int visit = 0; visit < 400; ++visit)
    {
      const AlongSurface next =
          friction_impulse(sliding_velocity(a, b, surface, arms), mass, sum, 0.2);
      apply_impulse<double>(a, b, arms, surface.in_world(next - sum));
      sum = next;
    }
    const AlongSurface slides = sliding_velocity(a, b, surface, arms);
    if (slides.norm() > 1e-9)
    {
      ++sliding;
      CHECK(sum.norm() == Catch::Approx(0.2).epsilon(1e-12));
      CHECK(sum.normalized().dot(slides.normalized()) == Catch::Approx(-1).epsilon(1e-12));
    }
    CHECK(sum.norm() <= 0.2 + rounding);
  }
  CHECK((sliding > 20 && sliding < 100));
}

TEST_CASE(
    "a unit cube at a corner: K along the floor is 5.5 across its diagonal, 2.5 along it", "[R6]")
{
  // The corner is (1/2, −1/2, 1/2) from the centre and the moment 1/6. Along (1, 0, 1)/√2 the
  // lever is 1/2, across it √3/2: 1 + 6/4 and 1 + 6 · 3/4.
  const Solid cube = box_on_floor(1, {0.5, 0.5, 0.5});
  const Body<double> ground = static_body<double>({0, 0, 0});
  const Arms<double> corner = arms_to<double>({ground, cube.body}, {0.5, 0, 0.5});
  CHECK(
      inverse_mass_at(ground, cube.body, heading(45), corner) ==
      Catch::Approx(2.5).epsilon(4 * rounding));
  const SlidingMass<double> felt = sliding_mass(ground, cube.body, floor_axes, corner);
  const AlongSurface diagonal = floor_axes.along(heading(45)),
                     across = floor_axes.along(heading(135));
  CHECK(1 / felt.smallest == Catch::Approx(5.5).epsilon(4 * rounding));
  CHECK((felt.matrix * diagonal - diagonal / 2.5).norm() <= 4 * rounding);
  CHECK((felt.matrix * across - across / 5.5).norm() <= 4 * rounding);
}

TEST_CASE("one direction coupled with itself is K; with one across it, what turning alone couples")
{
  const Solid cube = box_on_floor(2, {0.5, 0.25, 1});
  const V arm(0.3, -0.25, 0.7), along = heading(20), other = heading(65);
  CHECK(
      coupling_at(cube.body, along, along, arm) ==
      Catch::Approx(inverse_mass_at(cube.body, along, arm)).epsilon(4 * rounding));
  const V turn = cube.body.inverse_inertia * arm.cross(other);
  CHECK(
      coupling_at(cube.body, along, other, arm) ==
      Catch::Approx(std::sqrt(0.5) / 2 + turn.cross(arm).dot(along)).epsilon(4 * rounding));
}

TEST_CASE("no direction of 360 along the surface has a larger K, for 100 random pairs", "[R6]")
{
  RandomMeetings random;
  for (int i = 0; i < 100; ++i)
  {
    const RandomMeeting meeting = random.next();
    const V normal = rounded(meeting.normal), point = rounded(meeting.point);
    const Body<double> a = rounded(meeting.bodies.a), b = rounded(meeting.bodies.b);
    const Arms<double> arms = arms_to<double>({a, b}, point);
    const V along = normal.unitOrthogonal(), across = normal.cross(along);
    double largest = 0;
    for (int degrees = 0; degrees < 360; ++degrees)
    {
      const V unit = heading(degrees);
      const V direction = unit.x() * along + unit.z() * across;
      largest = std::max(largest, inverse_mass_at(a, b, direction, arms));
    }
    // Half a degree off, a cosine squared is short of one by 7.6e-5.
    const double k = 1 / sliding_mass(a, b, surface_axes(normal), arms).smallest;
    CHECK(k >= largest * (1 - 10 * rounding));
    CHECK(k <= largest * (1 + 8e-5));
  }
}

TEST_CASE("one visit ends the sliding of 100 random pairs, if the cone is wide enough", "[R6]")
{
  RandomMeetings random;
  for (int i = 0; i < 100; ++i)
  {
    const RandomMeeting meeting = random.next();
    const V normal = rounded(meeting.normal), point = rounded(meeting.point);
    Body<double> a = rounded(meeting.bodies.a), b = rounded(meeting.bodies.b);
    const Arms<double> arms = arms_to<double>({a, b}, point);
    const SurfaceAxes<double> surface = surface_axes(normal);
    const AlongSurface sliding = sliding_velocity(a, b, surface, arms);
    const AlongSurface impulse =
        friction_impulse<double>(sliding, sliding_mass(a, b, surface, arms), {0, 0}, 1e9);
    apply_impulse(a, b, arms, surface.in_world(impulse));
    CHECK(sliding_velocity(a, b, surface, arms).norm() <= 1e-12 * (1 + sliding.norm()));
  }
}

TEST_CASE("a rod that turns about its length only, and cannot be moved, is held across it", "[R6]")
{
  // Its surface is 1 m off the axis and the moment 1/2: K is 2 across the axis, none along it.
  const Body<double> ground = static_body<double>({0, 0, 0});
  Body<double> rod = static_body<double>({0, 1, 0});
  rod.inverse_inertia(0, 0) = 2;
  const SlidingMass<double> felt = sliding_mass(ground, rod, floor_axes, {{0, 0, 0}, {0, -1, 0}});
  CHECK(felt.smallest == 0.5);
  const auto held = [&](const V& sliding)
  {
    return floor_axes.in_world(
        friction_impulse<double>(floor_axes.along(sliding), felt, {0, 0}, 9));
  };
  CHECK((held({0, 0, 3}) - V(0, 0, -1.5)).norm() <= rounding);
  CHECK(held({3, 0, 0}).allFinite());
}

TEST_CASE("nothing rubs where nothing moves, and where no push moves it", "[R6]")
{
  const BodyPair<double> still = over_ground({0, -3, 0});
  CHECK(visited(still, {0, 0, 0}, 1) == V(0, 0, 0));
  BodyPair<double> driven = over_ground({1, 0, 0});
  driven.b.inverse_mass = 0;
  driven.b.inverse_inertia.setZero();
  const Arms<double> arms = arms_to<double>(driven, {0, 0, 0});
  const SlidingMass<double> felt = sliding_mass(driven.a, driven.b, floor_axes, arms);
  CHECK(felt.smallest == 0);
  CHECK(felt.matrix.isZero(0));
  CHECK(friction_impulse<double>({1, 0}, felt, {0, 0}, 1) == AlongSurface(0, 0));
}
// [R6]

// [torsional_friction]
TEST_CASE("two bodies that turn against each other turn together, if the impulse may be so large")
{
  RandomMeetings random;
  for (int i = 0; i < 100; ++i)
  {
    const RandomMeeting meeting = random.next();
    const BodyPair<double> before{rounded(meeting.bodies.a), rounded(meeting.bodies.b)};
    const auto spin = [](const Body<double>& body) -> V { return body.motion.angular_velocity; };
    const V gap = spin(before.b) - spin(before.a);
    BodyPair<double> held = before;
    apply_torsional_friction<double>(held.a, held.b, 1e9);
    CHECK((spin(held.b) - spin(held.a)).norm() <= 1e-12 * (1 + gap.norm()));
    // What one has gained the other has lost, and half of it takes away half of the turning.
    const V impulse = before.b.inverse_inertia.inverse() * (spin(held.b) - spin(before.b));
    const V other = before.a.inverse_inertia.inverse() * (spin(held.a) - spin(before.a));
    CHECK((impulse + other).norm() <= 1e-10 * (1 + impulse.norm()));
    BodyPair<double> half = before;
    apply_torsional_friction<double>(half.a, half.b, impulse.norm() / 2);
    CHECK((spin(half.b) - spin(half.a) - gap / 2).norm() <= 1e-10 * (1 + gap.norm()));
    CHECK(energy(half.a) + energy(half.b) <= energy(before.a) + energy(before.b) + 1e-12);
    CHECK(half.a.motion.velocity == before.a.motion.velocity);
    BodyPair<double> free = before;
    apply_torsional_friction<double>(free.a, free.b, 0);
    CHECK(spin(free.a) == spin(before.a));
  }
}

TEST_CASE("nothing is held that cannot be turned, and nothing ceases to be a number")
{
  for (const V& inverse : {V(0, 0, 0), V(1, 0, 1), V(1e150, 1e150, 1e-150)})
  {
    CAPTURE(inverse);
    BodyPair<double> bodies{static_body<double>({0, 0, 0}), static_body<double>({0, 1, 0})};
    bodies.b.inverse_inertia = inverse.asDiagonal();
    bodies.b.motion.angular_velocity = {1, 2, 3};
    apply_torsional_friction<double>(bodies.a, bodies.b, 1);
    CHECK(bodies.b.motion.angular_velocity == V(1, 2, 3));
  }
  for (const double inverse : {1e-150, 1.0, 1e150})
  {
    BodyPair<double> bodies{static_body<double>({0, 0, 0}), static_body<double>({0, 1, 0})};
    bodies.b.inverse_inertia = inverse * Matrix3<double>::Identity();
    bodies.b.motion.angular_velocity = {1, 2, 3};
    apply_torsional_friction<double>(bodies.a, bodies.b, 4 / inverse);
    CHECK(bodies.b.motion.angular_velocity.norm() <= rounding);
  }
}
// [torsional_friction]

// [R27]
TEST_CASE("a ball at 7 m/s, μ = 0.2, slides for 1.0194 s, then rolls at 5 m/s", "[R27][case:S28]")
{
  const double right = 2 * 7 / (7 * 0.2 * 9.81);
  OneContactScene scene = sliding_ball();
  const Rolling rolling = begins_to_roll(scene, cone(), 5);
  CHECK(rolling.time >= right);
  CHECK(rolling.time <= right + scene.step + rounding);
  CHECK(rolling.speed == Catch::Approx(5).epsilon(1e-12));
  const Motion<double> half_way = mover(advanced(scene, cone(), 0.5));
  CHECK(half_way.velocity.x() == Catch::Approx(7 - 0.2 * 9.81 * 0.5).epsilon(1e-12));
  const Motion<double> later = mover(advanced(scene, cone(), 3));
  CHECK(later.velocity.x() == Catch::Approx(5).epsilon(1e-12));
  CHECK(later.angular_velocity.z() == Catch::Approx(-10).epsilon(1e-12));
}
// [R27]

// [R28]
TEST_CASE(
    "0.1° below tan θ = μ a cube holds for 10 s, 0.1° above it slides", "[R28][case:S10][long]")
{
  for (const double friction : {0.2, 0.6})
  {
    const double limit = std::atan(friction) * 180 / std::numbers::pi;
    for (const double towards : {0.0, 45.0})
    {
      CHECK(way(advanced(cube_on_slope(friction, limit - 0.1, towards), cone(), 10)) <= 1e-3);
      CHECK(way(advanced(cube_on_slope(friction, limit + 0.1, towards), cone(), 10)) > 0.5);
    }
  }
}

TEST_CASE("on 10° with μ = 0.6 a cube stays where it is, to a micrometre in 10 s", "[R28][case:S9]")
{
  CHECK(way(advanced(cube_on_slope(0.6, 10), cone(), 10)) <= 1e-6);
}

TEST_CASE("down 30° with μ = 0.5 it gains 0.65715 m/s a second, whichever way", "[R28][case:S11]")
{
  const double right = 9.81 * (0.5 - 0.5 * std::sqrt(0.75));
  CHECK(right == Catch::Approx(0.65715).epsilon(1e-5));
  for (const double towards : {0.0, 20.0, 45.0})
  {
    const OneContactScene early = advanced(cube_on_slope(0.5, 30, towards), cone(), 0.5);
    const OneContactScene late = advanced(early, cone(), 0.5);
    const double gained = mover(late).velocity.norm() - mover(early).velocity.norm();
    CHECK(gained == Catch::Approx(right / 2).epsilon(1e-9));
  }
}

TEST_CASE(
    "a box of width to height 1/2 stands on 26.5° and topples on 26.6°, tan⁻¹ 1/2 between",
    "[R28][long]")
{
  CHECK(topples(cone(), 26.5, false).holds);
  CHECK(topples(cone(), 26.6, true).holds);
}
// [R28]

// [R29]
TEST_CASE(
    "a block at 5 m/s, μ = 0.4, goes 3.186 m, less half a step, any heading",
    "[R29][case:S13][long]")
{
  const OneContactScene scene = sliding_block({0, 0, 0});
  // Each step takes μ g h from the speed before it moves the block.
  const double loss = 0.4 * 9.81 * scene.step;
  double right = 0;
  for (double speed = 5 - loss; speed > 0; speed -= loss)
  {
    right += speed * scene.step;
  }
  CHECK(right == Catch::Approx(25 / (2 * 0.4 * 9.81) - 5 * scene.step / 2).epsilon(1e-5));
  const auto [shortest, longest] = stopping_ways(cone());
  CHECK(shortest == Catch::Approx(right).epsilon(1e-5));
  CHECK(longest == Catch::Approx(right).epsilon(1e-5));
}

TEST_CASE("it stops on the line it started along, and the pyramid bends 30° to 18°", "[case:S13]")
{
  const auto turned = [](const FrictionRule& rule)
  {
    const V end = mover(advanced(sliding_block(5 * heading(30)), rule, 2)).center;
    return std::atan2(end.z(), end.x()) * 180 / std::numbers::pi;
  };
  CHECK(turned(cone()) == Catch::Approx(30).epsilon(1e-6));
  CHECK((turned(friction_rules()[2]) > 18 && turned(friction_rules()[2]) < 19));
}
// [R29]

// [spin]
TEST_CASE("without spin a block stops where it stops with it, to a millimetre", "[R29]")
{
  OneContactScene scene = sliding_block(5 * heading(30));
  const V right = mover(advanced(scene, cone(), 2)).center;
  scene.solids[1].body.inverse_inertia.setZero();
  CHECK((mover(advanced(scene, cone(), 2)).center - right).norm() <= 1e-3);
}

TEST_CASE(
    "without spin a ball at 7 m/s, μ = 0.2, stops after 3.57 s; with it, it rolls on", "[R27]")
{
  OneContactScene scene = sliding_ball();
  CHECK(mover(advanced(scene, cone(), 4)).velocity.norm() == Catch::Approx(5).epsilon(1e-12));
  scene.solids[1].body.inverse_inertia.setZero();
  CHECK(mover(advanced(scene, cone(), 3.5)).velocity.norm() > 0.1);
  CHECK(mover(advanced(scene, cone(), 4)).velocity.norm() <= 1e-12);
}
// [spin]

// [S12]
TEST_CASE(
    "25 balls on a pushed box: 12.66 N over 10 + 25 · 2/7 kg, and 2/7 of it", "[case:S12][long]")
{
  // A ball on a plate that speeds up rolls after it with 2/7 of its acceleration.
  const double right = (150 - 0.4 * 35 * 9.81) / (10 + 50 / 7.0);
  CHECK(right == Catch::Approx(0.7385).epsilon(1e-4));
  const auto [box, ball] = accelerations(cone());
  CHECK(box == Catch::Approx(right).epsilon(1e-4));
  CHECK(ball == Catch::Approx(right * 2 / 7).epsilon(1e-4));
  // 150 N on the diagonal are 106 along each axis, and the pyramid holds up to 137 there.
  CHECK(accelerations(friction_rules()[2]).first <= 1e-9);
}
// [S12]

// [friction_pitfalls]
TEST_CASE("along the diagonal a pyramid holds √2 times as much, a polygon 1/cos(90°/n)", "[R6]")
{
  CHECK(within_pyramid<double>({5, 5}, 1) == AlongSurface(1, 1));
  CHECK(within_pyramid<double>({-5, 0.5}, 1) == AlongSurface(-1, 0.5));
  for (const int axes : {2, 4, 8})
  {
    const double corner = 90.0 / axes;
    const auto pushed = [](double degrees) { return floor_axes.along(5 * heading(degrees)); };
    const double held = within_polygon<double>(pushed(corner), 1, axes).norm();
    CHECK(held == Catch::Approx(1 / std::cos(corner * std::numbers::pi / 180)).epsilon(1e-14));
    CHECK(within_polygon<double>(pushed(2 * corner), 1, axes).norm() == Catch::Approx(1));
    CHECK(within_polygon<double>({0.5, 0.1}, 1, axes) == AlongSurface(0.5, 0.1));
  }
}

TEST_CASE("as published, 7 cm/s or 0.005 N s of friction pass for zero", "[case:X21]")
{
  const auto slides_on = [](double speed, int count)
  {
    const BodyPair<double> bodies = over_ground({speed, -1, 0});
    return answered_as_published<double>(bodies, up, {0, 0, 0}, count, 0, 0.6)
        .b.motion.velocity.x();
  };
  CHECK(slides_on(0.05, 1) == 0.05);
  CHECK(slides_on(0.0707, 1) == 0.0707);
  // 0.08 m/s ask for 0.08 · 2/7 = 0.0229 N s at one point, for 0.0046 at each of five.
  CHECK(slides_on(0.08, 1) == Catch::Approx(0.08 * 5 / 7).epsilon(1e-14));
  CHECK(slides_on(0.08, 5) == 0.08);
  // Without an impulse there is nothing to do at all.
  const BodyPair<double> separating = over_ground({3, 1, 0});
  const BodyPair<double> after =
      answered_as_published<double>(separating, up, {0, 0, 0}, 1, 0, 0.6);
  CHECK(after.b.motion.velocity == V(3, 1, 0));
}

TEST_CASE("as published, a cube creeps down 10° by most of a metre in 10 s", "[case:S9][case:X21]")
{
  for (const double rate : {60.0, 240.0})
  {
    OneContactScene scene = cube_on_slope(0.6, 10);
    scene.step = 1 / rate;
    const double crept = way(advanced(scene, friction_rules().front(), 10));
    INFO(crept);
    CHECK((crept > 0.7 && crept < 1.2));
  }
}
// [friction_pitfalls]

TEST_CASE(
    "what holds and what fails at friction",
    "[case:S9][case:S10][case:S11][case:S12][case:S13][case:S28][long]")
{
  check_verdicts(
      friction_verdicts(), names_of(friction_rules()),
      {{"S9", {"box: constant bound", "pyramid: two axes", "cone"}},
       {"S10", {"box: constant bound", "pyramid: two axes", "cone"}},
       {"31.1°: slides 1.36 m in 10 s", {"pyramid: two axes", "cone"}},
       {"31.1°, down the diagonal: the same", {"cone"}},
       {"S11", {"dead zone, as published", "pyramid: two axes", "cone"}},
       {"box twice as high as wide, 26.4°: stands",
        {"box: constant bound", "pyramid: two axes", "cone"}},
       {"the same, 26.7°: topples",
        {"dead zone, as published", "box: constant bound", "pyramid: two axes", "cone"}},
       {"S12", {"dead zone, as published", "cone"}},
       {"S13", {"cone"}},
       {"S28", {"box: constant bound", "pyramid: two axes", "cone"}},
       {"the same, spin left out", {}}});
}
