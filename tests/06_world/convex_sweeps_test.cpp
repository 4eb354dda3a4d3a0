/// \file
/// Fast bodies of any convex shape on their way through a step: cylinders, and what meets them.

#include "06_world/contacts/start_body.hpp"
#include "06_world/cylinder/cylinder.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/trial/world_measures.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "06_world/sweeps/time_of_impact.hpp"

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

using V = Vector3<double>;

const std::vector<std::string> solvers = inputs(
    std::vector<std::string>{"direct", "soft_steps", "wide_steps"},
    std::vector<std::string>{"wide_steps"});
const Quaternion<double> along_x = turn_about_z(std::sqrt(0.5), std::sqrt(0.5)); // a y axis
const Quaternion<double> along_z(std::sqrt(0.5), std::sqrt(0.5), 0, 0);

SceneBody body_of(const Shape& shape, const V& position, double mass = 1)
{
  return {.name = "body", .shape = shape, .mass = mass, .position = position};
}

/// What flies: a shape of 2 to 20 cm.
enum class Kind
{
  cylinder,
  box,
  sphere
};

Shape drawn(BoxDraw& draw, Kind kind)
{
  const double x = evenly(draw, 0.01, 0.1), y = evenly(draw, 0.01, 0.1);
  return kind == Kind::cylinder ? Shape(Cylinder{x, y})
         : kind == Kind::box    ? Shape(BoxShape{{x, y, evenly(draw, 0.01, 0.1)}})
                                : Shape(SphereShape{x});
}

double outer(const SceneBody& body)
{
  return std::visit([](const auto& shape) { return bounding_radius_of(shape); }, body.shape);
}

double inner(const SceneBody& body)
{
  return std::visit([](const auto& shape) { return inner_radius_of(shape); }, body.shape);
}

/// What it flies at: 1 to 5 cm thick along x, and too large to get round.
enum class Wall
{
  box,
  plane,
  disc,
  pole ///< along y
};

SceneBody wall_of(Wall wall, double thin, double size)
{
  SceneBody body = body_of(PlaneShape{{-1, 0, 0}, 0}, {0, 0, 0}, 0);
  if (wall == Wall::box)
  {
    body.shape = BoxShape{{thin, size, size}};
  }
  else if (wall == Wall::disc)
  {
    body.shape = Cylinder{size, thin};
    body.orientation = along_x;
  }
  else if (wall == Wall::pole)
  {
    body.shape = Cylinder{thin, size};
  }
  return body;
}

/// A body at 10 to 1,000 m/s, tumbling at up to 100 rad/s or not, at a wall that is fixed, or
/// floats, and has 5 to 100 kg.
struct Shot
{
  Scene scene;
  int steps; ///< after which it would be far behind the wall
};

Shot shot(BoxDraw& draw, Kind kind, Wall wall, bool floats)
{
  Shot made{.scene = {}, .steps = 0};
  made.scene.gravity.setZero();
  const double speed = evenly(draw, 10, 1000), thin = evenly(draw, 0.005, 0.025);
  made.scene.bodies.push_back(wall_of(wall, thin, 3 + speed / 10));
  made.scene.bodies[0].mass = floats ? evenly(draw, 5, 100) : 0;
  SceneBody body = body_of(drawn(draw, kind), V::Zero());
  const double start = draw.between(0.01, 2) + outer(body) + thin;
  body.position.x() = -start;
  // At a pole it is aimed so that its inner sphere is stopped.
  const double aslant = wall == Wall::pole ? 0.5 * inner(body) / start : 0.7;
  body.velocity = speed * V(1, 0, draw.between(-aslant, aslant)).normalized();
  body.orientation = Quaternion<double>(draw.rotation());
  body.angular_velocity = draw.whole(2) * evenly(draw, 1, 100) * draw.direction();
  body.restitution = draw.whole(2) * draw.between(0, 1);
  body.friction = draw.between(0, 1);
  made.scene.bodies.push_back(body);
  made.steps = 2 + static_cast<int>(60 * 3 * start / speed);
  return made;
}

/// Whether a body gets behind the wall, or a pole leaves its velocity as it was; and that the
/// energy never grows.
bool goes_through(const Shot& shot, Wall wall, const std::string& solver)
{
  GameWorld world(shot.scene, solver_named(solver));
  const RigidBody &thin = world.bodies()[0], &body = world.bodies()[1];
  const double most = energy(world.bodies(), shot.scene.gravity);
  const V across = wall == Wall::disc ? V(0, 1, 0) : V(1, 0, 0);
  const auto side = [&]
  { return (thin.axes * across).dot(body.motion.center - thin.motion.center); };
  const double before = side();
  for (int i = 0; i < shot.steps; ++i)
  {
    world.step();
    REQUIRE(energy(world.bodies(), shot.scene.gravity) <= most * (1 + 1e-6));
    if (wall != Wall::pole && side() * before < 0)
    {
      return true;
    }
  }
  return body.motion.velocity == shot.scene.bodies[1].velocity;
}

