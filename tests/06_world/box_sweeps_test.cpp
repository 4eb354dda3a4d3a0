/// \file
/// Fast boxes on their way through a step: nothing is passed, near misses are left alone, a bounce
/// has all its points and its friction.

#include "05_resolution/tunnelling/swept_box.hpp"
#include "06_world/contacts/near_shapes.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/trial/world_measures.hpp"
#include "06_world/game_world/world_inputs.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"

#include "tests/06_world/evenly.hpp"
#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace cookbook;

namespace
{

/// A spin of 1 to 100 rad/s about any axis.
Vector3<double> spin_of(BoxDraw& draw)
{
  const double rate = evenly(draw, 1, 100);
  return rate * draw.direction();
}

/// What a wall does when something comes.
enum class Wall
{
  fixed,  ///< nothing moves it
  stands, ///< 5 to 100 kg, on the ground
  floats, ///< 5 to 100 kg, in the air
  comes   ///< flies towards what comes at 1 to 100 m/s
};

/// How a box comes.
enum class Flight
{
  straight, ///< turned anyhow, and not turning
  spins,    ///< turned anyhow, at up to 100 rad/s
  slides    ///< on the ground, upright
};

/// A box of 2 to 20 cm at 1 to 1,000 m/s at a wall of 1 to 5 cm, square or aslant to it.
struct Shot
{
  Scene scene;
  int steps; ///< after which the box would be far behind the wall
};

Shot shot(BoxDraw& draw, Flight flight, Wall kind)
{
  const Vector3<double> half{
      evenly(draw, 0.01, 0.1), evenly(draw, 0.01, 0.1), evenly(draw, 0.01, 0.1)};
  const double speed = evenly(draw, 1, 1000), thin = evenly(draw, 0.005, 0.025);
  const double aslant = draw.between(-0.7, 0.7), size = 3 + speed / 10;
  const double start = draw.between(0.01, 2) + half.norm() + thin;
  const bool slides = flight == Flight::slides;
  Scene scene;
  if (!slides || kind == Wall::comes)
  {
    scene.gravity.setZero();
  }
  SceneBody below =
      draw.whole(2) == 0 ? ground() : box_body("ground", {200, 1, 200}, {0, -1, 0}, 0);
  if (!slides && kind != Wall::stands)
  {
    below = box_body("far", {1, 1, 1}, {0, -1000, 0}, 0);
  }
  scene.bodies.push_back(below);
  SceneBody wall = box_body("wall", {thin, size, 2 * size}, {0, size, 0}, 0);
  if (kind == Wall::stands || kind == Wall::floats)
  {
    wall.mass = evenly(draw, 5, 100);
  }
  if (kind == Wall::comes)
  {
    wall.mass = 1e6;
    wall.velocity = {-evenly(draw, 1, 100), 0, 0};
  }
  wall.position.y() += kind == Wall::stands || kind == Wall::fixed ? 0 : 0.005; // not beneath it
  scene.bodies.push_back(wall);
  SceneBody box = box_body("box", half, {-start, slides ? half.y() : size, 0});
  box.velocity = speed * Vector3<double>(1, 0, aslant).normalized();
  box.restitution = draw.whole(2) == 0 ? 0 : draw.between(0, 1);
  box.friction = draw.between(0, 1);
  if (!slides)
  {
    box.orientation = Quaternion<double>(draw.rotation());
  }
  if (flight == Flight::spins)
  {
    box.angular_velocity = spin_of(draw);
  }
  scene.bodies.push_back(box);
  return {scene, 2 + static_cast<int>(60 * 3 * start / speed)};
}

/// Where a body is as seen from another.
Vector3<double> seen_from(const GameWorld& world, std::size_t from, std::size_t body)
{
  const RigidBody &wall = world.bodies()[from], &box = world.bodies()[body];
  return wall.axes.transpose() * (box.motion.center - wall.motion.center);
}

/// Whether a body goes through a wall that is thin along its x, and not round it, in some steps;
/// and that the energy never grows.
bool goes_through(const Scene& scene, int steps, const std::string& solver, std::size_t wall = 1)
{
  GameWorld world(scene, solver_named(solver));
  const Vector3<double> half = std::get<BoxShape>(scene.bodies[wall].shape).half_extents;
  const double most = energy(world.bodies(), scene.gravity);
  for (int i = 0; i < steps; ++i)
  {
    std::vector<Vector3<double>> before;
    for (std::size_t body = 0; body < scene.bodies.size(); ++body)
    {
      before.push_back(seen_from(world, wall, body));
    }
    world.step();
    REQUIRE(energy(world.bodies(), scene.gravity) <= most + 1e-6 * std::abs(most) + 1e-9);
    for (std::size_t body = wall + 1; body < scene.bodies.size(); ++body)
    {
      const Vector3<double> was = before[body], now = seen_from(world, wall, body);
      if (was.x() < 0 && now.x() >= 0)
      {
        const Vector3<double> cut = was + (now - was) * (was.x() / (was.x() - now.x()));
        if (std::abs(cut.y()) < half.y() && std::abs(cut.z()) < half.z())
        {
          return true;
        }
      }
    }
  }
  return false;
}

void nothing_passes(int tries)
{
  using Names = std::vector<std::string>;
  for (const std::string& solver :
       inputs(Names{"direct", "soft_steps", "wide_steps"}, Names{"wide_steps"}))
  {
    for (const Flight flight : {Flight::straight, Flight::spins, Flight::slides})
    {
      for (const Wall kind : {Wall::fixed, Wall::stands, Wall::floats, Wall::comes})
      {
        BoxDraw draw(1);
        for (int i = 0; i < tries / 36; ++i)
        {
          const Shot one = shot(draw, flight, kind);
          CAPTURE(solver, static_cast<int>(flight), static_cast<int>(kind), i);
          CHECK_FALSE(goes_through(one.scene, one.steps, solver));
        }
      }
    }
  }
}

// [corner]
/// A box thrown at the corner that three planes make.
Scene thrown_into_corner(BoxDraw& draw, const Vector3<double>& half)
{
  Scene scene;
  for (const int axis : {0, 1, 2})
  {
    SceneBody plane = ground();
    plane.name = numbered("plane", axis);
    plane.shape = PlaneShape{Vector3<double>::Unit(axis), 0};
    scene.bodies.push_back(plane);
  }
  SceneBody box = box_body("box", half, draw.vector(0.5, 1));
  box.velocity = -evenly(draw, 1, 1000) * box.position.normalized();
  box.orientation = Quaternion<double>(draw.rotation());
  box.angular_velocity = spin_of(draw);
  box.restitution = draw.whole(2) * draw.between(0, 1);
  scene.bodies.push_back(box);
  return scene;
}

/// It stays in front of the planes for a second and a half, and gains no energy.
void check_in_corner(const Scene& scene, const std::string& solver, int number)
{
  GameWorld world(scene, solver_named(solver));
  const double most = energy(world.bodies(), scene.gravity);
  for (int step = 0; step < 90; ++step)
  {
    world.step();
    CAPTURE(number, solver, step);
    REQUIRE(is_finite(world.bodies()[3]));
    REQUIRE(world.bodies()[3].motion.center.minCoeff() > 0);
    REQUIRE(energy(world.bodies(), scene.gravity) <= most * (1 + 1e-3));
  }
}
// [corner]

} // namespace

