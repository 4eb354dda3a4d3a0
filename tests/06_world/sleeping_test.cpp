/// \file
/// What holds for islands, for rules that put bodies to sleep, and for what wakes them.

#include "06_world/sleeping/sleeping.hpp"
#include "06_world/sleeping/trial/sleeping_cases.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace cookbook;

namespace
{

using Pairs = std::vector<std::pair<int, int>>;

/// The lowest number that each body can reach, by going from body to body until nothing changes.
std::vector<int> reached(const std::vector<bool>& movable, const Pairs& pairs)
{
  std::vector<int> lowest(movable.size());
  for (std::size_t i = 0; i < movable.size(); ++i)
  {
    lowest[i] = movable[i] ? static_cast<int>(i) : -1;
  }
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const auto& [a, b] : pairs)
    {
      int& at_a = lowest[static_cast<std::size_t>(a)];
      int& at_b = lowest[static_cast<std::size_t>(b)];
      if (at_a != at_b && at_a >= 0 && at_b >= 0)
      {
        at_a = at_b = std::min(at_a, at_b);
        changed = true;
      }
    }
  }
  return lowest;
}

/// The recommended rule, and what it is told of a body that moves along x.
const SleepLimits<double> limits;

SleepState<double> watched_at(const SleepState<double>& state, double speed)
{
  return update_sleep_state<double>(state, {speed, 0, 0}, {0, 0, 0}, 0.5, sleep_step, limits);
}

/// A body that has been at rest for half a second.
SleepState<double> rested()
{
  SleepState<double> state;
  state.time_at_rest = 0.5;
  return state;
}

} // namespace

// [islands]
TEST_CASE("two towers on one ground are two islands, and a ball beside them a third")
{
  const std::vector<bool> movable{false, true, true, true, true, true};
  const Pairs touching{{0, 2}, {2, 5}, {1, 0}, {4, 1}, {0, 3}};
  CHECK(islands(movable, touching) == std::vector<int>{-1, 1, 2, 3, 1, 2});
  CHECK(islands({}, Pairs{}).empty());
  CHECK(islands({true, false}, Pairs{}) == std::vector<int>{0, -1});
}

TEST_CASE("of 500 heaps each has the islands that walking finds, in any order of its contacts")
{
  std::mt19937 random(1);
  for (int heap = 0; heap < 500; ++heap)
  {
    const std::size_t count = 1 + random() % 30;
    std::vector<bool> movable(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      movable[i] = random() % 6 != 0;
    }
    Pairs pairs(random() % (count + 5));
    for (auto& [a, b] : pairs)
    {
      a = static_cast<int>(random() % count);
      b = static_cast<int>(random() % count);
    }
    const std::vector<int> truth = reached(movable, pairs);
    REQUIRE(islands(movable, pairs) == truth);
    std::reverse(pairs.begin(), pairs.end());
    for (auto& [a, b] : pairs)
    {
      std::swap(a, b);
    }
    REQUIRE(islands(movable, pairs) == truth);
  }
}
// [islands]

// [sleep_state]
TEST_CASE("a body at rest may sleep after 30 steps of 1/60 s, or 31, not sooner")
{
  SleepState<double> state;
  for (int i = 0; i < 29; ++i)
  {
    state = watched_at(state, 0);
    CHECK(!may_sleep(state, limits));
  }
  state = watched_at(watched_at(state, 0), 0);
  CHECK(may_sleep(state, limits));
}

TEST_CASE("the watch begins anew above 5 cm/s, after 2 mm, and where 5 mm/s have changed")
{
  CHECK(watched_at(rested(), 0.004).time_at_rest > 0.5);
  CHECK(watched_at(rested(), 0.006).time_at_rest == 0);
  SleepState<double> quick = rested();
  quick.velocity = {0.0499, 0, 0};
  CHECK(watched_at(quick, 0.0499).time_at_rest > 0.5);
  quick.velocity = {0.0501, 0, 0};
  CHECK(watched_at(quick, 0.0501).time_at_rest == 0);
  SleepState<double> gone = rested();
  gone.displacement = 0.00199;
  CHECK(watched_at(gone, 0.0005).time_at_rest > 0.5); // a step of it is 8 µm
  CHECK(watched_at(gone, 0.0007).time_at_rest == 0);  // and 12 µm
}