GameWorld after(const Scene& scene, const std::string& solver, int steps)
{
  GameWorld world(scene, solver_named(solver));
  for (int i = 0; i < steps; ++i)
  {
    world.step();
  }
  return world;
}

/// When a body first touches another within a second, both straight on but for their spin.
std::optional<SweptHit<double>> toi(const SceneBody& a, const SceneBody& b)
{
  const RigidBody body_a = rigid_body(a), body_b = rigid_body(b);
  const auto of = [](const RigidBody& body)
  {
    const auto& [center, velocity, spin] = body.motion;
    return Trajectory{&body, state_of(body), 0, velocity, {}, spin};
  };
  const Trajectory of_a = of(body_a), of_b = of(body_b);
  return std::visit(TimeOfImpact{of_a, of_b, 0, 1, 0}, a.shape, b.shape);
}

} // namespace

// [convex_walls]
TEST_CASE("1,440 cylinders, boxes and spheres at 10 to 1,000 m/s, tumbling or not, pass no wall, "
          "disc nor pole of 1 to 5 cm where one of the two is a cylinder")
{
  for (const std::string& solver : solvers)
  {
    for (const Kind kind : {Kind::cylinder, Kind::box, Kind::sphere})
    {
      for (const Wall wall : {Wall::box, Wall::plane, Wall::disc, Wall::pole})
      {
        const bool known = kind != Kind::cylinder && (wall == Wall::box || wall == Wall::plane);
        BoxDraw draw(1);
        for (int i = 0; i < (known ? 0 : inputs(60, 3)); ++i)
        {
          const Shot one = shot(draw, kind, wall, wall != Wall::plane && i % 2 == 0);
          CAPTURE(solver, static_cast<int>(kind), static_cast<int>(wall), i);
          CHECK_FALSE(goes_through(one, wall, solver));
        }
      }
    }
  }
}
// [convex_walls]

