/// \file
/// What holds for the small world's contacts as one system of equations, and where it stops.

#include "05_resolution/plain_direct/plain_direct.hpp"
#include "05_resolution/plain_positions/trial/plain_scenes.hpp"
#include "05_resolution/small_world/step_7.hpp"
#include "tests/catch.hpp"

#include <random>

using Catch::Approx;
using namespace cookbook;
using namespace cookbook::small_world;
using plain_direct::World;

// [loads]
TEST_CASE("each cube of a tower of ten carries what is above it, to a billionth", "[R9][long]")
{
  World world = tower<World>(10);
  run(world, 5);
  for (std::size_t below = 0; below < 10; ++below)
  {
    const double load = impulse_between(world, below, below + 1) / frame;
    REQUIRE(load == Approx(9.81 * (10.0 - static_cast<double>(below))).epsilon(1e-9));
  }
}

TEST_CASE("1,000 kg on 1 kg stands under the direct solver, and not under step 7", "[R9]")
{
  World world = heavy_on_light<World>(1000);
  REQUIRE(largest_sink(world, 10) < 0.0003);
  REQUIRE_FALSE(stands(largest_sink(heavy_on_light<step_7::World>(1000), 10)));
  run(world, 10);
  REQUIRE(impulse_between(world, 0, 1) / frame == Approx(9.81 * 1001).epsilon(1e-6));
  REQUIRE(impulse_between(world, 1, 2) / frame == Approx(9.81 * 1000).epsilon(1e-6));
}
// [loads]

// [compliance]
TEST_CASE("a compliance of a millionth presses 1 kg under m in by 5e-6 m g h² on either side")
{
  for (const double mass : {300.0, 1000.0})
  {
    World world = heavy_on_light<World>(mass);
    run(world, 0.5);
    const double sink = 1.5 - world.bodies[2].motion.center.y();
    const double pressed = 1e-5 * mass * 9.81 * frame * frame;
    REQUIRE(sink == Approx(2 * plain_direct::slop + pressed).epsilon(0.01));
  }
  // Here it stops: more than twice the 27 mm that the compliance alone would give.
  REQUIRE(largest_sink(heavy_on_light<World>(1e6), 10) > 2 * 1e-5 * 1e6 * 9.81 * frame * frame);
}
// [compliance]

// [friction]
TEST_CASE("under the direct solver a cube slides as Coulomb says within 1 %, or stays", "[R28]")
{
  for (const double degrees : {20.0, 25.0, 35.0})
  {
    REQUIRE(
        distance_gone(slope<World>(degrees, 0.3), 3) ==
        Approx(right_slide(degrees, 0.3, 3)).epsilon(0.01));
  }
  REQUIRE(distance_gone(slope<World>(10, 0.3), 3) < 0.0002);
  REQUIRE(distance_gone(slope<World>(16, 0.3), 3) < 0.0002);
}

TEST_CASE("under the direct solver a cube stops after v² / (2 μ g), less half a step", "[R29]")
{
  for (const double friction : {0.1, 0.3, 0.5})
  {
    World world = slope<World>(0, friction);
    world.bodies.back().motion.velocity = {6, 0, 8};
    const double right = 100 / (2 * friction * 9.81) - 0.5 * 10 * frame;
    REQUIRE(distance_gone(world, 12) == Approx(right).epsilon(1e-3));
  }
}
// [friction]

// [active_set]
TEST_CASE("an active set finds impulses within bounds whose speeds press nowhere", "[R10]")
{
  std::mt19937 random(1);
  const auto next = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  for (int trial = 0; trial < 200; ++trial)
  {
    const auto fill = [&](double) { return next(); };
    const Eigen::MatrixXd root = Eigen::MatrixXd::Zero(12, 8).unaryExpr(fill);
    Eigen::MatrixXd A = root * root.transpose(); // redundant: rank 8 of 12
    A.diagonal() *= 1 + 1e-6;
    const Eigen::VectorXd b = Eigen::VectorXd::Zero(12).unaryExpr(fill);
    const plain_direct::Bounds bounds{
        Eigen::VectorXd::Constant(12, -1), Eigen::VectorXd::Constant(12, 2)};
    std::vector<plain_direct::State> states(12, plain_direct::State::free);
    const Eigen::VectorXd x = plain_direct::solve_within(A, b, bounds, states);
    const Eigen::VectorXd speeds = A * x + b;
    const Eigen::VectorXd wanted = (x - speeds).cwiseMax(bounds.low).cwiseMin(bounds.high);
    REQUIRE((x - wanted).cwiseAbs().maxCoeff() < 1e-8); // the residual of all conditions at once
  }
}
// [active_set]

TEST_CASE("bounds of zero hold a row, and passes in turn come close where a set would cycle")
{
  const Eigen::MatrixXd A = Eigen::Matrix2d{{2, 1}, {1, 2}};
  const Eigen::VectorXd b = Eigen::Vector2d(-3, -3);
  const plain_direct::Bounds held{Eigen::Vector2d(0, 0), Eigen::Vector2d(9, 0)};
  std::vector<plain_direct::State> states(2, plain_direct::State::free);
  const Eigen::VectorXd x = plain_direct::solve_within(A, b, held, states);
  REQUIRE(x[0] == Approx(1.5));
  REQUIRE(x[1] == 0);
  const plain_direct::Bounds wide{Eigen::Vector2d(0, 0), Eigen::Vector2d(9, 9)};
  const Eigen::VectorXd y = plain_direct::solve_in_turn(A, b, wide);
  REQUIRE(y[0] == Approx(1));
  REQUIRE(y[1] == Approx(1));
}

TEST_CASE("a cube that starts 40 cm in the ground comes out and does not hop")
{
  World world = ground<World>();
  add(world, cube({0, 0.1, 0}));
  for (int i = 0; i < 120; ++i)
  {
    step(world, frame);
    REQUIRE(world.bodies[1].motion.center.y() < 0.5);
  }
  REQUIRE(world.bodies[1].motion.center.y() == Approx(0.5).margin(0.0002));
}

TEST_CASE("piles under the direct solver stay over the ground and fall alike twice", "[long]")
{
  for (const unsigned seed : {1U, 2U})
  {
    World world = pile<World>(seed), again = pile<World>(seed);
    for (int i = 0; i < 120; ++i)
    {
      step(world, frame);
      step(again, frame);
      REQUIRE(is_sane(world));
    }
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
    {
      REQUIRE(world.bodies[i].motion.center == again.bodies[i].motion.center);
    }
  }
}