TEST_CASE(
    "720 boxes of 2 to 20 cm at 1 to 1,000 m/s, spinning or sliding, pass no wall of 1 to 5 cm",
    "[case:J1]")
{
  nothing_passes(inputs(720, 36));
}

TEST_CASE("nor do 36,000", "[long]")
{
  nothing_passes(36'000);
}

namespace
{

/// Pairs of boxes fly at each other, for so many steps at most after they have met.
void boxes_meet(int tries, int steps_after)
{
  BoxDraw draw(3);
  for (int i = 0; i < tries; ++i)
  {
    Scene scene;
    scene.gravity.setZero();
    double thin = 1;
    const bool cubes = i % 2 == 0;
    for (const double side : {-1.0, 1.0})
    {
      const double edge = evenly(draw, 0.01, 0.1);
      const Vector3<double> half{
          edge, cubes ? edge : evenly(draw, 0.01, 0.1), cubes ? edge : evenly(draw, 0.01, 0.1)};
      thin = std::min(thin, half.minCoeff());
      SceneBody box = box_body(side < 0 ? "left" : "right", half, {side * 1.5, 0, 0});
      box.mass = evenly(draw, 0.01, 100);
      box.velocity = {-side * evenly(draw, 10, 1000), 0, 0};
      box.orientation = Quaternion<double>(draw.rotation());
      box.angular_velocity = spin_of(draw);
      box.restitution = draw.between(0, 1);
      scene.bodies.push_back(box);
    }
    // Balls inside the boxes meet, so the boxes do.
    const double turn = draw.between(0, 6.3);
    scene.bodies[0].position +=
        draw.between(0, 1.9) * thin * Vector3<double>(0, std::cos(turn), std::sin(turn));
    GameWorld world(scene, solver_named("direct"));
    const Vector3<double> before = momentum(world.bodies());
    const double most = energy(world.bodies(), scene.gravity);
    const int until_met =
        static_cast<int>(60 * 3 / (scene.bodies[0].velocity - scene.bodies[1].velocity).norm()) + 1;
    for (int step = 0; step < until_met + steps_after; ++step)
    {
      world.step();
      const auto box = [&](std::size_t of)
      {
        const auto& shape = std::get<BoxShape>(scene.bodies[of].shape);
        return placed(world.bodies()[of], shape);
      };
      CAPTURE(i, step);
      CHECK(box_gap(box(0), box(1)).length >= -0.3 * thin);
      // A free box of unlike edges gains and loses energy by itself at 50 radians a step.
      CHECK((!cubes || energy(world.bodies(), scene.gravity) <= most * (1 + 1e-6)));
    }
    CAPTURE(i);
    CHECK(world.bodies()[0].motion.velocity != scene.bodies[0].velocity);
    CHECK((momentum(world.bodies()) - before).norm() <= 1e-12 * momentum_of_each(scene));
  }
}

} // namespace

TEST_CASE("200 pairs of boxes that fly at each other meet, and keep their momentum", "[case:J1]")
{
  boxes_meet(inputs(200, 10), inputs(200, 50));
}

TEST_CASE("so do 20,000", "[long]")
{
  boxes_meet(20'000, 3);
}

TEST_CASE("500 pairs of boxes that meet face to face do not swap sides")
{
  BoxDraw draw(4);
  for (int i = 0; i < inputs(500, 20); ++i)
  {
    Scene scene;
    scene.gravity.setZero();
    for (const double side : {-1.0, 1.0})
    {
      const Vector3<double> half{
          evenly(draw, 0.01, 0.1), evenly(draw, 0.05, 0.1), evenly(draw, 0.05, 0.1)};
      SceneBody box = box_body(side < 0 ? "left" : "right", half, {side * 1.5, 0, 0});
      box.mass = evenly(draw, 0.01, 100);
      box.velocity = {-side * evenly(draw, 10, 1000), 0, 0};
      box.angular_velocity = {draw.between(-100, 100), 0, 0};
      box.restitution = draw.between(0, 1);
      scene.bodies.push_back(box);
    }
    GameWorld world(scene, solver_named("direct"));
    for (int step = 0; step < 30; ++step)
    {
      world.step();
      CAPTURE(i, step);
      REQUIRE(world.bodies()[0].motion.center.x() < world.bodies()[1].motion.center.x());
    }
  }
}

TEST_CASE("40,000 boxes, spinning or not, pass an edge by 1 µm to 1 cm as if nothing were there")
{
  BoxDraw draw(5);
  for (int i = 0; i < inputs(40'000, 20); ++i)
  {
    const Vector3<double> half{
        evenly(draw, 0.01, 0.1), evenly(draw, 0.01, 0.1), evenly(draw, 0.01, 0.1)};
    const double speed = evenly(draw, 1, 1000);
    const bool spins = draw.whole(2) == 0;
    Scene scene;
    scene.gravity.setZero();
    // A box that spins about z reaches as far up as its diagonal in the plane.
    const double up = spins ? std::hypot(half.x(), half.y()) : half.y();
    const double beside = 1 + up + evenly(draw, 1e-6, 1e-2);
    scene.bodies = {box_body("box", half, {draw.between(-2, -1), beside, 0})};
    scene.bodies[0].velocity = {speed, 0, 0};
    scene.bodies[0].angular_velocity = {0, 0, spins ? draw.between(-100, 100) : 0};
    Scene with_wall = scene;
    with_wall.bodies.push_back(box_body("wall", {0.01, 1, 1}, {0, 0, 0}, 0));
    GameWorld world(with_wall, solver_named("direct")), alone(scene, solver_named("direct"));
    for (int step = 0; step < 2 + static_cast<int>(60 * 4 / speed); ++step)
    {
      world.step();
      alone.step();
    }
    const RigidBody &box = world.bodies()[0], &other = alone.bodies()[0];
    CAPTURE(i, speed, spins);
    REQUIRE(box.motion.velocity == other.motion.velocity);
    REQUIRE(box.motion.angular_velocity == other.motion.angular_velocity);
    REQUIRE(box.motion.center == other.motion.center);
    REQUIRE(box.orientation.coeffs() == other.orientation.coeffs());
  }
}

// Four points that push on one another are right to 1e-3 after the 200 rounds of a bounce.
TEST_CASE(
    "1,000 boxes thrown flat on a floor bounce as friction's closed form says, unturned",
    "[R2][R6]")
{
  BoxDraw draw(6);
  for (int i = 0; i < inputs(1000, 20); ++i)
  {
    const Vector3<double> half{
        evenly(draw, 0.01, 0.1), evenly(draw, 0.01, 0.1), evenly(draw, 0.01, 0.1)};
    const double down = evenly(draw, 20, 1000), restitution = draw.between(0, 1);
    // So little friction that it does not tip the box over its leading edge.
    const double friction =
        draw.between(0, 0.5) * std::min({1.0, half.x() / half.y(), half.z() / half.y()}) / 1.5;
    const Vector3<double> along(draw.between(-1, 1) * down, 0, draw.between(-1, 1) * down);
    Scene scene;
    scene.gravity.setZero();
    scene.bodies = {
        draw.whole(2) == 0 ? ground() : box_body("ground", {100, 1, 100}, {0, -1, 0}, 0),
        box_body("box", half, {0, half.y() + down / 60 / 3, 0})};
    scene.bodies[0].friction = scene.bodies[1].friction = friction;
    scene.bodies[1].restitution = restitution;
    scene.bodies[1].velocity = along - Vector3<double>(0, down, 0);
    GameWorld world(scene, solver_named("direct"));
    world.step();
    const Motion<double>& motion = world.bodies()[1].motion;
    const double most = friction * (1 + restitution) * down, slides = along.norm();
    const Vector3<double> left = along * (slides <= most ? 0 : 1 - most / slides);
    CAPTURE(i, half.transpose(), down, restitution, friction, along.transpose());
    CHECK(motion.velocity.y() == Catch::Approx(restitution * down).margin(1e-3 * down));
    CHECK(motion.velocity.x() == Catch::Approx(left.x()).margin(1e-3 * down));
    CHECK(motion.velocity.z() == Catch::Approx(left.z()).margin(1e-3 * down));
    CHECK(motion.angular_velocity.norm() * half.norm() <= 1e-3 * down);
  }
}

TEST_CASE("a box and a ball that a force pulls meet a wall as fast as they are there")
{
  const double speed = 60, pull = 600, separation = 0.5, step = 1.0 / 60;
  const double there = std::sqrt(speed * speed + 2 * pull * separation),
               time = (there - speed) / pull;
  const double after = -there + pull * (step - time);
  for (SceneBody body : {cube_body("cube", {0, 0, 0}), ball_body("ball", 0.5, {0, 0, 0})})
  {
    body.velocity.x() = speed;
    body.restitution = 1;
    body.friction = 0;
    body.mass = 1;
    Scene scene{.bodies = {body, box_body("wall", {1, 9, 9}, {1.5 + separation, 0, 0}, 0)}};
    scene.gravity.setZero();
    for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
    {
      GameWorld world(scene, solver_named(solver));
      apply_force(world, 0, {pull, 0, 0});
      apply_torque(world, 0, {3, 0, 0});
      world.step();
      const Motion<double>& motion = world.bodies()[0].motion;
      CAPTURE(body.name, solver);
      CHECK(motion.velocity.x() == Catch::Approx(after).epsilon(1e-6));
      const double way = separation + (step - time) * (after - there) / 2;
      CHECK(motion.center.x() == Catch::Approx(way).margin(1e-6));
      const double gained = step * 3 / world.bodies()[0].moments.x();
      CHECK(motion.angular_velocity.x() == Catch::Approx(gained).epsilon(1e-6));
    }
  }
}

TEST_CASE("a box at rest before a thin wall does not pass it when it is struck, and only then fast")
{
  SceneBody heavy = box_body("heavy", {0.1, 0.1, 0.1}, {-0.5, 0, 0}, 10);
  heavy.velocity.x() = 300;
  Scene scene{
      .bodies = {
          box_body("light", {0.05, 0.05, 0.05}, {0, 0, 0}, 0.1),
          box_body("wall", {0.005, 9, 9}, {0.075, 0, 0}, 0), heavy}};
  scene.gravity.setZero();
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    GameWorld world(scene, solver_named(solver));
    for (int i = 0; i < 10; ++i)
    {
      world.step();
      CAPTURE(solver, i);
      CHECK(world.bodies()[0].motion.center.x() < 0.075);
    }
  }
}

TEST_CASE(
    "a beam at rest that a ball at 40 m/s strikes near its end moves and spins as J and r say")
{
  Scene scene{.bodies = {ground(), box_body("beam", {1, 0.1, 0.1}, {0, 0.1, 0}, 5)}};
  SceneBody sphere = ball_body("ball", 0.05, {0.8, 0.1, -0.3});
  sphere.velocity.z() = 40;
  sphere.mass = 1;
  for (SceneBody* const body : {&scene.bodies[0], &scene.bodies[1], &sphere})
  {
    body->friction = 0;
    body->restitution = 1;
  }
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    GameWorld world(scene, solver_named(solver));
    while (world.time() < 0.5)
    {
      world.step();
    }
    const std::size_t struck_by = world.add(sphere);
    world.step();
    const double inertia = 5 * (1 + 0.01) / 3;
    const double impulse = 2 * 40 / (1.0 + 1.0 / 5 + 0.8 * 0.8 / inertia);
    const Motion<double>& beam = world.bodies()[1].motion;
    CAPTURE(solver);
    CHECK(beam.velocity.z() == Catch::Approx(impulse / 5).epsilon(1e-3));
    CHECK(beam.angular_velocity.y() == Catch::Approx(-0.8 * impulse / inertia).epsilon(1e-3));
    CHECK(
        world.bodies()[struck_by].motion.velocity.z() == Catch::Approx(40 - impulse).epsilon(1e-3));
  }
}

TEST_CASE("300 boxes of 1 mm to 20 cm thrown into a corner of three planes stay in front of each")
{
  BoxDraw draw(7);
  for (int i = 0; i < inputs(300, 10); ++i)
  {
    const Vector3<double> half{
        evenly(draw, 0.0005, 0.1), evenly(draw, 0.0005, 0.1), evenly(draw, 0.0005, 0.1)};
    check_in_corner(thrown_into_corner(draw, half), i % 2 == 0 ? "direct" : "soft_steps", i);
  }
}

// [needles]
TEST_CASE("300 needles, 30 to 160 times as long as thick, gain no energy in that corner")
{
  BoxDraw draw(8);
  for (int i = 0; i < inputs(300, 10); ++i)
  {
    Vector3<double> half{
        evenly(draw, 0.0005, 0.0015), evenly(draw, 0.0005, 0.0015), evenly(draw, 0.05, 0.08)};
    std::swap(half.z(), half[i % 3]);
    const Scene scene = thrown_into_corner(draw, half);
    for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
    {
      check_in_corner(scene, solver, i);
    }
  }
}
// [needles]

TEST_CASE("100 boxes that lean on a wall are hit from behind at 1 to 1,000 m/s, and none passes it")
{
  BoxDraw draw(8);
  for (int i = 0; i < inputs(100, 5); ++i)
  {
    Scene scene;
    scene.bodies = {ground(), box_body("wall", {evenly(draw, 0.005, 0.025), 5, 10}, {0, 5, 0}, 0)};
    const double thin = std::get<BoxShape>(scene.bodies[1].shape).half_extents.x();
    // Its foot stands away from the wall: 3, 4, 5.
    SceneBody leaning = box_body("leaning", {0.02, 0.5, 0.1}, {0, 0, 0});
    leaning.orientation = turn_about_z(-0.6, 0.8);
    leaning.position = {-thin - 0.02 * 0.8 - 0.5 * 0.6, 0.5 * 0.8 + 0.02 * 0.6, 0};
    scene.bodies.push_back(leaning);
    const Vector3<double> half{
        evenly(draw, 0.01, 0.1), evenly(draw, 0.01, 0.1), evenly(draw, 0.01, 0.1)};
    const double start = draw.between(1, 3);
    scene.bodies.push_back(
        draw.whole(2) == 0 ? box_body("hits", half, {-start, draw.between(0.2, 0.7), 0})
                           : ball_body("hits", half.x(), {-start, draw.between(0.2, 0.7), 0}));
    scene.bodies.back().velocity = {evenly(draw, 1, 1000), 0, 0};
    scene.bodies.back().mass = evenly(draw, 0.1, 10);
    CAPTURE(i);
    CHECK_FALSE(goes_through(scene, 60, i % 2 == 0 ? "direct" : "soft_steps"));
  }
}

TEST_CASE("500 plates of 1 to 5 mm at 1 to 1,000 m/s pass no wall of 1 to 5 mm, near or far")
{
  BoxDraw draw(9);
  for (int i = 0; i < inputs(500, 10); ++i)
  {
    const Vector3<double> away = (i % 3 == 0 ? 0.0 : i % 3 == 1 ? 1e3 : 1e6) * draw.direction();
    const Vector3<double> half{evenly(draw, 0.0005, 0.0025), draw.between(0.05, 0.1), 0.1};
    Scene scene;
    scene.gravity.setZero();
    scene.bodies = {
        box_body("far", {1, 1, 1}, away - Vector3<double>(0, 1e4, 0), 0),
        box_body("wall", {evenly(draw, 0.0005, 0.0025), 50, 50}, away, 0),
        box_body("plate", half, away - Vector3<double>(draw.between(1, 3), 0, 0))};
    scene.bodies[2].velocity = {evenly(draw, 1, 1000), draw.between(-1, 1), 0};
    scene.bodies[2].orientation = Quaternion<double>(draw.rotation());
    scene.bodies[2].angular_velocity = spin_of(draw);
    scene.bodies[2].restitution = draw.whole(2) * 0.5;
    CAPTURE(i);
    CHECK_FALSE(goes_through(scene, 240, "direct"));
  }
}

TEST_CASE("200 times two boxes and a ball meet at once before a wall, and none passes it")
{
  BoxDraw draw(10);
  for (int i = 0; i < inputs(200, 10); ++i)
  {
    Scene scene;
    scene.gravity.setZero();
    scene.bodies = {
        box_body("far", {1, 1, 1}, {0, -1e4, 0}, 0),
        box_body("wall", {0.01, 50, 50}, {0, 0, 0}, 0)};
    const double speed = evenly(draw, 1, 1000);
    for (int k = 0; k < 3; ++k)
    {
      const Vector3<double> half{
          evenly(draw, 0.01, 0.1), evenly(draw, 0.01, 0.1), evenly(draw, 0.01, 0.1)};
      // On different ways to the same place before the wall, there at the same time.
      const Vector3<double> from = Vector3<double>(-1, 0.7 * (k - 1), draw.between(-0.2, 0.2));
      SceneBody body =
          k == 1 ? ball_body("ball", half.x(), from) : box_body(numbered("box", k), half, from);
      body.velocity = -speed * from;
      body.mass = evenly(draw, 0.1, 10);
      body.restitution = draw.whole(2) * 0.5;
      body.angular_velocity = spin_of(draw);
      scene.bodies.push_back(body);
    }
    CAPTURE(i);
    CHECK_FALSE(goes_through(scene, 2 + static_cast<int>(600 / speed), "direct"));
  }
}

TEST_CASE("100 stacks of two boxes that slide at 1 to 100 m/s against a wall do not pass it")
{
  BoxDraw draw(11);
  for (int i = 0; i < inputs(100, 5); ++i)
  {
    Scene scene;
    scene.bodies = {ground(), box_body("wall", {evenly(draw, 0.005, 0.025), 5, 10}, {0, 5, 0}, 0)};
    const Vector3<double> velocity(evenly(draw, 1, 100), 0, 0);
    double top = 0;
    for (int k = 0; k < 3; ++k)
    {
      const Vector3<double> half{0.1, evenly(draw, 0.01, 0.1), 0.1};
      scene.bodies.push_back(box_body(numbered("box", k), half, {-2, top + half.y(), 0}));
      scene.bodies.back().velocity = velocity;
      top += 2 * half.y();
    }
    CAPTURE(i);
    CHECK_FALSE(goes_through(scene, 120, i % 2 == 0 ? "direct" : "soft_steps"));
  }
}

TEST_CASE("200 balls and boxes that plates of 1 to 10 mm strike at 1 to 100 rad/s stay before them")
{
  BoxDraw draw(12);
  for (int i = 0; i < inputs(200, 10); ++i)
  {
    Scene scene;
    scene.gravity.setZero();
    SceneBody plate = box_body("plate", {evenly(draw, 0.0005, 0.005), 0.5, 0.5}, {0, 0, 0}, 1000);
    plate.angular_velocity = {0, draw.side() * evenly(draw, 1, 100), 0};
    const double size = evenly(draw, 0.01, 0.2);
    const Vector3<double> place(-size - 0.005 - draw.between(0, 0.05), 0, draw.between(-0.4, 0.4));
    SceneBody struck = ball_body("struck", size, place, draw.between(0.1, 2));
    if (draw.whole(2) == 0)
    {
      struck.shape = BoxShape{{size, size * draw.between(0.3, 1), size}};
    }
    struck.restitution = draw.whole(2) * 0.5;
    scene.bodies = {box_body("far", {1, 1, 1}, {0, -1e4, 0}, 0), plate, struck};
    GameWorld world(scene, solver_named(i % 2 == 0 ? "direct" : "soft_steps"));
    for (int step = 0; step < 120; ++step)
    {
      const Vector3<double> was = seen_from(world, 1, 2);
      world.step();
      const Vector3<double> now = seen_from(world, 1, 2);
      // Beside the rim it may go round it.
      const double rim = 0.5 - size, out = std::max(std::abs(was.z()), std::abs(now.z()));
      CAPTURE(i, step);
      REQUIRE_FALSE((was.x() * now.x() < 0 && out < rim && std::abs(now.y()) < rim));
    }
  }
}
