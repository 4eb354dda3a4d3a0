/// \file
/// Where the contacts of a world are: on both surfaces, for every pair of shapes; and balls of all
/// sizes that roll on them.

#include "01_math/turning/turning.hpp"
#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "06_world/contacts/narrow_phase.hpp"
#include "06_world/contacts/start_body.hpp"
#include "06_world/game_world/solver_names.hpp"
#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <variant>

using namespace cookbook;

namespace
{

using V = Vector3<double>;

/// How far [m] a point is from the surface of a shape, in the body's own frame.
struct FromSurface
{
  const RigidBody& body;
  Vector3<double> point; ///< in the body's frame

  double operator()(const SphereShape& sphere) const
  {
    return std::abs(point.norm() - sphere.radius);
  }
  double operator()(const BoxShape& box) const
  {
    return std::abs(signed_distance_box<double>(point, box.half_extents).length);
  }
  double operator()(const ConvexShape& shape) const
  {
    return std::abs(distance(shape, point).length);
  }
  double operator()(const PlaneShape& plane) const
  {
    const Vector3<double> place = body.motion.center + body.axes * point;
    return std::abs(plane.normal.dot(place) - plane.offset);
  }
};

/// A shape at random, of a size [m]: 0 ball, 1 box, 2 plane.
SceneBody drawn(BoxDraw& draw, int kind, double size)
{
  const Vector3<double> half = size * draw.vector(0.2, 1);
  SceneBody body = box_body("body", half, size * draw.vector(-1, 1));
  if (draw.whole(4) > 0)
  {
    body.orientation = Quaternion<double>(draw.rotation());
  }
  if (kind == 0)
  {
    body.shape = SphereShape{size * draw.between(0.2, 1)};
  }
  if (kind == 2)
  {
    const Vector3<double> normal = draw.direction();
    body = {.name = "plane", .shape = PlaneShape{normal, normal.dot(body.position)}};
  }
  return body;
}

/// The farthest that a point of a contact is from its surface [of the pair's size], over many pairs
/// of shapes that touch, overlap or are a margin apart.
struct Surfaces
{
  int contacts = 0;
  double farthest = 0;

  void ask(BoxDraw& draw, int kind_a, int kind_b)
  {
    const double size = std::ldexp(1.0, draw.whole(21) - 10), margin = 0.01 * size;
    const SceneBody a = drawn(draw, kind_a, size), b = drawn(draw, kind_b, size);
    const RigidBody body_a = rigid_body(a), body_b = rigid_body(b);
    WorldContact contact;
    std::visit(UpdateContact{contact, body_a, body_b, {margin, margin}}, a.shape, b.shape);
    if (contact.points.empty())
    {
      return;
    }
    ++contacts;
    for (const WorldPoint& point : contact.points)
    {
      const double from_a = std::visit(FromSurface{body_a, point.anchor_a}, a.shape);
      const double from_b = std::visit(FromSurface{body_b, point.anchor_b}, b.shape);
      farthest = std::max({farthest, from_a / size, from_b / size});
    }
  }
};

} // namespace

// [on_surfaces]
TEST_CASE("the two points of a contact lie on the two surfaces: 10,000 of each pair of shapes")
{
  const std::pair<int, int> pairs[] = {{0, 0}, {0, 1}, {1, 0}, {2, 0},
                                       {0, 2}, {2, 1}, {1, 2}, {1, 1}};
  for (const auto& [kind_a, kind_b] : pairs)
  {
    BoxDraw draw(11);
    Surfaces surfaces;
    while (surfaces.contacts < random_inputs / 10)
    {
      surfaces.ask(draw, kind_a, kind_b);
    }
    CAPTURE(kind_a, kind_b);
    CHECK(surfaces.farthest <= 1e-12);
  }
}
// [on_surfaces]

// [world_tolerance]
TEST_CASE(
    "edges turned against each other by 1e-10 rad cross nowhere, by 1e-8 rad they do", "[O14]")
{
  const auto points = [](double size, double turned)
  {
    const SceneBody below = box_body("below", {size, size, size}, {0, 0, 0});
    SceneBody above = box_body("above", {size, size, size}, {0.875 * size, 2 * size, 0});
    above.orientation = rotation_by<double>(V(0, turned, 0));
    const RigidBody a = rigid_body(below), b = rigid_body(above);
    WorldContact contact;
    std::visit(UpdateContact{contact, a, b, {0.01, 0.01}}, below.shape, above.shape);
    for (const WorldPoint& point : contact.points)
    {
      const V place = a.axes * point.anchor_a / size;
      const double from_corner = std::min(std::abs(place.x() - 1), std::abs(place.x() + 0.125)) +
                                 std::abs(std::abs(place.z()) - 1);
      CHECK((contact.points.size() > 4 || from_corner <= 2 * std::abs(turned) + 1e-14));
    }
    return contact.points.size();
  };
  for (const double size : {0.01, 0.5, 30.0})
  {
    for (const double sign : {-1.0, 0.0, 1.0})
    {
      CAPTURE(size, sign);
      CHECK(points(size, sign * 1e-10) == 4);
      CHECK(points(size, sign * 1e-8) == (sign == 0 ? 4 : 6));
    }
  }
}
// [world_tolerance]

