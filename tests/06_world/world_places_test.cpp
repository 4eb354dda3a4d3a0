/// \file
/// Bodies that come and go: a body in a reused slot is another one, in the same
/// room.

#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/world_queries.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <algorithm>
#include <deque>
#include <set>
#include <string>
#include <vector>

using namespace cookbook;

namespace
{

void on(GameWorld& world, int steps)
{
  for (int i = 0; i < steps; ++i)
  {
    world.step();
  }
}

/// A spinning cube that is thrown up.
SceneBody thrown(const std::string& name)
{
  SceneBody body = cube_body(name, {0.1, 1.5, 0});
  body.velocity = {0.2, 2, 0};
  body.angular_velocity = {1, 2, -1};
  return body;
}

/// A cube that has rested on the ground at place 1, and is taken out; beside it stays another.
GameWorld one_has_left(const std::string& solver, bool may_sleep)
{
  const Scene scene{
      .bodies = {ground(), cube_body("former", {0, 0.5, 0}), cube_body("other", {5, 0.5, 0})}};
  GameWorld world(scene, solver_named(solver), may_sleep);
  on(world, 120);
  world.remove(1);
  return world;
}

} // namespace

// [come_and_go]
TEST_CASE("thousands of bodies that come and go, fifty at a time, take the room of fifty")
{
  GameWorld world({.bodies = {ground()}}, solver_named("direct"), true);
  std::deque<BodyId> there;
  std::set<BodyId> ever{0};
  for (int i = 0; i < inputs(3600, 200); ++i)
  {
    const double aside = i % 25;
    const SceneBody body =
        i % 3 == 0 ? ball_body("ball", 0.2, {aside, 2, 0}) : cube_body("cube", {aside, 2, 0});
    there.push_back(world.add(body));
    CHECK(ever.insert(there.back()).second);
    CHECK(world.scene().bodies[world.index(there.back())].name == body.name);
    if (there.size() > 50)
    {
      world.remove(there.front());
      CHECK_FALSE(world.has(there.front()));
      there.pop_front();
    }
    on(world, 10);
  }
  CHECK(world.bodies().size() == 52); // with the ground, and those not removed when the next came
  CHECK(world.has(there.front()));
  CHECK(world.bodies().size() < there.front());
}

TEST_CASE("a body in a slot that was another's goes on as in a new one, to the bit")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const bool may_sleep : {false, true})
    {
      CAPTURE(solver, may_sleep);
      GameWorld world = one_has_left(solver, may_sleep);
      on(world, 1);
      GameWorld other = world;
      other.add(box_body("wall", {1, 1, 1}, {-50, 0, 0}, 0)); // has the slot of a removed one
      const BodyId at_old = world.add(thrown("next")), at_new = other.add(thrown("next"));
      CHECK(world.index(at_old) == 1);
      CHECK(other.index(at_new) == 3);
      CHECK(world.scene().bodies[1].position == Vector3<double>(0.1, 1.5, 0));
      for (int i = 0; i < 240; ++i)
      {
        on(world, 1);
        on(other, 1);
        const RigidBody &old = world.body(at_old), &fresh = other.body(at_new);
        CHECK(old.motion.center == fresh.motion.center);
        CHECK(old.motion.velocity == fresh.motion.velocity);
        CHECK(old.orientation.coeffs() == fresh.orientation.coeffs());
        CHECK(world.is_asleep(at_old) == other.is_asleep(at_new));
        CHECK(world.is_asleep(2) == other.is_asleep(2));
        CHECK(world.body(2).motion.center == other.body(2).motion.center);
      }
    }
  }
}

TEST_CASE("a body put on a sleeping one wakes it, also in the slot of another")
{
  GameWorld world = one_has_left("direct", true);
  on(world, 1);
  REQUIRE(world.is_asleep(2));
  const BodyId next = world.add(cube_body("next", {5, 1.499, 0}));
  CHECK(world.index(next) == 1);
  CHECK_FALSE(world.is_asleep(2));
  CHECK_FALSE(world.is_asleep(next));
}

