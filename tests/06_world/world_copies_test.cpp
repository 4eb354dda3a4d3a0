/// \file
/// A copied world is a world of its own: saved, run on, restored and run again it gives the same
/// bits, and worlds that were given one solver do not disturb each other.

#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "06_world/game_world/solver_names.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <algorithm>
#include <string>
#include <vector>

using namespace cookbook;

namespace
{

/// Boxes and balls at random that fall on each other.
Scene falling(int seed)
{
  BoxDraw draw(static_cast<std::uint32_t>(seed));
  Scene scene;
  scene.bodies.push_back(ground());
  for (int i = 0; i < 10; ++i)
  {
    SceneBody body = box_body(numbered("body", i), draw.vector(0.1, 0.4), {0, 0, 0});
    if (i % 3 == 0)
    {
      body.shape = SphereShape{draw.between(0.1, 0.4)};
    }
    body.position = Vector3<double>(0, i + 0.5, 0) + draw.vector(0, 0.3);
    body.orientation = Quaternion<double>(draw.rotation());
    body.velocity = draw.vector(-2, 2);
    body.restitution = draw.whole(2) * 0.3;
    scene.bodies.push_back(body);
  }
  return scene;
}

void run(GameWorld& world, int steps)
{
  for (int i = 0; i < steps; ++i)
  {
    world.step();
  }
}

bool same_bits(const GameWorld& a, const GameWorld& b)
{
  return std::equal(
      a.bodies().begin(), a.bodies().end(), b.bodies().begin(),
      [](const RigidBody& one, const RigidBody& other)
      {
        return one.motion.center == other.motion.center &&
               one.motion.velocity == other.motion.velocity &&
               one.orientation.coeffs() == other.orientation.coeffs() &&
               one.motion.angular_velocity == other.motion.angular_velocity;
      });
}

} // namespace

// [copies]
TEST_CASE("save, 60 steps, restore, 60 steps: the same bits, for 50 scenes under five solvers")
{
  for (int seed = 0; seed < inputs(50, 3); ++seed)
  {
    const std::string solver =
        solver_names()[static_cast<std::size_t>(seed) % solver_names().size()];
    CAPTURE(seed, solver);
    GameWorld world(falling(seed), solver_named(solver), seed % 2 == 0);
    run(world, 60);
    const GameWorld saved = world;
    run(world, 60);
    GameWorld restored = saved;
    run(restored, 60);
    CHECK(same_bits(world, restored));
    // And once more, taken back in place.
    const GameWorld once = world;
    world = saved;
    run(world, 60);
    CHECK(same_bits(world, once));
  }
}

TEST_CASE("two worlds that were given one solver are what they are alone, for 50 scenes")
{
  for (int seed = 0; seed < inputs(50, 3); ++seed)
  {
    const std::string solver =
        solver_names()[static_cast<std::size_t>(seed) % solver_names().size()];
    CAPTURE(seed, solver);
    const WorldSolver shared = solver_named(solver);
    GameWorld alone(falling(seed), solver_named(solver));
    GameWorld one(falling(seed), shared), other(falling(seed + 50), shared);
    for (int i = 0; i < 120; ++i)
    {
      alone.step();
      one.step();
      other.step();
    }
    CHECK(same_bits(alone, one));
  }
}
// [copies]