TEST_CASE("turning counts with the radius: 0.01 rad/s at 0.5 m is 5 mm/s")
{
  const auto turning = [](double speed)
  {
    return update_sleep_state<double>(rested(), {0, 0, 0}, {0, speed, 0}, 0.5, sleep_step, limits)
        .time_at_rest;
  };
  CHECK(turning(0.009) > 0.5);
  CHECK(turning(0.011) == 0);
}

TEST_CASE("a velocity that is not a number never sleeps")
{
  SleepState<double> state = rested();
  for (int i = 0; i < 100; ++i)
  {
    state = watched_at(state, std::numeric_limits<double>::quiet_NaN());
    CHECK(!may_sleep(state, limits));
  }
  // It rests again once its velocity is a number again.
  for (int i = 0; i < 33; ++i)
  {
    state = watched_at(state, 0);
  }
  CHECK(may_sleep(state, limits));
}
// [sleep_state]

// [L1]
TEST_CASE(
    "a thrown ball is slower than 5 cm/s for 10.2 ms, one that rolls up 1° for 0.818 s",
    "[case:L1]")
{
  CHECK(2 * 0.05 / sleep_gravity == Catch::Approx(0.0102).margin(5e-5));
  CHECK(2 * 0.05 / rolling_deceleration(1) == Catch::Approx(0.818).margin(5e-4));
  const std::vector<WatchedMotion> motions = watched_motions();
  const std::vector<SleepRule> rules = sleep_rules();
  // Thrown up at 0.3 g, it stands still after 0.3 s.
  CHECK(falls_asleep(motions[0], rules[0]) == Catch::Approx(0.3).margin(1e-9));
  CHECK(!falls_asleep(motions[0], rules[1]));
  // Below 5 cm/s from 0.25 m/s over the deceleration on; half a second and two steps later it
  // sleeps.
  const double slow = 0.25 / rolling_deceleration(1);
  const double asleep = falls_asleep(motions[1], rules[1]).value_or(0);
  CHECK(asleep >= slow + 0.5);
  CHECK(asleep <= slow + 0.5 + 2.001 * sleep_step);
  CHECK(!falls_asleep(motions[1], rules[2]));
}

TEST_CASE(
    "still and steady, balls that roll up 0.045° or more come back; up 0.03° one does not",
    "[case:L1]")
{
  // Centre and spin change by 2 · 5/7 g sin(slope) a second: 5 mm/s in half a second at 0.0409°.
  const double least = std::asin(0.005 / 0.5 / 2 * 7 / 5 / sleep_gravity);
  CHECK(least * 180 / std::numbers::pi == Catch::Approx(0.0409).margin(1e-4));
  const SleepRule rule = sleep_rules()[2];
  for (const double slope : {0.045, 0.05, 0.1, 0.3, 1.0, 3.0, 10.0})
  {
    for (const double speed : {0.06, 0.1, 0.3, 1.0})
    {
      CHECK(!falls_asleep(rolling_up("", "", slope, speed), rule));
    }
  }
  CHECK(falls_asleep(rolling_up("", "", 0.03, 0.1), rule));
}
// [L1]

// [L2]
TEST_CASE(
    "towers of 2 to 30 cubes begin to fall in the step after their lowest cube is removed",
    "[case:L2]")
{
  for (int cubes = 2; cubes <= 30; ++cubes)
  {
    CHECK(steps_until_all_fall(cubes, Waking::island) == 1);
  }
  // One neighbour of the lowest cube is all that is left of a tower of two.
  CHECK(steps_until_all_fall(2, Waking::neighbours) == 1);
  CHECK(steps_until_all_fall(3, Waking::neighbours) == 0);
  CHECK(steps_until_all_fall(3, Waking::nothing) == 0);
}

