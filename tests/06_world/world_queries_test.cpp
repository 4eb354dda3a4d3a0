/// \file
/// What a ray meets in a world and what a shape overlaps: by the tree, and by asking every body.

#include "05_resolution/tunnelling/swept_sphere.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/world_inputs.hpp"
#include "06_world/game_world/world_queries.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"

#include <limits>
#include <optional>
#include <variant>
#include <vector>

using namespace cookbook;

namespace
{

/// A pile after two seconds, one body of it taken out.
GameWorld settled_pile()
{
  GameWorld world(named_scene("pile_60"), solver_named("soft_steps"));
  while (world.time() < 2)
  {
    world.step();
  }
  world.remove(7);
  return world;
}

/// The same as WorldQueries, by asking every body.
std::optional<BodyHit> cast_at_all(const GameWorld& world, const Ray<double>& ray)
{
  std::optional<BodyHit> first;
  for (std::size_t i = 0; i < world.bodies().size(); ++i)
  {
    const auto hit = std::visit(
        [&](const auto& shape) { return cast(ray, placed(world.bodies()[i], shape)); },
        world.scene().bodies[i].shape);
    if (world.has(i) && hit && (!first || hit->t < first->hit.t))
    {
      first = BodyHit{i, *hit};
    }
  }
  return first;
}

} // namespace

// [world_queries]
TEST_CASE("rays at a pile meet what they meet when every body is asked")
{
  const GameWorld world = settled_pile();
  const WorldQueries queries(world);
  BoxDraw draw(3);
  int met = 0;
  for (int i = 0; i < inputs(2000, 100); ++i)
  {
    const Ray<double> ray{draw.vector(-6, 6), draw.direction()};
    const auto wanted = cast_at_all(world, ray), found = queries.cast(ray);
    REQUIRE(found.has_value() == wanted.has_value());
    if (found)
    {
      REQUIRE((found->body == wanted->body && found->hit.t == wanted->hit.t));
      met += found->body > 0 ? 1 : 0;
    }
  }
  CHECK(met > inputs(100, 5));
}

TEST_CASE("balls moved into a pile meet what they meet when every body is asked")
{
  const GameWorld world = settled_pile();
  const WorldQueries queries(world);
  BoxDraw draw(7);
  int met = 0;
  for (int i = 0; i < inputs(2000, 100); ++i)
  {
    const Sphere<double> sphere{draw.vector(-6, 6), draw.between(0.01, 1)};
    const Vector3<double> way = draw.between(0, 12) * draw.direction();
    std::optional<SphereHit> wanted;
    for (std::size_t j = 0; j < world.bodies().size(); ++j)
    {
      const RigidBody& body = world.bodies()[j];
      std::optional<SweptHit<double>> hit;
      if (const auto* box = std::get_if<BoxShape>(&world.scene().bodies[j].shape))
      {
        hit = swept_sphere_box(sphere, way, placed(body, *box));
      }
      else if (const auto* plane = std::get_if<PlaneShape>(&world.scene().bodies[j].shape))
      {
        hit = swept_sphere_plane(sphere, way, placed(body, *plane));
      }
      if (world.has(j) && hit && (!wanted || hit->time < wanted->hit.time))
      {
        wanted = SphereHit{j, *hit};
      }
    }
    const auto found = queries.cast(sphere, way);
    REQUIRE(found.has_value() == wanted.has_value());
    if (found)
    {
      REQUIRE((found->body == wanted->body && found->hit.time == wanted->hit.time));
      REQUIRE(found->hit.normal == wanted->hit.normal);
      met += found->body > 0 ? 1 : 0;
    }
  }
  CHECK(met > inputs(200, 10));
}

TEST_CASE("balls and boxes in a pile overlap what they overlap when every body is asked")
{
  const GameWorld world = settled_pile();
  const WorldQueries queries(world);
  BoxDraw draw(5);
  for (int i = 0; i < inputs(500, 25); ++i)
  {
    const Sphere<double> sphere{draw.vector(-3, 3), draw.between(0.1, 1)};
    std::vector<BodyId> wanted;
    for (std::size_t j = 0; j < world.bodies().size(); ++j)
    {
      const bool meets = std::visit(
          [&](const auto& shape) { return overlaps(placed(world.bodies()[j], shape), sphere); },
          world.scene().bodies[j].shape);
      if (meets && world.has(j))
      {
        wanted.push_back(j);
      }
    }
    REQUIRE(queries.overlapping(sphere) == wanted);
  }
}

TEST_CASE("a ray down on a tower meets the top at 1.5 m, and the ground once it is cleared away")
{
  GameWorld world(named_scene("tower_2"), solver_named("direct"));
  const Ray<double> down{{0.1, 3.5, 0.2}, {0, -2, 0}};
  const auto top = WorldQueries(world).cast(down);
  REQUIRE(top);
  CHECK((top->body == 2 && top->hit.t == 0.75));
  CHECK(top->hit.normal == Vector3<double>(0, 1, 0));
  const Obb<double> around{{0, 1, 0}, Matrix3<double>::Identity(), {0.1, 0.2, 0.1}};
  CHECK(WorldQueries(world).overlapping(around) == std::vector<BodyId>{1, 2});
  world.remove(1);
  world.remove(2);
  CHECK(WorldQueries(world).cast(down)->body == 0);
  CHECK(WorldQueries(world).cast(down)->hit.t == 1.75);
  CHECK_FALSE(WorldQueries(world).cast({{0, 1, 0}, {0, 1, 0}}));
  CHECK(WorldQueries(world).overlapping(around).empty());
}

