/// \file
/// What stands by friction: blocks on slopes, ladders and cards stand at 5 % more friction than
/// statics asks, and slip at 5 % less.

#include "04_obb_manifolds/feature_memory/leaning_edges.hpp"
#include "06_world/game_world/game_world.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

using namespace cookbook;

namespace
{

constexpr double enough = 1.05, too_little = 0.95; // of the friction that statics asks

/// The solvers that the book recommends.
std::string recommended()
{
  return GENERATE(std::string("direct"), "soft_steps", "wide_steps");
}

/// A body with this friction.
SceneBody rough(SceneBody body, double friction)
{
  body.friction = friction;
  return body;
}

/// A plane through a point with a normal, and this friction.
SceneBody plane(const Vector3<double>& normal, double offset, double friction)
{
  return rough({.name = "plane", .shape = PlaneShape{normal, offset}}, friction);
}

/// A world after a time [s].
GameWorld after(const Scene& scene, const std::string& solver, double time)
{
  GameWorld world(scene, solver_named(solver));
  while (world.time() < time)
  {
    world.step();
  }
  return world;
}

/// A board of 2 cm by 1 m by .7 m that leans to the left by an angle [rad], its lower corner on y =
/// 0 and its upper corner on x = 0; and the tangent of friction that this takes.
///
/// The board presses sideways with H above, and bears its weight W and H below. About the lower
/// corner: H · (height of the upper one) = W · (how far the centre is to the left of it).
struct Leaning
{
  SceneBody board;
  double friction; ///< [1], H / W
};

Leaning leaning(double angle)
{
  const Vector3<double> half(0.01, 0.5, 0.35);
  const Vector3<double> up(-std::sin(angle), std::cos(angle), 0);
  const Vector3<double> right(std::cos(angle), std::sin(angle), 0);
  const Vector3<double> below = -half.y() * up - half.x() * right;
  const Vector3<double> above = half.y() * up - half.x() * right;
  Leaning made{box_body("board", half, {-above.x(), -below.y(), 0}), 0};
  made.board.orientation = turn_about_z(std::sin(angle), std::cos(angle));
  made.friction = below.x() / (above.y() - below.y());
  return made;
}

/// The mirror image in x = 0 of a body that is turned about z.
SceneBody mirrored(SceneBody body)
{
  body.position.x() *= -1;
  body.orientation = body.orientation.conjugate();
  return body;
}

/// How far [m] the last body of a scene has come down after ten seconds.
double sunk(const Scene& scene, const std::string& solver)
{
  const Vector3<double> end = after(scene, solver, 10).bodies().back().motion.center;
  return scene.bodies.back().position.y() - end.y();
}

/// A crate at a radius [m] on a table, kinematic or of 1000 t, that turns so fast that the crate
/// asks a fraction of the friction that it has.
Scene turntable(double fraction, double radius, bool kinematic_table)
{
  const double friction = 0.6, spin = std::sqrt(fraction * friction * 9.81 / radius);
  SceneBody table = rough(box_body("table", {3, 0.5, 3}, {0, 0.5, 0}, 1e6), friction);
  table.angular_velocity = {0, spin, 0};
  SceneBody crate = rough(box_body("crate", {0.25, 0.25, 0.25}, {radius, 1.25, 0}, 10), friction);
  crate.velocity = {0, 0, -spin * radius};
  crate.angular_velocity = table.angular_velocity;
  return {.bodies = {plane({0, 1, 0}, 0, 0), kinematic_table ? kinematic(table) : table, crate}};
}

} // namespace

TEST_CASE(
    "A crate on a turning table keeps its radius within 1 % for a minute at 90 % of its friction, "
    "directly on one of 1000 t within 1.5 %",
    "[friction][R6]")
{
  const std::string solver = recommended();
  const bool kinematic_table = GENERATE(false, true);
  const double fraction = GENERATE(0.3, 0.667, 0.9), radius = GENERATE(1.0, 2.0);
  CAPTURE(solver, kinematic_table, fraction, radius);
  GameWorld world(turntable(fraction, radius, kinematic_table), solver_named(solver));
  double off = 0;
  while (world.time() < 60)
  {
    world.step();
    Vector3<double> from = world.bodies()[2].motion.center - world.bodies()[1].motion.center;
    from.y() = 0;
    off = std::max(off, std::abs(from.norm() - radius));
  }
  const bool directly = solver == "direct" && !kinematic_table && fraction > 0.8;
  CHECK(off < (directly ? 0.015 : 0.01) * radius);
}

