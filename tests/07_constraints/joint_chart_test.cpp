/// \file
/// What holds for the chart of joints: every engine has the scene that ours have, and which hold a
/// nudged ton.

#include "07_constraints/joint_chart/trial/joint_chart.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace cookbook;

namespace
{

/// How far [mm] the joints of a nudged ton come apart in two seconds.
double ton_apart(const JointContender& contender)
{
  const JointedScene scene = nudged_chain(1000);
  const JointMethod method = contender.on(scene);
  return 1000 * stretch_of({method, contender.count}, scene, 120);
}

/// The contender with the number-th settings of a curve; none where its engine is not there.
std::vector<JointContender> one_of(const std::string& line, int number)
{
  std::vector<JointContender> found;
  for (const JointContender& one : joint_contenders())
  {
    if (one.line == line && one.number == number)
    {
      found.push_back(one);
    }
  }
  return found;
}

} // namespace

TEST_CASE("settings of a curve are numbered from zero, and no two are called the same", "[peers]")
{
  std::set<std::pair<std::string, std::string>> names;
  int number = 0;
  std::string line;
  for (const JointContender& one : joint_contenders())
  {
    CAPTURE(one.line, one.settings);
    CHECK(names.insert({one.line, one.settings}).second);
    number = one.line == line ? number + 1 : 0;
    line = one.line;
    CHECK(one.number == number);
  }
}

TEST_CASE(
    "three links let go at 45 degrees are after .2 s within 5 mm of where RK4 has them, in every "
    "engine",
    "[peers]")
{
  const JointedScene scene = chain_of({1, 5, 2}, std::sqrt(0.5), std::sqrt(0.5));
  ArticulatedBody tree(links_of(scene));
  TreeState state = zero_state(tree.links());
  const Quaternion<double> turn = scene.scene.bodies[1].orientation;
  state.positions.head<4>() << turn.w(), turn.x(), turn.y(), turn.z();
  for (int step = 0; step < 192; ++step)
  {
    rk4_step(tree, state, 1.0 / 960);
  }
  const std::vector<LinkBody> right = link_bodies(tree, state);
  for (const JointContender& one : joint_contenders())
  {
    if (one.line.starts_with("Bullet") || one.line.starts_with("ODE") || one.chains_only)
    {
      const bool steps = !one.line.ends_with("iterations") && one.number == 3;
      const JointMethod method = one.on(scene);
      Frame last;
      const auto look = [&](GameWorld& world) { last = frame_of(world); };
      REQUIRE(run_joints({method, 1}, scene, 12, look));
      for (std::size_t i = 0; steps && i < right.size(); ++i)
      {
        CAPTURE(one.line, one.settings, i);
        CHECK((last.bodies[i + 1].position - right[i].motion.center).norm() < 0.005);
        CHECK((last.bodies[i + 1].velocity - right[i].motion.velocity).norm() < 0.05);
        CHECK(
            (last.bodies[i + 1].angular_velocity - right[i].motion.angular_velocity).norm() < 0.3);
      }
    }
  }
}

// [nudged_ton]
TEST_CASE(
    "a nudged ton on 20 links: direct holds it within .25 mm; engines burst as they come, and hold "
    "it within .1 mm by four exact substeps",
    "[peers]")
{
  CHECK(ton_apart(one_of("direct", 0).at(0)) < 0.25);
  for (const std::string line : {"Bullet", "Bullet, Dantzig", "ODE, quick", "ODE, direct"})
  {
    for (const JointContender& as_it_comes : one_of(line, 0))
    {
      CAPTURE(line);
      CHECK(std::isinf(ton_apart(as_it_comes)));
    }
  }
  for (const std::string line : {"Bullet, Dantzig", "ODE, direct", "Bullet, multibody"})
  {
    for (const JointContender& exact : one_of(line, 1))
    {
      CAPTURE(line);
      CHECK(ton_apart(exact) < 0.1);
    }
  }
}
// [nudged_ton]

TEST_CASE("a contender that bursts is timed until then, for a turn at least")
{
  const JointContender bursts = one_of("sequential_impulses", 0).at(0);
  const JointContender holds = one_of("direct", 0).at(0);
  CHECK(frames_held(bursts, nudged_chain(1000), 120) < 120);
  CHECK(frames_held(holds, nudged_chain(1000), 20) == 20);
  const std::vector<double> costs = joint_costs({bursts, holds}, nudged_chain(1000), 4, 1);
  REQUIRE(costs.size() == 2);
  CHECK((costs[0] > 0 && costs[1] > 0));
}