TEST_CASE("a place is given on after a step, and its ids differ")
{
  GameWorld world = one_has_left("direct", false);
  CHECK(world.add(thrown("at once")) == 3);
  CHECK(world.scene().bodies.size() == 4);
  CHECK(world.id(1) == 1);
  on(world, 2);
  const BodyId next = world.add(thrown("later"));
  CHECK(next == (BodyId(1) << 32 | 1));
  CHECK(world.index(next) == 1);
  CHECK(world.id(1) == next);
  CHECK(world.add(thrown("in a row")) == 4);
  CHECK_FALSE(world.has(1));
  CHECK_FALSE(world.has(BodyId(2) << 32 | 1)); // whose turn has not come
  using Catch::Matchers::ContainsSubstring;
  CHECK_THROWS_WITH(world.body(1), ContainsSubstring("no body 1 any more: it was taken out"));
  CHECK_THROWS_WITH(world.body(BodyId(2) << 32 | 1), ContainsSubstring("no body 8589934593"));
  CHECK_THROWS_WITH(world.id(5), ContainsSubstring("no body 5"));
  GameWorld copy = world;
  world.remove(next);
  copy.remove(next);
  on(world, 1);
  on(copy, 1);
  CHECK(world.add(thrown("third")) == copy.add(thrown("third")));
}

TEST_CASE("a body that passed through the ground leaves nothing of that to the next in its slot")
{
  GameWorld world({.bodies = {ground(), cube_body("ghost", {0, 3, 0})}}, solver_named("direct"));
  world.ignore(0, 1);
  on(world, 60);
  CHECK(world.body(1).motion.center.y() < -1);
  world.remove(1);
  on(world, 1);
  const BodyId next = world.add(cube_body("next", {0, 1, 0}));
  CHECK(world.index(next) == 1);
  on(world, 120);
  CHECK(world.body(next).motion.center.y() == Catch::Approx(0.5).margin(1e-3));
}

TEST_CASE("a solver that found no answer for a removed body is as new for the next in its slot")
{
  const auto slid = [](const std::vector<SceneBody>& bodies)
  {
    GameWorld world({.bodies = bodies}, solver_named("direct"));
    on(world, 21);
    if (world.has(1))
    {
      world.remove(1);
    }
    on(world, 1);
    SceneBody crate = box_body("crate", {0.2, 0.2, 0.2}, {0, 0.2, 0}, 5);
    crate.velocity.x() = 3;
    const BodyId id = world.add(crate);
    on(world, 180);
    return world.body(id).motion.center.x();
  };
  SceneBody tumbles = box_body("tumbles", {0.3, 0.1, 0.2}, {0, 0.4, 0}, 5);
  tumbles.orientation = {1, 0.5, 0.3, 0.2};
  tumbles.velocity = {3, -4, 1};
  tumbles.angular_velocity = {8, -5, 6};
  CHECK(slid({ground(), tumbles}) == slid({ground()}));
}

TEST_CASE("rays, overlaps and contacts name the body that is in a slot now")
{
  GameWorld world = one_has_left("direct", false);
  on(world, 1);
  const BodyId next = world.add(cube_body("next", {0, 0.5, 0}));
  on(world, 30);
  const WorldQueries asked(world);
  const Ray<double> down{{0, 5, 0}, {0, -1, 0}};
  CHECK(asked.cast(down)->body == next);
  CHECK(asked.cast(down, [&](BodyId id) { return id != next; })->body == 0);
  CHECK(asked.overlapping(Sphere<double>{{0, 0.5, 0}, 0.1}) == std::vector<BodyId>{next});
  const auto of_next = [&](const WorldContact& contact)
  { return world.id(index_of(contact.b)) == next; };
  CHECK(std::any_of(world.contacts().begin(), world.contacts().end(), of_next));
  world.remove(next);
  CHECK(asked.cast(down)->body == 0);
}
// [come_and_go]
