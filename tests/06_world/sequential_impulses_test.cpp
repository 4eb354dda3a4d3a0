/// \file
/// What holds for sequential impulses in a world: formulas R7 to R10, with warm starting and
/// without.

#include "05_resolution/contact_constraint/trial/columns.hpp"
#include "06_world/contacts/start_body.hpp"
#include "06_world/position_based/trial/solvers_cases.hpp"
#include "06_world/scenes/trial/motion_scenes.hpp"
#include "06_world/sequential_impulses/sequential_impulses.hpp"
#include "06_world/sequential_impulses/trial/sequential_impulses_scenes.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <numbers>
#include <vector>

using namespace cookbook;

namespace
{

/// Balls of some masses one on top of the other.
Scene ball_tower(const std::vector<double>& masses)
{
  Scene scene = scenes::standing();
  for (std::size_t i = 0; i < masses.size(); ++i)
  {
    const double height = 0.5 + static_cast<double>(i);
    scene.bodies.push_back(ball_body(numbered("ball", int(i)), 0.5, {0, height, 0}, masses[i]));
  }
  return scene;
}

} // namespace

// [R7]
TEST_CASE(
    "a world gives a column the impulses of chapter 5's: four spheres, 1 to 50 passes", "[R7]")
{
  const std::vector<double> masses{1, 3, 0.5, 2};
  for (int passes = 1; passes <= 50; ++passes)
  {
    Column<double> column = column_of(masses);
    solve_frame(column, 9.81 / 60, passes, false);
    GameWorld world(ball_tower(masses), impulse_method(false, passes).solver());
    world.step();
    REQUIRE(world.contacts().size() == 4);
    for (std::size_t i = 0; i < 4; ++i)
    {
      const double sum = world.contacts()[i].points[0].impulse;
      CHECK(sum == Catch::Approx(column.contacts[i].impulse).epsilon(1e-12));
    }
  }
}
// [R7]

// [R8]
TEST_CASE("balls of r kg on 1 kg in a world: r / (1 + r) to a millionth", "[R8][case:S4]")
{
  for (const double r : {1.0, 10.0, 100.0})
  {
    const double right = r / (1 + r);
    CHECK(measured_factor(impulse_method(true, 8), r) == Catch::Approx(right).epsilon(1e-6));
    CHECK(measured_factor(position_method(1, 20), r) == Catch::Approx(right).epsilon(1e-6));
  }
}
// [R8]

// [R9]
TEST_CASE("a tower of five cubes: 5, 4, 3, 2, 1 times g h kg, to a billionth", "[R9][long]")
{
  GameWorld world(scenes::tower(5), impulse_method(true, 100).solver());
  for (int frame = 0; frame < 300; ++frame)
  {
    world.step();
  }
  REQUIRE(world.contacts().size() == 5);
  for (std::size_t i = 0; i < 5; ++i)
  {
    double sum = 0;
    for (const WorldPoint& point : world.contacts()[i].points)
    {
      sum += point.impulse;
    }
    CHECK(sum == Catch::Approx(9.81 / 60 * double(5 - i)).epsilon(1e-9));
  }
}
// [R9]

// [R10]
TEST_CASE("the solver's residual is the one of its impulse, or that of its speed, in m/s", "[R10]")
{
  SequentialPoint one{};
  RigidBody low = rigid_body(ground()), high = rigid_body(ball_body("ball", 0.5, {0, 0.5, 0}, 2));
  one.point.a = &low;
  one.point.b = &high;
  one.point.normal = {0, 1, 0};
  one.point.arms = {Vector3<double>::Zero(), {0, -0.5, 0}};
  one.point.normal_mass = 2;
  one.target = 1;
  const auto off = [&](double impulse, double speed)
  {
    one.point.impulse = impulse;
    high.motion.velocity = {0, speed, 0};
    return complementarity_residual({one});
  };
  CHECK(off(4, 6) == 2); // 4 N s could be taken back: 2 m/s
  CHECK(off(4, 2) == 1); // and do take back the last 1 m/s
  CHECK(off(4, 0) == 1); // too slow by 1 m/s
  CHECK(off(0, 6) == 0); // parts, and nothing presses
}

TEST_CASE(
    "five cubes: the residual is g h at first, and below 1e-5 m/s after 2,000 passes", "[R10]")
{
  const std::vector<double> all = residuals(5, 2000);
  CHECK(all.front() == Catch::Approx(9.81 / 60).epsilon(1e-2)); // the lowest cube falls
  CHECK(all.back() < 1e-5);
}
// [R10]

// [warm]
TEST_CASE("ten cubes at 8 passes a frame: cold they fall by 4 s, warm by 15 s", "[case:S2][long]")
{
  const auto falls = [](const ContactMethod& method)
  { return stack_measures(scenes::tower(10), method.solver(), 20).fell; };
  const double cold = falls(impulse_method(false, 8)),
               warm_starting = falls(impulse_method(true, 8));
  CHECK((cold > 0 && cold < 4));
  CHECK((warm_starting > cold && warm_starting < 15));
  CHECK(falls(impulse_method(true, 20)) == 0);
}

TEST_CASE(
    "a pass over the positions leaves four fifths of an overlap beyond the slop, and no speed")
{
  for (const int passes : {1, 3, 20})
  {
    Scene scene{.gravity = {0, 0, 0}};
    scene.bodies = {ground(), ball_body("ball", 0.5, {0, 0.44, 0})};
    const SequentialSettings settings{.position_iterations = passes};
    GameWorld world(
        scene, one_by_one([settings](IslandView view, const Island& island, double step)
                          { sequential_impulses(view, island, step, settings); }));
    world.step();
    const double left = 0.005 + (0.06 - 0.005) * std::pow(0.8, passes);
    CAPTURE(passes);
    CHECK(0.5 - world.bodies()[1].motion.center.y() == Catch::Approx(left).epsilon(1e-12));
    CHECK(world.bodies()[1].motion.velocity.norm() == 0);
  }
}

TEST_CASE(
    "100 kg on 1 kg: 64 passes and 4 over the positions stand where 20 fall", "[case:S5][long]")
{
  const SequentialSettings many{.iterations = 64, .position_iterations = 4};
  const IslandSolver solver = [many](IslandView world, const Island& island, double step)
  { sequential_impulses(world, island, step, many); };
  const StackMeasures most = stack_measures(scenes::heavy_on_light(100), solver, 10);
  CHECK(most.fell == 0);
  CHECK(most.sink < 0.02);
  CHECK(
      stack_measures(scenes::heavy_on_light(100), impulse_method(true, 20).solver(), 10).fell > 0);
}

TEST_CASE(
    "on 30° with friction 0.6, warm impulses hold a cube after 0.3 mm, and for 10 s to 0.1 µm",
    "[R7]")
{
  const Scene slope = scenes::incline(0.5, 0.6);
  GameWorld world(slope, impulse_method(true, 8).solver());
  const auto gone = [&]() -> Vector3<double>
  { return world.bodies()[1].motion.center - slope.bodies[1].position; };
  while (world.time() < 0.1)
  {
    world.step();
  }
  // Left to itself it would have slipped 25 mm by then.
  const Vector3<double> held = gone();
  CHECK(held.norm() < 3e-4);
  while (world.time() < 10)
  {
    world.step();
  }
  CHECK((gone() - held).norm() < 1e-7);
}
// [warm]
