/// \file
/// The worked example of a shape in six functions: against closed forms and sampling, and in the
/// world, which knows nothing of it.

#include "06_world/cylinder/cylinder.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/world_queries.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/random_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

using namespace cookbook;

namespace
{

using V = Vector3<double>;

const std::array<std::string, 3> solvers{"direct", "soft_steps", "wide_steps"};
const Quaternion<double> lying(std::sqrt(0.5), std::sqrt(0.5), 0, 0); // its axis along z

Cylinder drawn(Random& draw)
{
  return {draw.between(0.1, 1), draw.between(0.1, 1)};
}

Pose pose(Random& draw)
{
  const Quaternion<double> turn(
      draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1));
  return {draw.in_cube(3), turn.normalized().toRotationMatrix()};
}

/// A point of the surface: of the side, or of an end.
V on_surface(Random& draw, const Cylinder& cylinder)
{
  const double angle = draw.between(0, 2 * std::numbers::pi);
  const bool side = draw.one_in(2);
  const double radius = cylinder.radius * (side ? 1 : std::sqrt(draw.between(0, 1)));
  const double end = draw.one_in(2) ? 1 : -1;
  const double height = cylinder.half_height * (side ? draw.between(-1, 1) : end);
  return {radius * std::cos(angle), height, radius * std::sin(angle)};
}

/// The largest of what the three inequalities of a cylinder are missed by; negative inside.
double outside(const Cylinder& cylinder, const V& p)
{
  return std::max(
      std::hypot(p.x(), p.z()) - cylinder.radius, std::abs(p.y()) - cylinder.half_height);
}

/// A scene of a floor, a box or a plane, and bodies above it.
Scene on_floor(bool plane, const std::vector<SceneBody>& bodies, double size = 1)
{
  Scene scene;
  SceneBody floor{.name = "floor", .shape = PlaneShape{{0, 1, 0}, 0}};
  if (!plane)
  {
    floor.shape = BoxShape{size * V(50, 1, 50)};
    floor.position = {0, -size, 0};
  }
  scene.bodies = {floor};
  scene.bodies.insert(scene.bodies.end(), bodies.begin(), bodies.end());
  return scene;
}

SceneBody body(const Cylinder& cylinder, const V& position, double mass = 10)
{
  return {.name = "cylinder", .shape = cylinder, .mass = mass, .position = position};
}

GameWorld after(const Scene& scene, const std::string& solver, double seconds)
{
  GameWorld world(scene, solver_named(solver), true);
  for (int i = 0; i < seconds * 60; ++i)
  {
    world.step();
  }
  return world;
}

/// How far [rad] the axis of a body is from upright.
double lean(const RigidBody& body)
{
  return std::acos(std::min(1.0, std::abs(body.axes(1, 1))));
}

} // namespace

TEST_CASE("a cylinder has the moments that the sum over its grains comes to, within 1 in 1,000")
{
  const Cylinder cylinder{0.3, 0.5};
  const MassProperties<double> found = mass_properties(cylinder, 10);
  const int n = 120; // grains along an axis
  V sum = V::Zero();
  double count = 0;
  for (int i = 0; i < n * n * n; ++i)
  {
    const V grain = (V(i % n, i / n % n, i / n / n) + V::Constant(0.5)) * 2 / n - V::Ones();
    const V p = grain.cwiseProduct(V(0.3, 0.5, 0.3));
    if (outside(cylinder, p) <= 0)
    {
      const V squares = p.cwiseProduct(p);
      sum += V::Constant(squares.sum()) - squares;
      ++count;
    }
  }
  CHECK(found.mass == 10);
  CHECK(((10 / count * sum - found.moments).cwiseQuotient(found.moments)).norm() < 1e-3);
}

