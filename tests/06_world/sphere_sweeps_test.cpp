/// \file
/// Balls on their way through a step: nothing is passed, nothing hangs in the air, and a bounce has
/// its friction.

#include "06_world/contacts/start_body.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/trial/world_measures.hpp"
#include "06_world/impacts/toi_substeps.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "06_world/sweeps/time_of_impact.hpp"

#include "tests/06_world/evenly.hpp"
#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace cookbook;

namespace
{

constexpr int tries = inputs(10'000, 50), many_tries = inputs(24'000, 48);

GameWorld after(const Scene& scene, int steps, const std::string& solver = "direct")
{
  GameWorld world(scene, solver_named(solver));
  for (int i = 0; i < steps; ++i)
  {
    world.step();
  }
  return world;
}

/// What a wall does when a ball comes.
enum class Wall
{
  fixed, ///< nothing moves it
  light, ///< a plate of 1 cm and more and 5 to 100 kg, which stands on the ground
  comes  ///< flies towards the ball at 1 to 100 m/s
};

/// A ball at a wall.
struct Shot
{
  Scene scene;
  int steps; ///< after which the ball would be far behind the wall
};

/// A ball of 2 mm to 20 cm at 1 to 1,000 m/s, at a wall of 1 mm to 5 cm, square or aslant to it; a
/// light wall, which gives way, is met by balls of 1 cm and more at up to 200 m/s.
Shot shot(BoxDraw& draw, bool rolls, Wall kind)
{
  const bool light = kind == Wall::light;
  const double radius = evenly(draw, light ? 0.01 : 0.002, 0.2);
  const double speed = evenly(draw, 1, light ? 200 : 1000);
  const double half = evenly(draw, light ? 0.005 : 0.0005, 0.025);
  const double aslant = draw.between(-0.7, 0.7);
  const double start = draw.between(0.01, 2) + radius + half;
  Scene scene;
  const double size = light ? 1 : 3 + speed / 10;
  scene.bodies.push_back(
      draw.whole(2) == 0 ? ground() : box_body("ground", {100, 1, 100}, {0, -1, 0}, 0));
  SceneBody sphere = ball_body("ball", radius, {-start, rolls ? radius : 1.5, 0});
  sphere.velocity = speed * Vector3<double>(1, 0, aslant).normalized();
  sphere.angular_velocity = Vector3<double>(0, 1, 0).cross(sphere.velocity) / radius;
  sphere.restitution = draw.whole(2) == 0 ? 0 : draw.between(0, 1);
  SceneBody wall = box_body("wall", {half, size, 2 * size}, {0, size, 0}, 0);
  if (light)
  {
    wall.mass = evenly(draw, 5, 100);
  }
  if (kind == Wall::comes)
  {
    wall.mass = 1e6;
    wall.position.y() = size + 0.1; // clear of the ground
    wall.velocity = {-evenly(draw, 1, 100), 0, 0};
  }
  scene.bodies.push_back(wall);
  scene.bodies.push_back(sphere);
  return {scene, 2 + static_cast<int>(60 * 3 * start / speed)};
}

/// Where the centre of a body is as seen from another.
Vector3<double> seen_from(const GameWorld& world, std::size_t other, std::size_t body)
{
  const RigidBody &from = world.bodies()[other], &seen = world.bodies()[body];
  return from.axes.transpose() * (seen.motion.center - from.motion.center);
}

/// Whether the ball goes through the wall, and not round it: in a step both go straight, and the
/// wall turns steadily.
bool goes_through(const Shot& shot, const std::string& solver)
{
  GameWorld world(shot.scene, solver_named(solver));
  const Vector3<double> half = std::get<BoxShape>(shot.scene.bodies[1].shape).half_extents;
  for (int i = 0; i < shot.steps; ++i)
  {
    const std::vector<RigidBody> before = world.bodies();
    world.step();
    const auto seen = [&](double fraction) -> Vector3<double>
    {
      const auto place = [&](std::size_t body) -> Vector3<double>
      {
        const Vector3<double>& from = before[body].motion.center;
        return from + fraction * (world.bodies()[body].motion.center - from);
      };
      const RigidBody &was = before[1], &is = world.bodies()[1];
      return was.orientation.slerp(fraction, is.orientation).conjugate() * (place(2) - place(1));
    };
    if (seen(0).x() < 0 && seen(1).x() >= 0)
    {
      double outside = 0, behind = 1;
      while (behind - outside > 1e-9)
      {
        const double middle = (outside + behind) / 2;
        (seen(middle).x() < 0 ? outside : behind) = middle;
      }
      const Vector3<double> cut = seen(behind);
      if (std::abs(cut.y()) < half.y() && std::abs(cut.z()) < half.z())
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace

TEST_CASE("balls at rest that are pulled together by 10 m/s² each close 5 m in √½ s")
{
  const Vector3<double> none = Vector3<double>::Zero();
  const RigidBody left_ball = rigid_body(ball_body("left", 0.5, {0, 0, 0}));
  const RigidBody right_ball = rigid_body(ball_body("right", 0.5, {6, 0, 0}));
  const Trajectory left{&left_ball, state_of(left_ball), 0, none, {{10, 0, 0}}, none};
  const Trajectory right{&right_ball, state_of(right_ball), 0, none, {{-10, 0, 0}}, none};
  const auto hit = TimeOfImpact{left, right, 0, 1, 0}(SphereShape{0.5}, SphereShape{0.5});
  REQUIRE(hit);
  CHECK(hit->time == Catch::Approx(std::sqrt(0.5)).epsilon(1e-9));
  CHECK(hit->normal.isApprox(Vector3<double>(1, 0, 0)));
}

TEST_CASE("a body that may not rotate follows its trajectory, a clamped one stays")
{
  RigidBody box = rigid_body(box_body("box", {0.1, 0.2, 0.3}, {0, 5, 0}));
  box.motion.velocity = {1, 2, 3};
  box.motion.angular_velocity = {4, 5, 6};
  const Vector3<double> none = Vector3<double>::Zero();
  Trajectory trajectory{&box, state_of(box), 0.25, box.motion.velocity, {{0, -10, 0}}, none};
  const RigidBody end = end_of_trajectory(trajectory, 0.75, ToiResponse::no_rotation);
  CHECK((end.motion.center - Vector3<double>(0.5, 5 + 1 - 1.25, 1.5)).norm() <= 1e-14);
  CHECK((end.motion.velocity - Vector3<double>(1, 2 - 5, 3)).norm() <= 1e-14);
  CHECK(end.motion.angular_velocity == box.motion.angular_velocity);
  CHECK(end.orientation.coeffs() == box.orientation.coeffs());
  CHECK(trajectory.spin == none);
  const RigidBody free = end_of_trajectory(trajectory, 0.75, ToiResponse::free);
  CHECK((free.motion.center - end.motion.center).norm() <= 1e-14);
  CHECK((free.motion.velocity - end.motion.velocity).norm() <= 1e-14);
  CHECK(free.orientation.angularDistance(box.orientation) > 1);
  CHECK((trajectory.spin - spin_between(state_of(box), free, 0.5)).norm() <= 1e-14);
}

// [P23]
TEST_CASE(
    "a ball 1 m above the floor touches after sqrt(2 / g), thrown down at 3 m/s sooner", "[P23]")
{
  for (const double down : {0.0, 3.0})
  {
    const double gravity = 9.81, step = 1;
    int looks = 0;
    const auto look = [&](double fraction)
    {
      ++looks;
      const double fallen = down * fraction + gravity / 2 * fraction * fraction;
      return GapState<double>{{{0, -1, 0}, 1 - fallen}, down + gravity * fraction, gravity};
    };
    const auto hit = first_touch<double>(0, gravity * step * step, 1e-14, look);
    REQUIRE(hit);
    // The root of v t + g t² / 2 = 1.
    CHECK(
        hit->time ==
        Catch::Approx((std::sqrt(down * down + 2 * gravity) - down) / gravity).epsilon(1e-14));
    CHECK(looks <= 3);
  }
}

TEST_CASE(
    "a bar of 2 m that turns at 1 rad/s meets a ball beside its middle when geometry says", "[P23]")
{
  // Seen along the axis of the turn: a bar of half height 0.1, a ball of 0.1 m at (0.8, 0.6).
  RigidBody bar = rigid_body(box_body("bar", {1, 0.1, 1}, {0, 0, 0}));
  RigidBody sphere = rigid_body(ball_body("ball", 0.1, {0.8, 0.6, 0}));
  RigidBody turned = bar;
  turned.orientation = rotation_by<double>({0, 0, 1});
  const Trajectory of_bar = pushed_trajectory(state_of(bar), turned, 1, {});
  const Trajectory of_ball = pushed_trajectory(state_of(sphere), sphere, 1, {});
  const TimeOfImpact touch{of_ball, of_bar, 0, 1, 0};
  const auto hit = touch(SphereShape{0.1}, BoxShape{{1, 0.1, 1}});
  REQUIRE(hit);
  // The ball is 1 m from the middle at an angle of atan(3/4); its surface meets the bar's upper
  // face where it is 0.2 above the bar's plane: sin(atan(3/4) - t) = 0.2.
  CHECK(hit->time == Catch::Approx(std::atan(0.75) - std::asin(0.2)).epsilon(1e-12));
}
// [P23]

// [walls]
TEST_CASE(
    "24,000 balls that roll at 1 to 1,000 m/s do not pass a wall of 1 mm to 5 cm, nor, up to 200 "
    "m/s, a plate that stands",
    "[case:J1]")
{
  for (const char* const solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const Wall kind : {Wall::fixed, Wall::light})
    {
      BoxDraw draw(1);
      for (int i = 0; i < many_tries / 6; ++i)
      {
        const Shot one = shot(draw, true, kind);
        CAPTURE(solver, static_cast<int>(kind), i);
        REQUIRE_FALSE(goes_through(one, solver));
      }
    }
  }
}

TEST_CASE("nor 10,000 balls in flight a wall that comes towards them at 1 to 100 m/s", "[case:J1]")
{
  BoxDraw draw(2);
  for (int i = 0; i < tries; ++i)
  {
    Shot one = shot(draw, false, Wall::comes);
    one.scene.gravity.setZero();
    CAPTURE(i);
    REQUIRE_FALSE(goes_through(one, "direct"));
  }
}
// [walls]

TEST_CASE("24,000 pairs of balls that fly at each other do not pass each other", "[case:J1]")
{
  BoxDraw draw(3);
  for (int i = 0; i < many_tries; ++i)
  {
    Scene scene;
    scene.gravity.setZero();
    double bounding_radius = 0;
    for (const double side : {-1.0, 1.0})
    {
      const double radius = evenly(draw, 0.002, 0.2);
      bounding_radius += radius;
      SceneBody sphere = ball_body(side < 0 ? "left" : "right", radius, {side * 1.5, 0, 0});
      sphere.mass = evenly(draw, 0.01, 100);
      sphere.velocity = {-side * evenly(draw, 1, 1000), 0, 0};
      const double restitution = draw.between(0, 1);
      sphere.restitution = i % 4 == 0 ? 0 : restitution;
      scene.bodies.push_back(sphere);
    }
    const double separation = draw.between(0, 0.9) * bounding_radius, turn = draw.between(0, 6.3);
    scene.bodies[0].position += separation * Vector3<double>(0, std::cos(turn), std::sin(turn));
    const Vector3<double> before = momentum(GameWorld(scene, solver_named("direct")).bodies());
    // They have met when they are past each other, had they not.
    const double approach = (scene.bodies[0].velocity - scene.bodies[1].velocity).norm();
    const GameWorld end = after(scene, 3 + static_cast<int>(60 * (3 + bounding_radius) / approach));
    CAPTURE(i);
    // They touch, so they part otherwise than they would have.
    REQUIRE(end.bodies()[0].motion.velocity != scene.bodies[0].velocity);
    REQUIRE((momentum(end.bodies()) - before).norm() <= 1e-12 * momentum_of_each(scene));
    const Vector3<double> way = end.bodies()[1].motion.center - end.bodies()[0].motion.center;
    const Vector3<double> separating =
        end.bodies()[1].motion.velocity - end.bodies()[0].motion.velocity;
    REQUIRE(way.norm() >= bounding_radius * (1 - 1e-9));
    REQUIRE(way.dot(separating) >= -1e-9 * way.norm() * separating.norm());
  }
}

TEST_CASE("two balls that do not bounce go on together, and stop together at a wall in that step")
{
  for (const double separation : {0.05, 0.2, 5.0}) // [m], to the wall
  {
    Scene scene{.bodies = {box_body("wall", {0.01, 1, 1}, {0.11 + separation, 0, 0}, 0)}};
    scene.gravity.setZero();
    scene.bodies.push_back(ball_body("first", 0.1, {-0.3, 0, 0}));
    scene.bodies.push_back(ball_body("second", 0.1, {0, 0, 0}));
    scene.bodies[1].velocity.x() = 100;
    GameWorld world(scene, solver_named("direct"));
    world.step();
    CAPTURE(separation);
    const Motion<double>&first = world.bodies()[1].motion, second = world.bodies()[2].motion;
    const bool at_wall = separation < 1;
    // They touch after a millisecond, at 100 m/s, and go on at 50.
    const double place = at_wall ? separation : 50 * (scene.step - 0.001);
    CHECK(second.center.x() == Catch::Approx(place).margin(1e-6));
    CHECK(first.center.x() == Catch::Approx(place - 0.2).margin(1e-6));
    CHECK(second.velocity.x() == Catch::Approx(at_wall ? 0 : 50).margin(1e-6));
    CHECK(first.velocity.x() == Catch::Approx(at_wall ? 0 : 50).margin(1e-6));
  }
}

// [resume_falling]
TEST_CASE("60 swarms of 20 balls that touch in flight fall as one body does", "[R3]")
{
  for (int seed = 0; seed < inputs(60, 5); ++seed)
  {
    BoxDraw draw(static_cast<std::uint32_t>(seed));
    Scene scene;
    const double radius = evenly(draw, 0.002, 2);
    Vector3<double> place(0, 0, 0);
    for (int i = 0; i < 20; ++i)
    {
      SceneBody sphere = ball_body(numbered("ball", i), radius, place);
      sphere.velocity = draw.whole(2) * draw.between(0, 20) * radius * draw.direction();
      sphere.angular_velocity = 10 * draw.vector(-1, 1);
      sphere.restitution = draw.whole(2) * 0.5;
      scene.bodies.push_back(sphere);
      // In a row that touches, as in a falling chain, or heaped together.
      place += 2 * radius * (seed % 2 == 0 ? Vector3<double>(1, 0, 0) : draw.direction());
    }
    GameWorld world(scene, solver_named(seed % 3 == 0 ? "direct" : "soft_steps"));
    const Vector3<double> before = momentum(world.bodies());
    for (int step = 1; step <= 120; ++step)
    {
      world.step();
      const Vector3<double> expected = before + 20 * world.time() * scene.gravity;
      CAPTURE(seed, step);
      REQUIRE((momentum(world.bodies()) - expected).norm() <= 1e-9 * expected.norm());
    }
  }
}

TEST_CASE("100 balls let go in a pit are at its bottom after 4 s, none in mid-air", "[long]")
{
  Scene scene;
  scene.bodies.push_back(ground());
  for (const double side : {-1.0, 1.0})
  {
    scene.bodies.push_back(
        box_body(side < 0 ? "left" : "right", {0.1, 4, 4}, {1.6 * side, 4, 0}, 0));
    scene.bodies.push_back(
        box_body(side < 0 ? "back" : "front", {4, 4, 0.1}, {0, 4, 1.6 * side}, 0));
  }
  BoxDraw draw(5);
  for (int i = 0; i < 100; ++i)
  {
    const Vector3<double> place(0.55 * (i % 5 - 2), 0.3 + 0.6 * (i / 25), 0.55 * (i / 5 % 5 - 2));
    SceneBody sphere = ball_body(numbered("ball", i), 0.25, place + draw.vector(0, 0.01));
    sphere.restitution = 0.3;
    scene.bodies.push_back(sphere);
  }
  const GameWorld world = after(scene, 240);
  for (std::size_t i = 5; i < scene.bodies.size(); ++i)
  {
    const RigidBody& sphere = world.bodies()[i];
    CAPTURE(i, sphere.motion.center.transpose(), sphere.motion.velocity.transpose());
    // A slow body is carried: by the ground, or by a body below.
    const bool warm_start_impulse =
        sphere.motion.center.y() < 0.26 ||
        std::any_of(
            world.contacts().begin(), world.contacts().end(),
            [&](const WorldContact& contact)
            {
              const double up = contact.normal.y() * (static_cast<std::size_t>(contact.b) == i);
              const double down = -contact.normal.y() * (static_cast<std::size_t>(contact.a) == i);
              return up + down > 0.01;
            });
    CHECK((warm_start_impulse || sphere.motion.velocity.norm() > 0.1));
  }
}
// [resume_falling]

// [friction_of_bounces]
TEST_CASE("10,000 thrown balls bounce as friction's closed form says, slipping or not", "[R2][R6]")
{
  BoxDraw draw(6);
  int slipped = 0;
  for (int i = 0; i < tries; ++i)
  {
    const double radius = evenly(draw, 0.002, 2), down = evenly(draw, 2, 300);
    const double along = draw.between(-1, 1) * down, spin = draw.between(-1, 1) * down / radius;
    const double restitution = draw.between(0, 1), friction = draw.between(0, 1);
    Scene scene;
    scene.gravity.setZero();
    scene.bodies = {ground(), ball_body("ball", radius, {0, radius + down / 60 / 3, 0})};
    scene.bodies[0].friction = scene.bodies[1].friction = friction;
    scene.bodies[1].restitution = restitution;
    scene.bodies[1].velocity = {along, -down, 0};
    scene.bodies[1].angular_velocity = {0, 0, spin};
    const RigidBody end = after(scene, 1).bodies()[1];
    // The lowest point slides at v + ω r; 2/7 of that stops it, and the cone allows μ (1 + e) v_n.
    const double sliding = along + spin * radius, most = friction * (1 + restitution) * down;
    const double change = std::clamp(2.0 / 7 * sliding, -most, most);
    slipped += std::abs(change) == most ? 1 : 0;
    CAPTURE(i, radius, down, along, spin, restitution, friction);
    REQUIRE(end.motion.velocity.y() == Catch::Approx(restitution * down).epsilon(1e-9));
    REQUIRE(end.motion.velocity.x() == Catch::Approx(along - change).margin(1e-9 * down));
    REQUIRE(
        end.motion.angular_velocity.z() * radius ==
        Catch::Approx(spin * radius - 2.5 * change).margin(1e-9 * down));
  }
  CHECK(slipped > tries / 20);
  CHECK(slipped < tries * 9 / 10);
}

TEST_CASE("50 balls without friction hop over a floor for 10 s and keep their speed along it")
{
  BoxDraw draw(7);
  for (int i = 0; i < inputs(50, 8); ++i)
  {
    Scene scene;
    scene.bodies = {ground(), ball_body("ball", evenly(draw, 0.01, 1), {0, 3, 0})};
    scene.bodies[0].friction = 0;
    scene.bodies[1].restitution = draw.whole(2) == 0 ? 1 : draw.between(0, 1);
    scene.bodies[1].velocity = evenly(draw, 0.1, 100) * draw.direction();
    const Vector3<double> before = scene.bodies[1].velocity;
    GameWorld world(scene, solver_named("direct"));
    const double most = energy(world.bodies(), scene.gravity);
    for (int step = 0; step < 600; ++step)
    {
      world.step();
      const Vector3<double> now = world.bodies()[1].motion.velocity;
      CAPTURE(i, step);
      REQUIRE(std::hypot(now.x() - before.x(), now.z() - before.z()) <= 1e-12 * before.norm());
      REQUIRE(energy(world.bodies(), scene.gravity) <= most * (1 + 1e-12));
    }
  }
}
// [friction_of_bounces]

TEST_CASE("60,000 balls that pass an edge by up to a radius keep their velocity to the last bit")
{
  BoxDraw draw(8);
  for (int i = 0; i < inputs(60'000, 50); ++i)
  {
    const double radius = evenly(draw, 0.002, 0.2), speed = evenly(draw, 1, 1000);
    Scene scene;
    scene.gravity.setZero();
    scene.bodies = {box_body("wall", {0.01, 1, 1}, {0, 0, 0}, 0)};
    const double beside = 1 + radius * (1 + evenly(draw, 1e-6, 1));
    scene.bodies.push_back(ball_body("ball", radius, {draw.between(-2, -1), beside, 0}));
    scene.bodies[1].velocity = {speed, 0, 0};
    const RigidBody end = after(scene, 2 + static_cast<int>(60 * 4 / speed)).bodies()[1];
    CAPTURE(i, radius, speed);
    REQUIRE(end.motion.velocity == scene.bodies[1].velocity);
  }
}

TEST_CASE("two balls that fall bounce at 0.5 m/s: gravity does not press them on each other")
{
  for (const bool upper_first : {true, false})
  {
    Scene scene{
        .bodies = {ball_body("upper", 0.5, {0, 11.0075, 0}), ball_body("lower", 0.5, {0, 10, 0})}};
    scene.bodies[0].velocity.y() = -0.5;
    scene.bodies[0].restitution = scene.bodies[1].restitution = 1;
    if (!upper_first)
    {
      std::swap(scene.bodies[0], scene.bodies[1]);
    }
    const GameWorld world = after(scene, 1);
    const double separation =
        world.bodies()[0].motion.velocity.y() - world.bodies()[1].motion.velocity.y();
    CHECK(separation == Catch::Approx(upper_first ? 0.5 : -0.5).epsilon(1e-9));
  }
}

// [over_constrained]
/// Up to six bodies in a row before a wall, and behind them a ram, which comes at 1 to 1,000 m/s.
struct Press
{
  Scene scene;
  double half = 0; ///< [m], the half thickness of the wall; 0 for a plane

  /// How far [m] a body's centre is before the wall.
  double before(const GameWorld& world, std::size_t body) const
  {
    return seen_from(world, 0, body).x() - half;
  }
};

/// A plane, or a wall of 1 mm to 5 cm that nothing gets round, fixed or of 10 t.
void add_wall(BoxDraw& draw, Press& press)
{
  const int kind = draw.whole(3);
  if (kind == 0)
  {
    press.scene.bodies.push_back({.name = "plane", .shape = PlaneShape{{1, 0, 0}, 0}});
    return;
  }
  press.half = evenly(draw, 0.0005, 0.025);
  const double mass = kind == 1 ? 0 : 1e4;
  press.scene.bodies.push_back(
      box_body("wall", {press.half, 1000, 1000}, {-press.half, 0, 0}, mass));
}

/// Balls of 2 to 20 cm and 100 g to 1 kg before it; the ram has 100 g to 100 kg.
Press press_of_balls(BoxDraw& draw)
{
  Press press;
  press.scene.gravity = {0, 0, draw.whole(3) == 0 ? -9.81 : 0};
  add_wall(draw, press);
  double end = 0;
  for (int left = 1 + draw.whole(6); left > 0; --left)
  {
    const double radius = evenly(draw, 0.01, 0.1), separation = evenly(draw, 1e-4, 0.05);
    const double y = draw.between(-0.3, 0.3) * radius, z = draw.between(-0.3, 0.3) * radius;
    const Vector3<double> place(end + separation + radius, y, z);
    press.scene.bodies.push_back(ball_body("ball", radius, place, evenly(draw, 0.1, 1)));
    end = place.x() + radius;
  }
  end += evenly(draw, 1e-3, 1);
  SceneBody ram = draw.whole(2) == 0 ? ball_body("ram", 0.3, {end + 0.3, 0, 0})
                                     : box_body("ram", {0.25, 1, 1}, {end + 0.25, 0, 0});
  ram.mass = evenly(draw, 0.1, 100);
  ram.velocity = {-evenly(draw, 1, 1000), 0, 0};
  press.scene.bodies.push_back(ram);
  const double restitution = draw.whole(3) == 0 ? 0 : draw.between(0, 1);
  const double friction = draw.between(0, 1);
  for (SceneBody& body : press.scene.bodies)
  {
    body.restitution = restitution;
    body.friction = friction;
  }
  return press;
}

/// Whether a body's centre is in the ram, if that is a box.
bool is_in_ram(const GameWorld& world, std::size_t body)
{
  const auto* const box = std::get_if<BoxShape>(&world.scene().bodies.back().shape);
  const Vector3<double> place = seen_from(world, world.bodies().size() - 1, body);
  return box && (place.cwiseAbs().array() < box->half_extents.array()).all();
}

TEST_CASE("balls that a ram crushes pass neither wall nor plane in a second, and gain no energy; "
          "one in 100 before a box gets into that")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    BoxDraw draw(43);
    std::size_t before_boxes = 0, caught = 0;
    for (int i = 0; i < inputs(400, 6); ++i)
    {
      const Press press = press_of_balls(draw);
      GameWorld world(press.scene, solver_named(solver));
      const std::size_t spheres = world.bodies().size() - 2;
      const double at_first = energy(world.bodies(), press.scene.gravity);
      double nearest = 1, most = at_first;
      std::vector<bool> in_ram(spheres + 1, false);
      while (world.time() < 1)
      {
        world.step();
        for (std::size_t sphere = 1; sphere <= spheres; ++sphere)
        {
          nearest = std::min(nearest, press.before(world, sphere));
          in_ram[sphere] = in_ram[sphere] || is_in_ram(world, sphere);
        }
        most = std::max(most, energy(world.bodies(), press.scene.gravity));
      }
      CAPTURE(solver, i, spheres);
      REQUIRE(nearest > 0);
      REQUIRE(most - at_first <= 1e-6 * std::abs(at_first));
      before_boxes += world.bodies().back().is_sphere ? 0 : spheres;
      caught += static_cast<std::size_t>(std::count(in_ram.begin(), in_ram.end(), true));
    }
    CAPTURE(solver, before_boxes, caught);
    CHECK(100 * caught <= before_boxes);
  }
}
// [over_constrained]

TEST_CASE("a fast ball wakes the tower that it hits")
{
  Scene scene;
  scene.bodies = {ground()};
  for (int i = 0; i < 3; ++i)
  {
    scene.bodies.push_back(cube_body(numbered("cube", i), {0, i + 0.5, 0}));
  }
  scene.bodies.push_back(ball_body("ball", 0.05, {-200, 2.5, 0}));
  scene.bodies.back().velocity = {150, 0, 0};
  scene.gravity.setZero();
  GameWorld world(scene, solver_named("direct"), true);
  for (int i = 0; i < 70; ++i)
  {
    world.step();
  }
  CHECK(world.is_asleep(3));
  for (int i = 0; i < 20; ++i)
  {
    world.step();
  }
  CHECK_FALSE(world.is_asleep(3));
  CHECK(world.bodies()[3].motion.velocity.x() > 1);
}
