/// \file
/// What holds for sequential impulses: formulas R7 to R10, how fast they come, cold and warm.

#include "06_world/position_based/trial/solvers_cases.hpp"
#include "06_world/scenes/trial/motion_scenes.hpp"
#include "06_world/sequential_impulses/sequential_impulses.hpp"
#include "06_world/sequential_impulses/trial/sequential_impulses_pitfalls.hpp"
#include "06_world/sequential_impulses/trial/sequential_impulses_scenes.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <numbers>
#include <vector>

using namespace cookbook;

namespace
{

using Fractions = Eigen::VectorX<Rational>;

/// A unit cube of 1 kg that lands flat at 1 m/s: its four corners in turn, by hand. A push at one
/// corner moves it by 4, its neighbours by 1, the one opposite by −2.
template <class Real>
PushProblem<Real> landing_cube()
{
  PushProblem<Real> problem{Eigen::MatrixX<Real>(4, 4), Eigen::VectorX<Real>(4)};
  for (int i = 0; i < 4; ++i)
  {
    problem.speeds(i) = Real(-1);
    for (int j = 0; j < 4; ++j)
    {
      problem.response(i, j) = Real(i == j ? 4 : (i + j) % 2 == 1 ? 1 : -2);
    }
  }
  return problem;
}

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
TEST_CASE("a cube's corners get 1/4, 3/16, 21/64, 51/256 N s in the first pass", "[R7]")
{
  Fractions impulses = Fractions::Zero(4);
  correct_in_turn(landing_cube<Rational>(), impulses);
  CHECK(impulses(0) == Rational(1) / 4);
  CHECK(impulses(1) == Rational(3) / 16);
  CHECK(impulses(2) == Rational(21) / 64);
  CHECK(impulses(3) == Rational(51) / 256);
  // The third has got too much: its corner parts.
  CHECK(landing_cube<Rational>().speed(impulses, 2) == Rational(51) / 256);
}

TEST_CASE("sums that stay above zero stop the cube; changes that do leave it hopping", "[R7]")
{
  const PushProblem<double> cube = landing_cube<double>();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(4), wrong = right;
  for (int pass = 0; pass < 100; ++pass)
  {
    correct_in_turn(cube, right);
    correct_by_pushes_only(cube, wrong);
  }
  CHECK(residual(cube, right) < 1e-12);
  CHECK(right.sum() == Catch::Approx(1).epsilon(1e-12)); // 1 kg at 1 m/s
  CHECK(wrong.sum() > 1.03);
  CHECK(residual(cube, wrong) > 0.06);
}

TEST_CASE("the upper of two boxes is taken away: a sum gives 1 N s back, a change cannot", "[R7]")
{
  const PushProblem<Rational> alone = column<Rational>({1}, 1);
  Fractions remembered = Fractions::Constant(1, Rational(2)), kept = remembered;
  correct_in_turn(alone, remembered);
  correct_by_pushes_only(alone, kept);
  CHECK(remembered(0) == 1);
  CHECK(alone.speed(remembered, 0) == 0);
  CHECK(alone.speed(kept, 0) == 1); // it jumps, as fast as gravity would have had it fall
}

TEST_CASE("bodies get the same impulses as the equations do: four balls, 1 to 50 passes", "[R7]")
{
  const std::vector<double> masses{1, 3, 0.5, 2};
  const PushProblem<double> problem = column(masses, 9.81 / 60);
  Eigen::VectorXd impulses = Eigen::VectorXd::Zero(4);
  for (int passes = 1; passes <= 50; ++passes)
  {
    correct_in_turn(problem, impulses);
    GameWorld world(ball_tower(masses), impulse_method(false, passes).solver());
    world.step();
    REQUIRE(world.contacts().size() == 4);
    for (Eigen::Index i = 0; i < 4; ++i)
    {
      const double sum = world.contacts()[static_cast<std::size_t>(i)].points[0].impulse;
      CHECK(sum == Catch::Approx(impulses(i)).epsilon(1e-12));
    }
  }
}
// [R7]

// [R8]
TEST_CASE("r kg on 1 kg: each pass leaves exactly r / (1 + r) of the error", "[R8]")
{
  for (const int r : {1, 10, 100})
  {
    const PushProblem<Rational> problem = column<Rational>({1, r}, 1);
    Fractions impulses = Fractions::Zero(2);
    Rational error = r;
    for (int pass = 0; pass < 20; ++pass)
    {
      correct_in_turn(problem, impulses);
      error *= Rational(r) / (1 + r);
      CHECK(r - impulses(1) == error);
    }
  }
}

TEST_CASE("to 0.1 %, r = 1, 10, 100 take 10, 73, 695 passes: ln 1000 / ln((1 + r)/r)", "[R8]")
{
  for (const auto& [ratio, passes] : {std::pair(1.0, 10), {10.0, 73}, {100.0, 695}})
  {
    CHECK(passes == std::ceil(std::log(1000) / std::log((1 + ratio) / ratio)));
    CHECK(passes_needed({1, ratio}, 1e-3) == passes);
  }
}

TEST_CASE("n equal boxes: cos²(π/2n) of the error stays, for n = 2 to 20", "[R8]")
{
  const auto ones = [](int n) { return std::vector<double>(std::size_t(n), 1.0); };
  for (const auto& [n, passes] : {std::pair(2, 7), {5, 47}, {10, 192}, {15, 435}, {20, 776}})
  {
    const double cosine = std::cos(std::numbers::pi / (2 * n));
    CHECK(error_factor(ones(n), 3000) == Catch::Approx(cosine * cosine).epsilon(1e-5));
    CHECK(passes_needed(ones(n), 0.01) == passes);
  }
}

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
TEST_CASE("boxes of 1, 2, 3 kg on each other press with 6, 5, 3 kg: then all is at rest", "[R9]")
{
  const Fractions impulses = carrying_impulses<Rational>({1, 2, 3}, Rational(1) / 6);
  CHECK(impulses(0) == 1);
  CHECK(impulses(1) == Rational(5) / 6);
  CHECK(impulses(2) == Rational(1) / 2);
  const PushProblem<Rational> problem = column<Rational>({1, 2, 3}, Rational(1) / 6);
  CHECK(residual(problem, impulses) == 0);
}

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
TEST_CASE("a residual is the speed that the next correction would change, and 0 at rest", "[R10]")
{
  const PushProblem<Rational> one = column<Rational>({2}, 3);
  const auto off = [&](const Rational& impulse)
  { return residual<Rational>(one, Fractions::Constant(1, impulse)); };
  CHECK(off(6) == 0);               // 2 kg at 3 m/s
  CHECK(off(4) == 1);               // closes at 1 m/s
  CHECK(off(7) == Rational(1) / 2); // parts at 0.5 m/s, though pressed
  PushProblem<Rational> parting = one;
  parting.speeds(0) = 5;
  CHECK(residual<Rational>(parting, Fractions::Zero(1)) == 0); // parts, and nothing presses
  CHECK(residual<Rational>(parting, Fractions::Constant(1, Rational(1))) == Rational(1) / 2);
}

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

TEST_CASE("five cubes: the residual of the solver falls below 1e-5 m/s with passes", "[R10][long]")
{
  GameWorld world(scenes::tower(5), impulse_method(true, 100).solver());
  for (int frame = 0; frame < 300; ++frame)
  {
    world.step();
  }
  std::vector<RigidBody> bodies = world.bodies();
  std::vector<WorldContact> contacts = world.contacts();
  std::vector<IslandPoint> room;
  const IslandView view{bodies, contacts, world.scene().gravity, room};
  Islands islands;
  islands.find(bodies, contacts);
  const Island island = islands[0];
  const SequentialSettings settings{.warm = false};
  std::vector<SequentialPoint> points = sequential_points(view, island, 1.0 / 60, settings);
  // Nothing carries yet: the lowest cube falls onto the ground at g h.
  CHECK(complementarity_residual(points) == Catch::Approx(9.81 / 60).epsilon(1e-2));
  for (int pass = 0; pass < 2000; ++pass)
  {
    velocity_pass(points);
  }
  CHECK(complementarity_residual(points) < 1e-5);
}
// [R10]

// [warm]
TEST_CASE("cold, two boxes sink for ever at g h ρ^s / (1 − ρ^s): with 8 passes g h / 255", "[R8]")
{
  const PushProblem<Rational> problem = column<Rational>({1, 1}, 1);
  Fractions speeds(2);
  speeds << -Rational(1) / 255, Rational(0);
  const ColumnFrame<Rational> sinking{speeds, Fractions::Zero(2)};
  CHECK(next_column_frame(problem, sinking, 8, false).speeds == speeds);
}

TEST_CASE("warm, the speed after a frame is ρ^s (2 v − v of the frame before): it dies", "[R8]")
{
  const PushProblem<Rational> problem = column<Rational>({1, 10}, 1);
  const Rational share = Rational(1000) / 1331; // three passes with 10/11
  const Fractions zero = Fractions::Zero(2);
  ColumnFrame<Rational> before{zero, zero};
  ColumnFrame<Rational> now = next_column_frame(problem, before, 3, true);
  for (int frame = 0; frame < 12; ++frame)
  {
    const ColumnFrame<Rational> next = next_column_frame(problem, now, 3, true);
    CHECK(next.speeds(0) == share * (2 * now.speeds(0) - before.speeds(0)));
    before = now;
    now = next;
  }
}

TEST_CASE("ten cubes at 8 passes a frame: cold they fall by 4 s, warm by 15 s", "[case:S2][long]")
{
  const auto falls = [](const ContactMethod& method)
  { return stack_measures(scenes::tower(10), method.solver(), 20).fell; };
  const double cold = falls(impulse_method(false, 8)), warm = falls(impulse_method(true, 8));
  CHECK((cold > 0 && cold < 4));
  CHECK((warm > cold && warm < 15));
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