// [warm_points]
TEST_CASE("a point of a contact keeps what is known of it as long as its feature is there")
{
  const SceneBody below = box_body("below", {0.5, 0.5, 0.5}, {0, 0, 0});
  SceneBody above = box_body("above", {0.5, 0.4, 0.3}, {0.2, 0.899, 0.1});
  WorldContact contact;
  BoxDraw draw(5);
  int changed = 0, parted = 0, given = 0;
  for (int frame = 0; frame < 1000; ++frame)
  {
    above.orientation = rotation_by<double>(draw.vector(-0.01, 0.01) + V(0, 0.1 * frame, 0));
    above.position.y() = 0.899 + (frame % 100 == 99 ? 1 : 0);
    std::map<std::uint32_t, double> before;
    for (WorldPoint& point : contact.points)
    {
      point.impulse = before[point.feature] = ++given;
      point.friction = {-point.impulse, 0, 0};
      point.solved = true;
    }
    const RigidBody a = rigid_body(below), b = rigid_body(above);
    std::visit(UpdateContact{contact, a, b, {0.01, 0.01}}, below.shape, above.shape);
    int kept = 0, fresh = 0;
    for (const WorldPoint& point : contact.points)
    {
      const auto known = before.find(point.feature);
      const double impulse = known == before.end() ? 0 : known->second;
      CHECK(point.impulse == impulse);
      CHECK(point.friction == V(-impulse, 0, 0));
      CHECK(point.solved == (impulse > 0));
      (impulse > 0 ? kept : fresh) += 1;
    }
    parted += contact.points.empty() ? 1 : 0;
    changed += kept > 0 && fresh > 0 ? 1 : 0;
  }
  CHECK(changed >= 60); // it turns 16 times, and some point comes or goes in every quarter
  CHECK(parted == 10);
}
// [warm_points]

TEST_CASE("a slanted box of 1 m is as deep in a plane as its deepest corner, whichever that is")
{
  BoxDraw draw(3);
  for (int i = 0; i < 100; ++i)
  {
    const Obb<double> box{{0, 0.5, 0}, draw.rotation(), V::Constant(0.5)};
    const auto manifold = manifold_of(Plane<double>{{0, 1, 0}, 0}, box);
    REQUIRE(manifold);
    CHECK(manifold->depth == Catch::Approx(box_radius<double>(box, {0, 1, 0}) - 0.5));
  }
}

// [rolls]
/// How fast [m/s] a ball ends that starts at 7 m/s without spin, and how fast its surface turns.
std::pair<double, double> rolled(const std::string& solver, bool on_box, double radius)
{
  Scene scene = named_scene("rolling");
  if (on_box)
  {
    scene.bodies[0].shape = BoxShape{{30, 1, 30}};
    scene.bodies[0].position.y() = -1;
  }
  scene.bodies[1].shape = SphereShape{radius};
  scene.bodies[1].position.y() = radius;
  const BodyState end = run_world(scene, {.solver = solver}).frames.back().bodies[1];
  return {end.velocity.x(), -end.angular_velocity.z() * radius};
}

TEST_CASE(
    "balls of 2 m to 2 mm slide at 7 m/s until they roll at 5, on a plane and on a box", "[R27]")
{
  for (const std::string& solver : solver_names())
  {
    for (const bool on_box : {false, true})
    {
      for (const double radius : {2.0, 0.25, 0.02, 0.002})
      {
        if (solver != "position_based")
        {
          CAPTURE(solver, on_box, radius);
          const auto [speed, turning] = rolled(solver, on_box, radius);
          // Float rounds each of the some hundred pushes that stop the slide.
          const double rounding = solver == "wide_steps" ? 1e-5 : 1e-9;
          CHECK(speed == Catch::Approx(5).epsilon(rounding));
          CHECK(turning == Catch::Approx(5).epsilon(rounding));
        }
      }
    }
  }
}

TEST_CASE(
    "corrected positions roll by chords, sin φ for φ a small step, and lose a ball of 2 mm",
    "[R27]")
{
  for (const double radius : {2.0, 0.25, 0.02})
  {
    CAPTURE(radius);
    const auto [speed, turning] = rolled("position_based", false, radius);
    const double angle = turning / radius / 1200; // of a small step
    CHECK(turning / speed == Catch::Approx(angle / std::sin(angle)).epsilon(1e-9));
    CHECK(speed + 0.4 * turning == Catch::Approx(7).epsilon(1e-3 * angle * angle + 1e-9));
  }
  CHECK(rolled("position_based", false, 0.002).first < 3);
}
// [rolls]
