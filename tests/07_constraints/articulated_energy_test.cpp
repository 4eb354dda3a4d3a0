/// \file
/// Trees of links through time: energy, momentum, and the steps that a loaded chain needs.

#include "07_constraints/articulated/trial/articulated_scenes.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <numbers>
#include <vector>

using namespace cookbook;

// [energy_60]
TEST_CASE("two links from 57°: RK4 keeps their energy to 1e-7 for 60 s at 240 Hz", "[R52][long]")
{
  const SwingScene scene{{.links = 2}, 1};
  const EnergyKept kept = energy_kept(scene, rk4_step, 240, 60);
  CHECK(kept.off <= 1e-7);
  CHECK(kept.off > 1e-8);
}

TEST_CASE("RK4's loss of energy falls by more than 16 where the step is halved", "[R52]")
{
  const SwingScene scene{{.links = 2}, 1};
  const double often = energy_kept(scene, rk4_step, 480, 5).left;
  CHECK(energy_kept(scene, rk4_step, 240, 5).left / often > 16);
}

TEST_CASE("semi-implicit Euler in joint coordinates gains a tenth of it at 240 Hz", "[R52]")
{
  CHECK_FALSE(energy_kept({{.links = 2}, 1}, semi_implicit_step, 240, 60).holds);
}
// [energy_60]

// [free_tree]
TEST_CASE(
    "a tree in space keeps energy and both momenta to 1e-9 for 1 s, with springs in it", "[R52]")
{
  NumberDraw<double> draw(5);
  std::vector<Link> links = drawn_links(draw, 10);
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    links[i].joint = i == 0 ? JointType::free : static_cast<JointType>(i % 5);
    links[i].parent = i == 0 ? -1 : static_cast<int>(i) / 2;
    links[i].stiffness = i % 5 == 1 || i % 5 == 2 ? 10 : 0;
    links[i].damping = 0;
  }
  links[5].parent = 2;
  ArticulatedBody tree(links, {0, 0, 0});
  TreeState state = drawn_state(draw, links);
  const TreeBalance before = balance_of(tree, state);
  for (int i = 0; i < 2000; ++i)
  {
    rk4_step(tree, state, 0.0005);
  }
  const TreeBalance after = balance_of(tree, state);
  CHECK(std::abs(after.energy - before.energy) <= 1e-9 * before.energy);
  CHECK((after.momentum - before.momentum).norm() <= 1e-9 * before.momentum.norm());
  CHECK(
      (after.angular_momentum - before.angular_momentum).norm() <=
      1e-9 * before.angular_momentum.norm());
}
// [free_tree]

// [R53]
TEST_CASE(
    "20 links under 100 and 1,000 kg hang with 2 and 4 steps a frame, not with 1 and 3", "[R53]")
{
  for (const auto& [load, enough] : {std::pair(100.0, 2), {1000.0, 4}})
  {
    const HangingChain chain{.load = load};
    CHECK(std::ceil(steps_needed(chain)) == enough);
    CHECK(hangs_still(chain, semi_implicit_step, enough));
    CHECK_FALSE(hangs_still(chain, semi_implicit_step, enough - 1));
  }
}

TEST_CASE("RK4, stable up to 2√2 instead of 2, needs 3 steps for 1,000 kg: not 2", "[R53]")
{
  const HangingChain chain{.load = 1000};
  CHECK(std::ceil(steps_needed(chain) / std::numbers::sqrt2) == 3);
  CHECK(hangs_still(chain, rk4_step, 3));
  CHECK_FALSE(hangs_still(chain, rk4_step, 2));
}
// [R53]

// [whip]
TEST_CASE(
    "20 links under 1,000 kg from 45° and 90° at 16 steps of RK4 a frame: energy to 1e-4", "[long]")
{
  for (const double angle : {std::numbers::pi / 4, std::numbers::pi / 2})
  {
    const EnergyKept kept = energy_kept({{.load = 1000}, angle}, rk4_step, 960, 1.5);
    CHECK(kept.off <= 1e-4);
  }
}

TEST_CASE(
    "at 8 semi-implicit ones from 45° to 0.2 % for 10 s; from 90° they end in a whip", "[long]")
{
  const SwingScene slow{{.load = 1000}, std::numbers::pi / 4};
  const SwingScene fast{{.load = 1000}, std::numbers::pi / 2};
  CHECK(energy_kept(slow, semi_implicit_step, 480, 10).off <= 0.002);
  CHECK_FALSE(energy_kept(fast, semi_implicit_step, 480, 10).holds);
}
// [whip]