TEST_CASE("A crate that asks 1.05 times the friction that it has leaves a turning table")
{
  const std::string solver = recommended();
  const GameWorld world = after(turntable(1.05, 2, true), solver, 30);
  CHECK((world.bodies()[2].motion.center - Vector3<double>(0, 1, 0)).norm() > 4);
}

TEST_CASE("A block stands on a slope at 1.05 tan of its angle, and slides at .95", "[friction][R6]")
{
  const std::string solver = recommended();
  const double degrees = GENERATE(10.0, 20.0, 30.0, 40.0);
  CAPTURE(solver, degrees);
  const double angle = degrees * std::numbers::pi / 180;
  const auto slid = [&](double fraction)
  {
    const double friction = fraction * std::tan(angle);
    const Vector3<double> normal(std::sin(angle), std::cos(angle), 0);
    SceneBody block = rough(box_body("block", {0.3, 0.2, 0.25}, 0.2 * normal), friction);
    block.orientation = turn_about_z(-std::sin(angle), std::cos(angle));
    const Scene scene{.bodies = {plane(normal, 0, friction), block}};
    return (after(scene, solver, 10).bodies()[1].motion.center - block.position).norm();
  };
  CHECK(slid(enough) < 1e-3);
  // A block that slides goes g (sin − .95 tan cos) t² / 2 = 2.5 sin [m/s²] t².
  CHECK(slid(too_little) == Catch::Approx(0.05 * 9.81 / 2 * std::sin(angle) * 100).epsilon(0.03));
}

TEST_CASE(
    "A ladder at a smooth wall stands at 1.05 times the friction of statics, and slips at .95",
    "[friction][R6]")
{
  const std::string solver = recommended();
  const double degrees = GENERATE(20.0, 30.0, 45.0);
  CAPTURE(solver, degrees);
  const Leaning made = leaning(degrees * std::numbers::pi / 180);
  const auto comes_down = [&](double fraction)
  {
    const double friction = fraction * made.friction;
    return sunk(
        {.bodies =
             {plane({0, 1, 0}, 0, friction), plane({1, 0, 0}, 0, 0), rough(made.board, friction)}},
        solver);
  };
  CHECK(comes_down(enough) < 2e-3);
  CHECK(comes_down(too_little) > 0.3);
}

TEST_CASE(
    "Two cards that lean on each other stand at 1.05 times the friction of statics, and slip at "
    ".95",
    "[friction][R6]")
{
  const std::string solver = recommended();
  const double degrees = GENERATE(15.0, 20.0, 30.0, 40.0);
  CAPTURE(solver, degrees);
  const Leaning made = leaning(degrees * std::numbers::pi / 180);
  const auto comes_down = [&](double fraction)
  {
    const SceneBody card = rough(made.board, fraction * made.friction);
    return sunk({.bodies = {plane({0, 1, 0}, 0, card.friction), mirrored(card), card}}, solver);
  };
  CHECK(comes_down(enough) < 2e-3);
  CHECK(comes_down(too_little) > 0.3);
}

TEST_CASE("Boxes that lean on each other have a level normal, to 1e-12, and two points at their "
          "edges' ends")
{
  const double degrees = GENERATE(15.0, 30.0, 40.0);
  const SceneBody board = leaning(degrees * std::numbers::pi / 180).board;
  Obb<double> right{
      board.position, board.orientation.toRotationMatrix(),
      std::get<BoxShape>(board.shape).half_extents};
  const SceneBody other = mirrored(board);
  Obb<double> left{other.position, other.orientation.toRotationMatrix(), right.half_extents};
  left.half_extents.z() = 0.2; // the shorter of two edges has both ends
  const auto manifold = leaning_manifold(left, right, 0, 0.003, 0.001);
  REQUIRE(manifold);
  CHECK((manifold->normal - Vector3<double>(1, 0, 0)).norm() < 1e-12);
  CHECK(std::abs(manifold->depth) < 1e-12);
  REQUIRE(manifold->points.size() == 2);
  const double height =
      2 * board.position.y() - 2 * 0.01 * std::sin(degrees * std::numbers::pi / 180);
  CHECK((manifold->points[0].position - Vector3<double>(0, height, -0.2)).norm() < 1e-12);
  CHECK((manifold->points[1].position - Vector3<double>(0, height, 0.2)).norm() < 1e-12);
  // Lifted by more than the width along the other's face, a card is met by that face alone.
  right.center.y() += 0.01;
  CHECK_FALSE(leaning_manifold(left, right, 0, 0.003, 0.001));
}