TEST_CASE("a body wakes its own island and no other", "[case:L2]")
{
  const std::vector<int> island_of{-1, 1, 2, 1, 2};
  SleepState<double> asleep = rested();
  asleep.asleep = true;
  std::vector<SleepState<double>> states(5, asleep);
  wake(states, island_of, 3);
  CHECK((states[0].asleep && states[2].asleep && states[4].asleep));
  CHECK((!states[1].asleep && !states[3].asleep));
  CHECK(states[1].time_at_rest == 0);
  wake(states, island_of, 0);
  CHECK((states[2].asleep && states[4].asleep));
  const std::vector<int> hit{0, 4};
  wake<double>(states, island_of, hit);
  CHECK((states[0].asleep && !states[2].asleep && !states[4].asleep));
}

TEST_CASE("an island sleeps when its last body may, and wakes when an awake one touches it")
{
  const std::vector<int> separation{0, 0, 2}, together{0, 0, 0};
  std::vector<SleepState<double>> states{rested(), SleepState<double>{}, rested()};
  update_sleep(states, separation, limits);
  CHECK((!states[0].asleep && !states[1].asleep && states[2].asleep));
  CHECK(states[0].time_at_rest == 0.5); // it waits for the other
  states[1] = rested();
  update_sleep(states, separation, limits);
  CHECK((states[0].asleep && states[1].asleep && states[2].asleep));
  states[2] = {};
  update_sleep(states, separation, limits);
  CHECK((states[0].asleep && states[1].asleep && !states[2].asleep));
  update_sleep(states, together, limits);
  CHECK((!states[0].asleep && !states[1].asleep && states[0].time_at_rest == 0));
}
// [L2]

// [L4]
TEST_CASE("a ball with e = 0.39 or 0.8 sleeps within 6 s, if bounces of 2 g dt end it", "[case:L4]")
{
  const SleepRule rule = sleep_rules()[2];
  const double threshold = 2 * sleep_gravity * sleep_step;
  for (const double restitution : {0.0, 0.39, 0.5, 0.8})
  {
    const auto asleep = bounces_out(restitution, threshold, rule);
    REQUIRE(asleep);
    // Bounces that go on for ever are over after √(2 H / g) (1 + e) / (1 − e); then half a second.
    const double zeno = std::sqrt(2 / sleep_gravity) * (1 + restitution) / (1 - restitution);
    CHECK(asleep->time <= zeno + 0.5 + 3 * sleep_step);
    CHECK(asleep->time <= 6);
    CHECK(asleep->height == 0);
  }
  CHECK(!bounces_out(0.39, 0, rule));
  CHECK(!bounces_out(0.8, 0, rule));
}
// [L4]

TEST_CASE("which rule puts which bodies to sleep", "[case:L1][case:L4]")
{
  check_verdicts(
      sleep_verdicts(), names_of(sleep_rules()),
      {{"L1", {"slow for 0.5 s", "slow, still, steady"}},
       {"rolls up 1°, and back", {"slow, still, steady"}},
       {"rolls up 0.1°, and back", {"slow, still, steady"}},
       {"rolls up 0.03°, and back", {}},
       {"swings by 1 cm on 1 m", {"slow, still, steady"}},
       {"crawls at 4 cm/s", {"slow, still, steady"}},
       {"turns at 0.5 rad/s", {"slow, still, steady"}},
       {"rests, and trembles by 1 mm/s", {"slow", "slow for 0.5 s", "slow, still, steady"}},
       {"L4", {"slow for 0.5 s", "slow, still, steady"}},
       {"bounces out, e = 0.8, threshold", {"slow for 0.5 s", "slow, still, steady"}},
       {"e = 0.39, every bounce answered", {"slow for 0.5 s"}},
       {"e = 0.8, every bounce answered", {}}});
}

TEST_CASE("what wakes a tower", "[case:L2]")
{
  for (const VerdictRow& row : waking_verdicts())
  {
    INFO(row.what);
    CHECK(!row.verdicts[0].holds); // nothing wakes
    CHECK(!row.verdicts[1].holds); // neighbours wake
    CHECK(row.verdicts[2].holds);  // the island wakes
  }
}
