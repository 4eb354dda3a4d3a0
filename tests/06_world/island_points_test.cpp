/// \file
/// What the world's solvers do at one contact point: friction, however the scene is turned, a gap
/// that closes in one small step, and bounces beside points that rest.

#include "06_world/contacts/start_body.hpp"
#include "06_world/islands/simultaneous_impacts.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "06_world/soft_steps/soft_steps.hpp"
#include "common/math/rotation.hpp"

#include "tests/catch.hpp"

#include <array>
#include <cmath>
#include <numbers>

using namespace cookbook;

namespace
{

using V = Vector3<double>;

const V up(0, 1, 0);

/// The contact of a body with one below it, at one place; B is pushed along +y.
WorldContact contact_at(
    const RigidBody& a, const RigidBody& b, const std::pair<int, int>& numbers, const V& place)
{
  WorldContact contact;
  contact.a = numbers.first;
  contact.b = numbers.second;
  contact.normal = up;
  contact.points.resize(1);
  contact.points[0].anchor_a = a.axes.transpose() * (place - a.motion.center);
  contact.points[0].anchor_b = b.axes.transpose() * (place - b.motion.center);
  return contact;
}

/// A body that touches the ground at a place, pressed on it by an impulse [N s], with μ = 1/2.
struct OnGround
{
  RigidBody floor = rigid_body(ground());
  RigidBody body;
  WorldContact contact;

  OnGround(const SceneBody& on_top, const V& place, double impulse)
      : body(rigid_body(on_top)), contact(contact_at(floor, body, {0, 1}, place))
  {
    contact.friction = 0.5;
    contact.points[0].warm_start_impulse = impulse;
  }

  /// The friction after so many visits.
  V rubbed(int visits)
  {
    IslandPoint point =
        island_point(floor, body, contact, frame_of(floor, body, contact), contact.points[0]);
    for (int i = 0; i < visits; ++i)
    {
      add_friction(point);
    }
    store({&point, 1});
    return point.surface.in_world(point.friction);
  }
};

/// A turn about the normal.
Quaternion<double> about_up(int degrees)
{
  return Quaternion<double>(Eigen::AngleAxis<double>(degrees * std::numbers::pi / 180, up));
}

/// A ball of 1 kg that moves over the ground at (3, 0, 4) m/s, all turned about the normal.
OnGround sliding_ball(int degrees, double impulse)
{
  SceneBody sphere = ball_body("ball", 0.5, {0, 0.5, 0});
  sphere.velocity = about_up(degrees) * V(3, 0, 4);
  return {sphere, {0, 0, 0}, impulse};
}

/// A cube of 1 kg and 1 m on its corner at (1, 0, 1)/2, seen from above: 2.5 m/s along the diagonal
/// and 5.5 m/s across it, all turned about the normal.
OnGround sliding_cube(int degrees, double impulse)
{
  SceneBody cube = cube_body("cube", {0, 0.5, 0});
  const V along = V(1, 0, 1).normalized(), across = V(1, 0, -1).normalized();
  cube.orientation = about_up(degrees);
  cube.velocity = about_up(degrees) * V(2.5 * along + 5.5 * across);
  return {cube, about_up(degrees) * V(0.5, 0, 0.5), impulse};
}

constexpr int all_around[] = {0, 17, 45, 90, 133, 180, 251, 330};

} // namespace

TEST_CASE(
    "add_friction: 2/7 of a ball's 5 N s hold it, half of 2 N s rub straight back, turned anyhow",
    "[R6][R7]")
{
  for (const int degrees : all_around)
  {
    CAPTURE(degrees);
    const V constrained = sliding_ball(degrees, 4).rubbed(1),
            rubbed = sliding_ball(degrees, 2).rubbed(1);
    // K of a ball is 1 + r²/I = 7/2.
    CHECK((constrained - about_up(degrees) * V(-6, 0, -8) / 7).norm() <= 1e-14);
    CHECK((rubbed - about_up(degrees) * V(-0.6, 0, -0.8)).norm() <= 1e-14);
    CHECK((sliding_ball(degrees, 2).rubbed(50) - rubbed).norm() <= 1e-13);
    CHECK(sliding_ball(degrees, 0).rubbed(5) == V(0, 0, 0));
  }
}