TEST_CASE("2,000 cylinders and boxes, tumbling or not, pass a disc or an edge by 1 µm to 1 cm as "
          "if nothing were there")
{
  BoxDraw draw(5);
  for (int i = 0; i < inputs(2'000, 20); ++i)
  {
    const double radius = evenly(draw, 0.01, 0.1), half = evenly(draw, 0.01, 0.1);
    const double speed = evenly(draw, 5, 1000), spin = draw.whole(2) * draw.between(-100, 100);
    const bool is_box = i % 3 == 0;
    const Shape shape = is_box ? Shape(BoxShape{{radius, half, radius}}) : Cylinder{radius, half};
    // What spins about z reaches as far up as the diagonal of its outline.
    const double up = spin == 0 ? half : std::hypot(radius, half);
    SceneBody body = body_of(shape, {draw.between(-2, -1), 1 + up + evenly(draw, 1e-6, 1e-2), 0});
    body.velocity = {speed, 0, 0};
    body.angular_velocity = {0, 0, spin};
    Scene alone{.bodies = {body}};
    alone.gravity.setZero();
    Scene scene = alone;
    scene.bodies.push_back(wall_of(is_box || i % 2 == 0 ? Wall::disc : Wall::box, 0.01, 1));
    const int steps = 2 + static_cast<int>(60 * 4 / speed);
    const GameWorld world = after(scene, "direct", steps), other = after(alone, "direct", steps);
    const RigidBody &flown = world.bodies()[0], &expected = other.bodies()[0];
    CAPTURE(i, speed, spin);
    REQUIRE(flown.motion.velocity == expected.motion.velocity);
    REQUIRE(flown.motion.angular_velocity == expected.motion.angular_velocity);
    REQUIRE(flown.motion.center == expected.motion.center);
    REQUIRE(flown.orientation.coeffs() == expected.orientation.coeffs());
  }
}

TEST_CASE("200 pairs of a cylinder and any other shape that fly at each other meet, no deeper than "
          "a third of the thinner, and keep their momentum")
{
  BoxDraw draw(3);
  for (int i = 0; i < inputs(200, 10); ++i)
  {
    Scene scene;
    scene.gravity.setZero();
    const Kind other = i % 3 == 0 ? Kind::cylinder : i % 3 == 1 ? Kind::box : Kind::sphere;
    for (const double side : {-1.0, 1.0})
    {
      SceneBody body = body_of(drawn(draw, side < 0 ? Kind::cylinder : other), {1.5 * side, 0, 0});
      body.mass = evenly(draw, 0.01, 100);
      body.velocity = {-side * evenly(draw, 10, 1000), 0, 0};
      body.orientation = Quaternion<double>(draw.rotation());
      body.angular_velocity = evenly(draw, 1, 100) * draw.direction();
      body.restitution = draw.between(0, 1);
      scene.bodies.push_back(body);
    }
    // Spheres inside of both meet, so they do.
    const double thin = std::min(inner(scene.bodies[0]), inner(scene.bodies[1]));
    const double turn = draw.between(0, 6.3);
    scene.bodies[0].position += draw.between(0, 1.9) * thin * V(0, std::cos(turn), std::sin(turn));
    GameWorld world(scene, solver_named(solvers[std::size_t(i) % solvers.size()]));
    const V before = momentum(world.bodies());
    const double approach = (scene.bodies[0].velocity - scene.bodies[1].velocity).norm();
    for (int step = 0; step < static_cast<int>(60 * 3 / approach) + 20; ++step)
    {
      world.step();
      const double gap =
          gap_between(
              scene.bodies[0].shape, world.bodies()[0], scene.bodies[1].shape, world.bodies()[1])
              .length;
      CAPTURE(i, step);
      REQUIRE(gap >= -0.3 * thin);
    }
    CAPTURE(i);
    CHECK(world.bodies()[0].motion.velocity != scene.bodies[0].velocity);
    CHECK((momentum(world.bodies()) - before).norm() <= 1e-12 * momentum_of_each(scene));
  }
}

// [convex_toi]
TEST_CASE("logs, drums and spheres touch when closed forms say, to 1e-8", "[P23]")
{
  SceneBody log = body_of(Cylinder{0.1, 0.5}, {-3, 0, 0});
  log.velocity.x() = 4;
  // Upright against one along z: the sum of their radii stays.
  SceneBody across = body_of(Cylinder{0.2, 0.5}, {0, 0.3, 0.4});
  across.orientation = along_z;
  REQUIRE(toi(log, across));
  CHECK(toi(log, across)->time == Catch::Approx((3 - 0.1 - 0.2) / 4).epsilon(1e-8));
  CHECK(toi(log, across)->normal.isApprox(V(1, 0, 0), 1e-8));
  // A sphere beside its axis and above its end: a circle about the rim, 0.3 above its end.
  SceneBody sphere = body_of(SphereShape{0.5}, {0, 0.8, 0});
  CHECK(toi(log, sphere)->time == Catch::Approx((3 - 0.1 - 0.4) / 4).epsilon(1e-8));
  // One that tumbles reaches down by r |sin ω t| + h |cos ω t|, and comes to a plane at v t.
  SceneBody tumbles = body_of(Cylinder{0.1, 0.5}, {0, 0, 0});
  const double time = 0.6, spin = 2, down = 4;
  const double reach = 0.1 * std::sin(spin * time) + 0.5 * std::cos(spin * time);
  tumbles.position.y() = down * time + reach;
  tumbles.velocity.y() = -down;
  tumbles.angular_velocity.z() = spin;
  const SceneBody floor = body_of(PlaneShape{{0, 1, 0}, 0}, {0, 0, 0}, 0);
  CHECK(toi(tumbles, floor)->time == Catch::Approx(time).epsilon(1e-8));
  CHECK(toi(floor, tumbles)->normal.isApprox(V(0, 1, 0), 1e-8));
  const SceneBody slab = body_of(BoxShape{{5, 1, 5}}, {0, -1, 0}, 0);
  CHECK(toi(tumbles, slab)->time == Catch::Approx(time).epsilon(1e-8));
}
// [convex_toi]

TEST_CASE("the support function of a box lets its gap last as long as its eight corners do, to 1 %")
{
  BoxDraw draw(2);
  for (int i = 0; i < inputs(2'000, 50); ++i)
  {
    const BoxShape half{{evenly(draw, 0.01, 1), evenly(draw, 0.01, 1), evenly(draw, 0.01, 1)}};
    const Pose pose{2 * draw.direction() * (1 + draw.between(0, 1)), draw.rotation()};
    const V direction = pose.center.normalized();
    const LinearMotion<double> frame{
        V::Zero(), V::Zero(), V::Zero(), draw.whole(2) * draw.vector(-1, 1)};
    const LinearMotion<double> moves{
        pose.center, draw.between(-1, 5) * draw.direction(), draw.whole(2) * draw.vector(-1, 1),
        draw.whole(3) * draw.vector(-1, 1)};
    const ConvexShape any = half;
    const auto corners = moving_corners(placed(pose, half), moves);
    const auto by_corners = corner_approach(frame, direction, 0.1, corners, 0.0, 1e-9);
    const Placed<ConvexShape> shape = placed(pose, any);
    const auto by_support =
        corner_approach(frame, direction, 0.1, moving_corners(shape, moves), 0.0, 1e-9);
    CAPTURE(i);
    REQUIRE(by_support.gap.length == Catch::Approx(by_corners.gap.length).epsilon(1e-12));
    const double expected = std::min(by_corners.safe_time, 1.0);
    REQUIRE(std::min(by_support.safe_time, 1.0) <= expected * (1 + 1e-9));
    REQUIRE(std::min(by_support.safe_time, 1.0) >= expected * 0.99);
  }
}

TEST_CASE("drums that land flat and logs that land on their side bounce at 20 to 1,000 m/s as "
          "restitution says, to 1e-4, and do not turn")
{
  BoxDraw draw(6);
  for (int i = 0; i < inputs(400, 20); ++i)
  {
    const Cylinder cylinder{evenly(draw, 0.01, 0.1), evenly(draw, 0.01, 0.1)};
    const double down = evenly(draw, 20, 1000), restitution = draw.between(0, 1);
    const bool lies = i % 2 == 0;
    Scene scene;
    scene.gravity.setZero();
    SceneBody body =
        body_of(cylinder, {0, (lies ? cylinder.radius : cylinder.half_height) + down / 180, 0});
    body.velocity = {0, -down, 0};
    body.restitution = restitution;
    const Eigen::AngleAxis<double> heading(draw.between(0, 6), V::UnitY());
    body.orientation = heading * (lies ? along_z : Quaternion<double>::Identity());
    const SceneBody slab = body_of(Cylinder{50, 1}, {0, -1, 0}, 0);
    scene.bodies = {i % 3 == 0 ? ground() : i % 3 == 1 ? slab : slab, body};
    if (i % 3 == 1)
    {
      scene.bodies[0].shape = BoxShape{{50, 1, 50}};
    }
    const Motion<double> end = after(scene, solvers[0], 1).bodies()[1].motion;
    CAPTURE(i, lies, down, restitution);
    CHECK(end.velocity.y() == Catch::Approx(restitution * down).margin(1e-4 * down));
    CHECK(end.angular_velocity.norm() * outer(body) <= 1e-3 * down);
  }
}

TEST_CASE(
    "a drum of 10 cm dropped 5 m on a drum bounces to a quarter of that at a restitution of a "
    "half, within 1 %")
{
  for (const std::string& solver : solvers)
  {
    Scene scene{
        .bodies = {
            body_of(Cylinder{1, 0.5}, {0, -0.5, 0}, 0),
            body_of(Cylinder{0.05, 0.05}, {0, 5.05, 0})}};
    scene.bodies[1].restitution = 0.5;
    GameWorld world(scene, solver_named(solver));
    const RigidBody& drum = world.bodies()[1];
    double top = 0;
    for (int step = 0; step < 120; ++step) // it falls for 1.01 s, and rises for half of that
    {
      world.step();
      top = drum.motion.velocity.y() > 0 ? std::max(top, drum.motion.center.y() - 0.05) : top;
    }
    CAPTURE(solver);
    CHECK(top == Catch::Approx(1.25).epsilon(0.01));
  }
}

TEST_CASE("drums and logs of 20 cm slide over flush tiles at 10 to 300 m/s and are not lifted")
{
  for (const std::string& solver : solvers)
  {
    for (const double speed : {10.0, 30.0, 100.0, 300.0})
    {
      for (const bool lies : {false, true})
      {
        Scene scene;
        for (int i = -1; i < 32; ++i)
        {
          scene.bodies.push_back(box_body("tile", {0.5, 0.5, 0.5}, {double(i), -0.5, 0}, 0));
          scene.bodies.back().friction = 0;
        }
        SceneBody body = body_of(Cylinder{0.1, lies ? 0.2 : 0.1}, {-0.8, 0.1, 0.01});
        body.orientation = lies ? along_z : Quaternion<double>::Identity();
        body.friction = 0;
        scene.bodies.push_back(body);
        GameWorld world(scene, solver_named(solver));
        for (int step = 0; step < 30; ++step) // so that it has sunk as far as it does
        {
          world.step();
        }
        const RigidBody& slides = world.bodies().back();
        world.set_velocity(scene.bodies.size() - 1, {speed, 0, 0}, V::Zero());
        CAPTURE(solver, speed, lies);
        while (slides.motion.center.x() < 30 && world.time() < 5)
        {
          world.step();
          REQUIRE(slides.motion.center.y() < 0.105);
        }
        CHECK(slides.motion.velocity.x() == Catch::Approx(speed).epsilon(1e-3));
      }
    }
  }
}
