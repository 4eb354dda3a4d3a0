/// \file
/// What a world asks of memory: a scene that has settled steps without an allocation, and a body of
/// a heap takes so much.

#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/trial/counted_allocations.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include "tests/catch.hpp"

#include <string>

using namespace cookbook;

// [no_allocation]
TEST_CASE("once a turned tower, a pyramid or a pile has settled, a step allocates nothing")
{
  for (const std::string name : {"tower_turned", "pyramid", "pile_30"})
  {
    for (const std::string solver : {"soft_steps", "wide_steps", "direct"})
    {
      for (const bool may_sleep : {false, true})
      {
        CAPTURE(name, solver, may_sleep);
        GameWorld world(named_scene(name), solver_named(solver), may_sleep);
        while (world.time() < 5)
        {
          world.step();
        }
        for (const RigidBody& body : world.bodies())
        {
          REQUIRE(body.motion.velocity.norm() < 0.003); // a tower sways a little in small steps
        }
        const long before = counted_allocations();
        REQUIRE(before > 0);
        while (world.time() < 6)
        {
          world.step();
        }
        CHECK(counted_allocations() == before);
      }
    }
  }
}
// [no_allocation]

// [memory]
TEST_CASE("a body of a heap of 4,000 takes less than 2.15 kB, with all its contacts", "[long]")
{
  const Scene scene = named_scene("pile_4000");
  const long before = held_bytes();
  GameWorld world(scene, solver_named("wide_steps", 4));
  while (world.time() < 4.5)
  {
    world.step();
  }
  CHECK((held_bytes() - before) / 4000 < 2150);
}
// [memory]