TEST_CASE("bounds of 10,000 cylinders hold their surface and are met by it, by support points too")
{
  Random draw(1);
  for (int i = 0; i < inputs(10'000, 300); ++i)
  {
    const Cylinder cylinder = drawn(draw);
    const Pose at = pose(draw);
    const Eigen::AlignedBox<double, 3> box = bounds(cylinder, at);
    const double rounding = 1e-14;
    for (int k = 0; k < 20; ++k)
    {
      const V point = on_surface(draw, cylinder), direction = draw.direction();
      const V farthest = support(cylinder, direction);
      REQUIRE(std::abs(outside(cylinder, farthest)) < rounding);
      REQUIRE(direction.dot(point) <= direction.dot(farthest) + rounding);
      REQUIRE(box.exteriorDistance(at.center + at.axes * point) < rounding);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const V up = at.axes.transpose() * V::Unit(axis);
      const V high = at.center + at.axes * support(cylinder, up);
      const V low = at.center + at.axes * support(cylinder, -up);
      REQUIRE(std::abs(high[axis] - box.max()[axis]) < rounding);
      REQUIRE(std::abs(low[axis] - box.min()[axis]) < rounding);
    }
    const auto [inner, outer] = extent(cylinder);
    REQUIRE(inner == std::min(cylinder.radius, cylinder.half_height));
    REQUIRE(
        outer * outer - std::pow(cylinder.radius, 2) - std::pow(cylinder.half_height, 2) < 1e-15);
  }
}

TEST_CASE("from 10,000 points a cylinder's surface is where its distance says, and nowhere nearer")
{
  Random draw(2);
  for (int i = 0; i < inputs(10'000, 300); ++i)
  {
    const Cylinder cylinder = drawn(draw);
    const V point = draw.in_cube(1.5);
    const Direction<double> found = distance(cylinder, point);
    REQUIRE(std::abs(found.unit.norm() - 1) < 1e-15);
    REQUIRE((found.length > 0) == (outside(cylinder, point) > 0));
    REQUIRE(std::abs(outside(cylinder, point - found.length * found.unit)) < 1e-14);
    for (int k = 0; k < 50; ++k)
    {
      REQUIRE((on_surface(draw, cylinder) - point).norm() >= std::abs(found.length) - 1e-14);
    }
  }
}

TEST_CASE("10,000 rays meet a cylinder on its surface, outside of it until then, or never")
{
  Random draw(3);
  int met = 0;
  for (int i = 0; i < inputs(10'000, 300); ++i)
  {
    const Cylinder cylinder = drawn(draw);
    const Ray<double> ray{draw.in_cube(2), draw.between(0.1, 3) * draw.direction()};
    const ShapeHit hit = cast(ray, cylinder);
    const double end = hit ? hit->t : 8 / ray.direction.norm();
    for (int k = 0; k < 200; ++k)
    {
      const V before = ray.origin + end * k / 200 * ray.direction;
      REQUIRE((outside(cylinder, before) > 0 || (hit && hit->t == 0)));
    }
    if (hit && hit->t > 0)
    {
      ++met;
      REQUIRE((ray.origin + hit->t * ray.direction - hit->point).norm() < 1e-13);
      REQUIRE(std::abs(outside(cylinder, hit->point)) < 1e-14);
      REQUIRE(hit->normal.dot(ray.direction) < 0);
      const V out = hit->point + 1e-6 * hit->normal;
      REQUIRE(std::abs(distance(cylinder, out).length - 1e-6) < 1e-12);
    }
  }
  CHECK(met > inputs(300, 5));
}

TEST_CASE("a cylinder that stands stays upright and in its place for 10 s, and sleeps")
{
  for (const std::string& solver : solvers)
  {
    for (const bool plane : {true, false})
    {
      CAPTURE(solver, plane);
      const GameWorld world = after(on_floor(plane, {body({0.2, 0.5}, {0, 0.5, 0})}), solver, 10);
      const RigidBody& one = world.bodies()[1];
      CHECK(lean(one) < 1e-4);
      CHECK((one.motion.center - V(0, 0.5, 0)).norm() < 1e-4);
      CHECK(world.is_asleep(1));
    }
  }
}

// [log]
TEST_CASE("a log rolls down a slope with two thirds of what pulls it, within 2 %")
{
  const double angle = 0.2, seconds = 2;
  const V up(std::sin(angle), std::cos(angle), 0), down(std::cos(angle), -std::sin(angle), 0);
  for (const std::string& solver : solvers)
  {
    for (const bool plane : {true, false})
    {
      CAPTURE(solver, plane);
      SceneBody log = body({0.2, 0.5}, 0.2 * up);
      log.orientation = lying;
      Scene scene = on_floor(plane, {log});
      scene.bodies[0].shape = plane ? Shape(PlaneShape{up, 0}) : BoxShape{{50, 1, 5}};
      scene.bodies[0].position = plane ? V::Zero().eval() : V(-up);
      scene.bodies[0].orientation = Eigen::AngleAxis<double>(-angle, V::UnitZ());
      const GameWorld world = after(scene, solver, seconds);
      const Motion<double>& motion = world.bodies()[1].motion;
      const double pull = 2.0 / 3 * 9.81 * std::sin(angle);
      CHECK(std::abs(motion.velocity.dot(down) / (pull * seconds) - 1) < 2e-2);
      CHECK(std::abs(motion.center.dot(down) / (pull * seconds * seconds / 2) - 1) < 2e-2);
      CHECK(std::abs(motion.angular_velocity.z() * 0.2 / motion.velocity.norm() + 1) < 2e-2);
      CHECK(std::abs(motion.center.z()) < 1e-3);
    }
  }
}
// [log]

TEST_CASE("a log that lands on the flat, and one whose rolling is damped, come to rest and sleep")
{
  for (const std::string& solver : solvers)
  {
    for (const bool plane : {true, false})
    {
      CAPTURE(solver, plane);
      SceneBody lands = body({0.2, 0.5}, {0, 0.4, 0}), rolls = body({0.2, 0.5}, {0, 0.2, 3});
      lands.orientation = rolls.orientation = lying;
      rolls.velocity = {1, 0, 0};
      rolls.angular_velocity = {0, 0, -5};
      rolls.angular_damping = 5;
      const GameWorld world = after(on_floor(plane, {lands, rolls}), solver, 10);
      CHECK((world.is_asleep(1) && world.is_asleep(2)));
      CHECK(std::abs(world.bodies()[1].motion.center.y() - 0.2) < 1e-3);
      CHECK(world.bodies()[2].motion.center.x() > 0.3);
    }
  }
}

TEST_CASE("two cylinders stand on each other, turned against each other, and sleep")
{
  for (const std::string& solver : solvers)
  {
    for (const bool plane : {true, false})
    {
      CAPTURE(solver, plane);
      SceneBody upper = body({0.2, 0.25}, {0.02, 0.75, 0.01});
      upper.orientation = Eigen::AngleAxis<double>(0.4, V::UnitY());
      const Scene scene = on_floor(plane, {body({0.2, 0.25}, {0, 0.25, 0}), upper});
      const GameWorld world = after(scene, solver, 10);
      CHECK((lean(world.bodies()[1]) < 1e-3 && lean(world.bodies()[2]) < 1e-3));
      CHECK((world.bodies()[2].motion.center - V(0.02, 0.75, 0.01)).norm() < 2e-3);
      CHECK(world.is_asleep(2));
    }
  }
}

TEST_CASE("a cylinder tips over on a slope that is 5 % too steep for it, and stands on one 8 % "
          "less steep: "
          "the octagon in its rim is narrower by 7.6 %")
{
  const Cylinder slender{0.2, 0.5}; // its centre is above its rim at a slope of 0.4
  for (const std::string& solver : solvers)
  {
    for (int heading = 0; heading < 8; ++heading)
    {
      for (const double part : {0.92, 1.05})
      {
        CAPTURE(solver, heading, part);
        const double angle = std::atan(0.4 * part), turn = heading * std::numbers::pi / 16;
        const V up(std::sin(angle), std::cos(angle), 0);
        SceneBody one = body(slender, 0.5 * up);
        one.orientation = Eigen::AngleAxis<double>(-angle, V::UnitZ()) *
                          Eigen::AngleAxis<double>(turn, V::UnitY());
        one.friction = 4;
        Scene scene = on_floor(true, {one});
        scene.bodies[0].shape = PlaneShape{up, 0};
        const GameWorld world = after(scene, solver, 4);
        const bool stands = world.bodies()[1].axes.col(1).dot(up) > 0.99;
        CHECK(stands == (part < 1));
      }
    }
  }
}

TEST_CASE("rays, spheres and boxes find a cylinder of the world where it is")
{
  Random draw(4);
  SceneBody log = body({0.2, 0.5}, {1, 2, 3});
  log.orientation = lying;
  const GameWorld world({.bodies = {log}}, solver_named("direct"));
  const WorldQueries queries(world);
  const auto hit = queries.cast(Ray<double>{{1, 10, 3.4}, {0, -1, 0}});
  REQUIRE(hit);
  CHECK(std::abs(hit->hit.t - 7.8) < 1e-14);
  CHECK((hit->hit.normal - V(0, 1, 0)).norm() < 1e-14);
  CHECK(!queries.cast(Ray<double>{{1, 10, 3.6}, {0, -1, 0}}));
  const auto swept = queries.cast(Sphere<double>{{1, 2, 10}, 0.5}, V(0, 0, -10));
  REQUIRE(swept);
  CHECK(std::abs(swept->hit.time - 0.6) < 1e-12);
  CHECK((swept->hit.normal - V(0, 0, -1)).norm() < 1e-12);
  CHECK(!queries.cast(Sphere<double>{{1, 2.71, 10}, 0.5}, V(0, 0, -20)));
  for (int i = 0; i < inputs(1'000, 50); ++i)
  {
    const Sphere<double> sphere{V(1, 2, 3) + draw.in_cube(1), draw.between(0.01, 0.5)};
    const V local(sphere.center.x() - 1, sphere.center.z() - 3, sphere.center.y() - 2);
    const double apart = distance(Cylinder{0.2, 0.5}, local).length - sphere.radius;
    REQUIRE(queries.overlapping(sphere).size() == (apart <= 0 ? 1 : 0));
  }
  const auto box = [](double x) {
    return Obb<double>{{x, 2, 3}, Matrix3<double>::Identity(), {0.5, 0.5, 0.1}};
  };
  CHECK(queries.overlapping(box(1.6999)).size() == 1);
  CHECK(queries.overlapping(box(1.7001)).empty());
}

TEST_CASE("a thousand times as large or small, on any heading, a log rolls alike and a drum stands")
{
  const double angle = 0.2, seconds = 2;
  for (const std::string& solver : solvers)
  {
    for (const double size : {1e-3, 1.0, 1e3})
    {
      for (const double heading : {0.0, 0.7, 2.5, -0.7})
      {
        CAPTURE(solver, size, heading);
        const Eigen::AngleAxis<double> turn(heading, V::UnitY());
        const V up = turn * V(std::sin(angle), std::cos(angle), 0);
        const V down = turn * V(std::cos(angle), -std::sin(angle), 0);
        SceneBody log = body({0.2 * size, 0.5 * size}, size * (0.2 * up));
        log.orientation = turn * lying;
        SceneBody drum = body({0.5 * size, 0.2 * size}, size * (0.2 * up + 3 * up.cross(down)));
        drum.orientation = turn * Eigen::AngleAxis<double>(-angle, V::UnitZ());
        Scene scene = on_floor(true, {log, drum});
        scene.bodies[0].shape = PlaneShape{up, 0};
        scene.step = std::sqrt(size) / 60; // lengths by g t²: all else is the same
        const GameWorld world = after(scene, solver, seconds);
        const double pull = 2.0 / 3 * 9.81 * std::sin(angle);
        const V way = world.bodies()[1].motion.center / size - 0.2 * up;
        CHECK((way / (pull * seconds * seconds / 2) - down).norm() < 2e-2);
        const RigidBody& stands = world.bodies()[2];
        CHECK((stands.motion.center - drum.position).norm() < 2e-3 * size);
        CHECK((stands.axes.col(1) - up).norm() < 2e-3);
      }
    }
  }
}