TEST_CASE("a ball of 0.25 m let down on a tower stops at 5/8 of its way, and is not met beside it")
{
  Scene scene = named_scene("tower_2");
  scene.bodies.push_back(ball_body("ball", 0.5, {3, 0.5, 0}));
  const GameWorld world(scene, solver_named("direct"));
  const WorldQueries queries(world);
  const Sphere<double> above{{0.1, 3.5, 0.2}, 0.25};
  const auto top = queries.cast(above, {0, -2, 0}); // from 3.5 down to 2.25
  REQUIRE(top);
  CHECK((top->body == 2 && top->hit.time == 0.625));
  CHECK(top->hit.normal == Vector3<double>(0, -1, 0));
  CHECK_FALSE(queries.cast(above, {0, -1.24, 0})); // it ends a centimetre above
  CHECK_FALSE(queries.cast(above, {0, 2, 0}));     // away from all
  CHECK_FALSE(queries.cast(above, {0, 0, 0}));     // nowhere
  CHECK(queries.cast({{0.1, 1.9, 0}, 0.25}, {0, -1, 0})->hit.time == 0); // in it, and deeper
  // Along the top at y = 2: a centimetre too low it meets the side, a centimetre higher it goes by.
  CHECK(queries.cast({{-3, 2.24, 0}, 0.25}, {6, 0, 0})->body == 2);
  CHECK_FALSE(queries.cast({{-3, 2.26, 0}, 0.25}, {6, 0, 0}));
  // Two balls touch with their centres 3/4 m apart: of the 3 m from 1.5 m away, 0.75 are free.
  const auto other = queries.cast({{4.5, 0.5, 0}, 0.25}, {-3, 0, 0});
  REQUIRE(other);
  CHECK((other->body == 3 && other->hit.time == 0.25));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(queries.cast(above, {0, nan, 0}), InvalidShape);
}

TEST_CASE(
    "a ray and a ball go through bodies that are not asked, and through those taken out since")
{
  GameWorld world(named_scene("tower_2"), solver_named("direct"));
  const WorldQueries queries(world);
  const Vector3<double> eye(0.1, 3.5, 0.2), down(0, -2, 0);
  const Sphere<double> above{eye, 0.25};
  const auto not_top = [](BodyId body) { return body != 2; };
  CHECK(queries.cast({eye, down}, not_top)->body == 1);
  CHECK(queries.cast({eye, down}, not_top)->hit.t == 1.25);
  CHECK_FALSE(queries.cast({eye, down}, [](BodyId) { return false; }));
  CHECK(queries.cast(above, down)->body == 2);
  CHECK_FALSE(queries.cast(above, down, not_top)); // it ends at 1.25 m
  CHECK(queries.cast(above, {0, -4, 0}, not_top)->body == 1);
  CHECK(queries.overlapping(Sphere<double>{{0, 1, 0}, 0.25}) == std::vector<BodyId>{1, 2});
  world.remove(2);
  CHECK(queries.cast({eye, down})->body == 1);
  CHECK_FALSE(queries.cast(above, down));
  CHECK(queries.overlapping(Sphere<double>{{0, 1, 0}, 0.25}) == std::vector<BodyId>{1});
}

// [shot]
TEST_CASE("a shot past oneself meets the tower, and an explosion beside it throws what is near")
{
  GameWorld world(named_scene("tower_2"), solver_named("direct"));
  const BodyId player = world.add(ball_body("player", 0.5, {3, 0.5, 0}));
  const Vector3<double> eye = world.body(player).motion.center, forward(-1, 0, 0);

  const WorldQueries queries(world);
  const auto met = queries.cast({eye, forward}, [&](BodyId body) { return body != player; });
  CHECK(met->body == 1);

  const Vector3<double> center = eye + met->hit.t * forward;
  for (const BodyId body : queries.overlapping(Sphere<double>{center, 1.2}))
  {
    apply_impulse(world, body, 20 * (world.body(body).motion.center - center).normalized());
  }
  CHECK(world.body(1).motion.velocity.x() < 0);
  CHECK(world.body(2).motion.velocity.y() > 0);
  CHECK(world.body(player).motion.velocity.isZero()); // too far away
}
// [shot]

TEST_CASE("a ray without a direction and a ball that is not a number are refused by name")
{
  const GameWorld world(named_scene("tower_2"), solver_named("direct"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(WorldQueries(world).cast({{0, 1, 0}, {nan, 1, 0}}), InvalidShape);
  CHECK_THROWS_AS(WorldQueries(world).overlapping(Sphere<double>{{0, 0, 0}, nan}), InvalidShape);
  CHECK_THROWS_AS(WorldQueries(world).cast({{0, 1, 0}, -1}, {0, 1, 0}), InvalidShape);
}
// [world_queries]
