/// \file
/// What a ray meets in a world and what a shape overlaps: by the tree, and by asking every body.

#include "05_resolution/scenes/trial/scene_bodies.hpp"
#include "05_resolution/scenes/trial/world_scenes.hpp"
#include "05_resolution/world/solvers.hpp"
#include "05_resolution/world/world_queries.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"

#include <limits>

using namespace cookbook;

namespace
{

/// A pile after two seconds, one body of it taken out.
World settled_pile()
{
  World world(named_scene("pile_60"), solver_named("soft_steps"));
  while (world.time() < 2)
  {
    world.step();
  }
  world.remove(7);
  return world;
}

/// The same as WorldQueries, by asking every body.
std::optional<BodyHit> cast_at_all(const World& world, const Ray<double>& ray)
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
  const World world = settled_pile();
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

TEST_CASE("balls and boxes in a pile overlap what they overlap when every body is asked")
{
  const World world = settled_pile();
  const WorldQueries queries(world);
  BoxDraw draw(5);
  for (int i = 0; i < inputs(500, 25); ++i)
  {
    const Sphere<double> ball{draw.vector(-3, 3), draw.between(0.1, 1)};
    std::vector<std::size_t> wanted;
    for (std::size_t j = 0; j < world.bodies().size(); ++j)
    {
      const bool meets = std::visit(
          [&](const auto& shape) { return overlaps(placed(world.bodies()[j], shape), ball); },
          world.scene().bodies[j].shape);
      if (meets && world.has(j))
      {
        wanted.push_back(j);
      }
    }
    REQUIRE(queries.overlapping(ball) == wanted);
  }
}

TEST_CASE("a ray down on a tower meets the top at 1.5 m, and the ground once it is cleared away")
{
  World world(named_scene("tower_2"), solver_named("direct"));
  const Ray<double> down{{0.1, 3.5, 0.2}, {0, -2, 0}};
  const auto top = WorldQueries(world).cast(down);
  REQUIRE(top);
  CHECK((top->body == 2 && top->hit.t == 0.75));
  CHECK(top->hit.normal == Vector3<double>(0, 1, 0));
  const Obb<double> around{{0, 1, 0}, Matrix3<double>::Identity(), {0.1, 0.2, 0.1}};
  CHECK(WorldQueries(world).overlapping(around) == std::vector<std::size_t>{1, 2});
  world.remove(1);
  world.remove(2);
  CHECK(WorldQueries(world).cast(down)->body == 0);
  CHECK(WorldQueries(world).cast(down)->hit.t == 1.75);
  CHECK_FALSE(WorldQueries(world).cast({{0, 1, 0}, {0, 1, 0}}));
  CHECK(WorldQueries(world).overlapping(around).empty());
}

TEST_CASE("a ray without a direction and a ball that is not a number are refused by name")
{
  const World world(named_scene("tower_2"), solver_named("direct"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(WorldQueries(world).cast({{0, 1, 0}, {nan, 1, 0}}), InvalidShape);
  CHECK_THROWS_AS(WorldQueries(world).overlapping(Sphere<double>{{0, 0, 0}, nan}), InvalidShape);
}
// [world_queries]