TEST_CASE(
    "add_friction: a cube's corner is held by K of 2.5 along its diagonal and 5.5 across it, "
    "turned anyhow",
    "[R6][R7]")
{
  for (const int degrees : all_around)
  {
    CAPTURE(degrees);
    OnGround cube = sliding_cube(degrees, 4);
    double energy = kinetic_energy(cube.body);
    for (int i = 0; i < 200; ++i)
    {
      cube.rubbed(1);
      CHECK(kinetic_energy(cube.body) <= energy * (1 + 1e-14));
      energy = kinetic_energy(cube.body);
    }
    const V constrained = cube.rubbed(1);
    const V along = V(1, 0, 1).normalized(), across = V(1, 0, -1).normalized();
    CHECK((constrained + about_up(degrees) * (along + across)).norm() <= 1e-13);
    const Arms<double> arms{
        about_up(degrees) * V(0.5, 0, 0.5), about_up(degrees) * V(0.5, -0.5, 0.5)};
    CHECK(sliding_velocity<double>(cube.floor, cube.body, surface_axes(up), arms).norm() <= 1e-13);
    // Half of 2 N s is less than √2: it rubs against what still slides.
    const V rubbed = sliding_cube(degrees, 2).rubbed(2000);
    CHECK(rubbed.norm() == Catch::Approx(1).epsilon(1e-14));
    CHECK((about_up(-degrees) * rubbed - sliding_cube(0, 2).rubbed(2000)).norm() <= 1e-12);
  }
}

TEST_CASE("add_friction takes back what a smaller push does not allow any more", "[R6][R7]")
{
  OnGround sphere = sliding_ball(0, 4);
  sphere.rubbed(1);
  sphere.contact.points[0].warm_start_impulse = 1;
  CHECK((sphere.rubbed(1) - V(-0.3, 0, -0.4)).norm() <= 1e-14);
}

TEST_CASE("soft steps: a gap of 2 cm may close within a small step of 10 ms, at 2 m/s", "[R16]")
{
  OnGround sphere(ball_body("ball", 0.5, {0, 0.52, 0}), {0, 0, 0}, 0);
  sphere.body.motion.velocity = {0, -5, 0};
  sphere.contact.points[0].anchor_b = {0, -0.5, 0};
  IslandPoint point = island_point(
      sphere.floor, sphere.body, sphere.contact,
      frame_of(sphere.floor, sphere.body, sphere.contact), sphere.contact.points[0]);
  solve_contact<double>(sphere.floor, sphere.body, point, softness(12.5, 5.0, 0.01), 0.01, 1);
  CHECK(sphere.body.motion.velocity.y() == Catch::Approx(-2).epsilon(1e-12));
  // Slower, it does not close at all, and nothing pushes.
  sphere.body.motion.velocity = {0, -1.9, 0};
  point.impulse = 0;
  solve_contact<double>(sphere.floor, sphere.body, point, softness(12.5, 5.0, 0.01), 0.01, 1);
  CHECK(sphere.body.motion.velocity.y() == -1.9);
}

TEST_CASE("balls that come closer by no more than rounding of their speeds do not push each other")
{
  for (const double closing : {1e-16, 1e-15, 1e-12})
  {
    CAPTURE(closing);
    RigidBody low = rigid_body(ball_body("low", 0.5, {0, 0, 0}));
    RigidBody high = rigid_body(ball_body("high", 0.5, {0, 1, 0}));
    low.motion.velocity = {0.3, -1, 0};
    high.motion.velocity = {0, -1 - closing, 0};
    WorldContact contact = contact_at(low, high, {0, 1}, {0, 0.5, 0});
    std::vector<ImpactPoint> points{
        {island_point(low, high, contact, frame_of(low, high, contact), contact.points[0]), 0}};
    solve_impact(points, 1);
    CHECK((points[0].point.impulse > 0) == (closing == 1e-12));
  }
}

TEST_CASE("a ball that bounces on a cube that rests leaves the cube on its ground", "[R19]")
{
  const double speed = GENERATE(3.0, 0.5);
  SceneBody falling = ball_body("ball", 0.5, {0, 1.5, 0});
  falling.velocity = {0, -speed, 0};
  std::array<RigidBody, 3> bodies{
      rigid_body(ground()), rigid_body(cube_body("cube", {0, 0.5, 0})), rigid_body(falling)};
  std::array<WorldContact, 2> contacts{
      contact_at(bodies[0], bodies[1], {0, 1}, {0, 0, 0}),
      contact_at(bodies[1], bodies[2], {1, 2}, {0, 1, 0})};
  contacts[1].restitution = 1;
  constexpr std::array<int, 2> movable{1, 2}, both{0, 1};
  SolverScratch room;
  const IslandView view{bodies, contacts, {0, -9.81, 0}, room};
  CHECK(simultaneous_impacts(view, {movable, both}, 1.0 / 60));
  CHECK(bodies[1].motion.velocity.norm() <= 1e-12);
  CHECK((bodies[2].motion.velocity - V(0, speed, 0)).norm() <= 1e-12);
  CHECK(!simultaneous_impacts(view, {movable, both}, 1.0 / 60)); // they part
  bodies[2].motion.center.y() += 0.2;
  bodies[2].motion.velocity = {0, -speed, 0};
  CHECK(!simultaneous_impacts(
      view, {movable, both}, 1.0 / 60)); // they will touch, but not in this step
  CHECK(bodies[2].motion.velocity == V(0, -speed, 0));
}
