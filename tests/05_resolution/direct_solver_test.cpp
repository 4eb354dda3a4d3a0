/// \file
/// The direct solver: blocks against Eigen's dense solver, towers against statics, slopes against
/// closed forms.

#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "05_resolution/direct_solver/direct_solver.hpp"
#include "05_resolution/direct_solver/trial/direct_solver_scenes.hpp"

#include "tests/catch.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace
{

using namespace cookbook;

/// How long [s] scenes stand; sanitizers are too slow for all of it.
#if defined(COOKBOOK_FEWER_PAIRS)
constexpr double long_run = 3;
#else
constexpr double long_run = 20;
#endif

WorldRun directly(const std::string& scene, double duration)
{
  return run_world(named_scene(scene), {.duration = duration});
}

} // namespace

// [cholesky]
TEST_CASE("a factor of blocks solves 20 random systems of 12 bodies as a dense one does")
{
  BoxDraw draw(7);
  for (int round = 0; round < 20; ++round)
  {
    std::vector<std::pair<int, int>> coupled;
    for (int i = 1; i < 12; ++i)
    {
      coupled.emplace_back(draw.whole(i), i);
      coupled.emplace_back(i - 1, i);
    }
    BlockCholesky factor;
    factor.lay_out(12, coupled, 1000);
    factor.clear();
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(72, 72);
    for (int i = 0; i < 12; ++i)
    {
      factor.diagonal(i) = 40 * Matrix6::Identity();
      dense.block<6, 6>(6 * i, 6 * i) = 40 * Matrix6::Identity();
    }
    for (const auto& [i, j] : coupled)
    {
      const Matrix6 block =
          Matrix6::NullaryExpr([&](Eigen::Index, Eigen::Index) { return draw.between(-1, 1); });
      factor.add_coupling(i, j, block);
      dense.block<6, 6>(6 * i, 6 * j) += block;
      dense.block<6, 6>(6 * j, 6 * i) += block.transpose();
    }
    std::vector<Vector6> x(12);
    Eigen::VectorXd right(72);
    for (std::size_t i = 0; i < 12; ++i)
    {
      x[i] = Vector6::NullaryExpr([&](Eigen::Index) { return draw.between(-1, 1); });
      right.segment<6>(static_cast<Eigen::Index>(6 * i)) = x[i];
    }
    REQUIRE(factor.factor());
    factor.solve(x);
    const Eigen::VectorXd expected = dense.ldlt().solve(right);
    for (std::size_t i = 0; i < 12; ++i)
    {
      // Some hundred roundings of numbers of size one.
      CHECK((x[i] - expected.segment<6>(static_cast<Eigen::Index>(6 * i))).norm() <= 1e-13);
    }
  }
}

TEST_CASE("a block with a negative number on its diagonal has no factor")
{
  BlockCholesky factor;
  factor.lay_out(1, {}, 10);
  factor.clear();
  factor.diagonal(0) = Matrix6::Identity();
  factor.diagonal(0)(3, 3) = -1;
  CHECK_FALSE(factor.factor());
}
// [cholesky]

// [R9]
TEST_CASE("in towers of 10, 20 and 40 each cube carries what is above it, to 1e-6", "[R9]")
{
  for (const char* const tower : {"tower", "tower_20", "tower_40", "tower_turned_20"})
  {
    CHECK(statics_error(named_scene(tower), "direct", 300) <= 1e-6);
  }
}

TEST_CASE("1 kg carries 100 kg, 1000 kg and 10,000 kg, to 1e-6", "[R9]")
{
  for (const char* const scene :
       {"heavy_on_light_100", "heavy_on_light_1000", "heavy_on_light_10000"})
  {
    CHECK(statics_error(named_scene(scene), "direct", 300) <= 1e-6);
  }
}

TEST_CASE("with 8 passes of impulses, 1 kg under 100 kg carries less than it should", "[R9]")
{
  CHECK(statics_error(named_scene("heavy_on_light_100"), "sequential_impulses", 30) > 0.01);
}
// [R9]

// [stands]
TEST_CASE("all scenes that shall stand sink and drift by less than 0.1 mm in 20 s", "[case:S2]")
{
  for (const std::string& scene : standing_scenes)
  {
    CAPTURE(scene);
    const WorldRun run = directly(scene, long_run);
    CHECK(run.sink < 1e-4);
    CHECK(run.drift < 1e-4);
    CHECK(run.energy_most <= run.energy_start);
  }
}
// [stands]

TEST_CASE("a million to one on one kg: the light cube is pressed in by less than 1 mm", "[case:S6]")
{
  const WorldRun run = directly("heavy_on_light_1000000", 5);
  CHECK(run.sink < 1e-3);
  CHECK(run.residual < 1e-9);
}

// [R28]
TEST_CASE("a cube on 30° with μ = 0.5 slides with 0.65715 m/s², to 1e-6", "[R28]")
{
  // g (sin 30° − 0.5 cos 30°) with g = 9.81.
  const double wanted = 9.81 * (0.5 - 0.5 * std::sqrt(3.0) / 2);
  const WorldRun run = directly("incline", 2);
  const double speed = run.frames.back().bodies.back().velocity.norm();
  CHECK(speed == Catch::Approx(2 * wanted).epsilon(1e-6));
}
// [R28]
