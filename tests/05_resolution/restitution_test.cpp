/// \file
/// What holds for restitution in time steps: formula R19, and which moment's speed is given back.

#include "05_resolution/restitution/restitution.hpp"
#include "05_resolution/restitution/trial/restitution_cases.hpp"
#include "05_resolution/restitution/trial/restitution_pitfalls.hpp"
#include "05_resolution/restitution/trial/restitution_scenes.hpp"
#include "tools/exact/exact.hpp"

#include "tests/05_resolution/meetings.hpp"
#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <cmath>
#include <limits>

using namespace cookbook;

namespace
{

/// The rule of that name.
BounceRule rule(const std::string& name)
{
  for (const BounceRule& one : bounce_rules())
  {
    if (one.name == name)
    {
      return one;
    }
  }
  throw std::invalid_argument("no rule " + name);
}

/// By hand: how high a ball comes that falls from rest, where the first step that ends inside the
/// floor leaves it with `speed`, of the true speed there, and its depth there.
template <class Speed>
double apex_by_hand(const Drop& drop, const Speed& speed)
{
  const double g = drop.gravity;
  const double time = drop.step * std::ceil(std::sqrt(2 * drop.height / g) / drop.step);
  const double depth = g * time * time / 2 - drop.height;
  const double up = speed(g * time);
  return up * up / (2 * g) - depth;
}

} // namespace

// [R19]
TEMPLATE_TEST_CASE(
    "5 m/s at the touch, 4 when 0.45 m above, 6 when 0.55 m below: g = 10, e = 1", "[R19]", float,
    double)
{
  const TestType tenth = TestType(0.1), half = TestType(0.5);
  const ContactStep<TestType> above{-10, tenth, TestType(-0.45)};
  const ContactStep<TestType> below{-10, tenth, TestType(0.55)};
  const TestType some = 16 * std::numeric_limits<TestType>::epsilon();
  // The step's gravity, 1 m/s, is in the speeds; half of it too much.
  CHECK(std::abs(impact_speed(-4 - half, above) - 5) <= some);
  CHECK(std::abs(impact_speed(-6 - half, below) - 5) <= some);
  CHECK(std::abs(rebound_speed<TestType>(-4 - half, above, 1, 2) - (4 - half)) <= some);
  CHECK(std::abs(rebound_speed<TestType>(-6 - half, below, 1, 2) - (6 - half)) <= some);
}

TEST_CASE("with e = 0 a ball comes up to the touch and no further: 3 m/s for 0.45 m", "[R19]")
{
  const ContactStep<double> step{-10, 0.1, 0.45};
  // 4 at the touch, 5 at that depth.
  CHECK(rebound_speed(-5.5, step, 0.0, 2.0) == Catch::Approx(2.5).epsilon(10 * rounding));
  CHECK(rebound_speed(-4.5, {-10, 0.1, 0.0}, 0.0, 2.0) == 0);
}

TEST_CASE("no touch where surfaces part, and where the fall is too short for the depth", "[R19]")
{
  CHECK(impact_speed(-0.5, ContactStep<double>{-10, 0.1, 0}) == 0);
  CHECK(impact_speed(3.0, ContactStep<double>{-10, 0.1, 0.2}) == 0);
  CHECK(impact_speed(-1.0, ContactStep<double>{-10, 0.1, 0.2}) == 0);
  CHECK(rebound_speed(-1.0, ContactStep<double>{-10, 0.1, 0.2}, 1.0, 0.0) == 0);
}

TEST_CASE("two balls that fall together bounce as if nothing fell", "[R19]")
{
  const ContactStep<double> step{0, 0.1, 0.25};
  CHECK(impact_speed(-3.0, step) == 3);
  CHECK(rebound_speed(-3.0, step, 0.5, 1.0) == 1.5);
}

TEST_CASE("at 60 Hz what touches at 0.327 m/s or slower rests, what is faster bounces", "[R19]")
{
  const double threshold = restitution_threshold(9.81, 1.0 / 60);
  CHECK(threshold == Catch::Approx(0.327).epsilon(rounding));
  const auto up = [&](double touch)
  {
    const double half = 9.81 / 120;
    return rebound_speed(-touch - half, ContactStep<double>{-9.81, 1.0 / 60, 0}, 0.8, threshold) +
           half;
  };
  CHECK(up(0.326) == 9.81 / 120);
  CHECK(up(0.328) == Catch::Approx(0.8 * 0.328).epsilon(10 * rounding));
}

TEST_CASE("from 5 m with g = 10 and e = 1/2: 1 s down, then 1 + 1/2 + 1/4 + … = 2 s", "[R19]")
{
  CHECK(settling_time(5.0, 10.0, 0.5) == Catch::Approx(3).epsilon(rounding));
  CHECK(settling_time(1.0, 9.81, 0.8) == Catch::Approx(4.0637).epsilon(1e-5));
  double sum = std::sqrt(2 / 9.81), flight = 2 * sum;
  for (int bounce = 0; bounce < 400; ++bounce)
  {
    flight *= 0.8;
    sum += flight;
  }
  CHECK(settling_time(1.0, 9.81, 0.8) == Catch::Approx(sum).epsilon(1e-13));
}
// [R19]

// [with_separating_velocity]
TEST_CASE("50 exact pairs part at 3/2 m/s after one push, and keep their momenta", "[R3][R5]")
{
  RandomMeetings random;
  for (int i = 0; i < 50; ++i)
  {
    const RandomMeeting meeting = random.next();
    const Rational target = Rational(3) / 2;
    const BodyPair<Rational> after =
        with_separating_velocity<Rational>(meeting.bodies, meeting.normal, meeting.point, target);
    CHECK(meeting.separating_velocity_of(after) == target);
    CHECK(meeting.sums(after).momentum == meeting.sums(meeting.bodies).momentum);
    CHECK(meeting.sums(after).angular_momentum == meeting.sums(meeting.bodies).angular_momentum);
    const BodyPair<Rational> same =
        with_separating_velocity<Rational>(after, meeting.normal, meeting.point, Rational(1));
    CHECK(same.a.motion.velocity == after.a.motion.velocity);
  }
}

TEST_CASE("two immovable bodies are pushed to no speed, and stay", "[R5]")
{
  const Vector3<double> zero = Vector3<double>::Zero();
  const BodyPair<double> fixed{static_body(zero), static_body(zero)};
  const BodyPair<double> after = with_separating_velocity<double>(fixed, {0, 1, 0}, zero, 1.0);
  CHECK(after.a.motion.velocity == zero);
  CHECK(after.b.motion.velocity == zero);
}
// [with_separating_velocity]

// [S15]
TEST_CASE("e = 0.5 from 1 m: 0.25 and 0.0625 m to rounding, whatever the step", "[case:S15]")
{
  for (const double rate : {30.0, 60.0, 77.0, 1000.0})
  {
    const Drop drop{1, 0.5, 2, 1 / rate};
    const std::vector<double> high = apexes(flight(drop, rule("at the touch")), 9.81);
    CHECK(high.at(0) == Catch::Approx(0.25).epsilon(1e-12));
    CHECK(high.at(1) == Catch::Approx(0.0625).epsilon(1e-11));
  }
}

TEST_CASE("given back a step late or early: 1.26 m and 1.14 m where 1.25 is right", "[case:S15]")
{
  const Drop drop{5, 0.5, 3};
  const double half = drop.gravity * drop.step / 2;
  const auto first = [&](const std::string& name)
  { return apexes(flight(drop, rule(name)), drop.gravity).at(0); };
  const double late = apex_by_hand(drop, [&](double v) { return 0.5 * (v + half) + half; });
  const double early = apex_by_hand(drop, [&](double v) { return 0.5 * (v - half) - half; });
  CHECK(first("after gravity") == Catch::Approx(late).epsilon(1e-12));
  CHECK(first("before gravity, as published") == Catch::Approx(early).epsilon(1e-12));
  CHECK((late > 1.26 && early < 1.14));
}
// [S15]

// [S16]
TEST_CASE("e = 1 for 20 s: the energy stays to 1e-12, at 30 to 1000 Hz", "[case:S16]")
{
  for (const double rate : {30.0, 60.0, 77.0, 1000.0})
  {
    const Drop drop{1, 1, 20, 1 / rate};
    const std::vector<Flight> rows = flight(drop, rule("at the touch, threshold"));
    CHECK(double(rows.size()) >= 20 * rate);
    CHECK(std::abs(energy_change(rows, drop.gravity)) <= 1e-12);
  }
}

TEST_CASE(
    "e = 1: each bounce after gravity gains a step of it, before gravity loses one", "[case:S16]")
{
  // The true speed at the start of a step is the step's speed less half of its gravity.
  const ContactStep<double> step{-10, 0.125, 0.3};
  const double half = 0.625, down = -4;
  CHECK(rebound_after_gravity(down - half, 1.0, 0.0) + half == 4 + 1.25);
  CHECK(rebound_before_gravity(down - half, step, 1.0) + half == 4 - 1.25);
  CHECK(rebound_speed(down - half, step, 1.0, 0.0) + half == 4);
  const Drop drop{1, 1, 20};
  CHECK(energy_change(flight(drop, rule("after gravity")), drop.gravity) > 1.5);
  CHECK(apexes(flight(drop, rule("before gravity, as published")), drop.gravity).back() < 0.2);
}
// [S16]

// [S17]
TEST_CASE("e = 0.8 from 1 m rests by 4.56 s, at any rate of steps, and stays", "[case:S17]")
{
  for (const double rate : {30.0, 60.0, 77.0, 240.0, 1000.0})
  {
    const Drop drop{1, 0.8, 20, 1 / rate};
    const std::vector<Flight> rows = flight(drop, rule("at the touch, threshold"));
    INFO(rate << " " << last_move(rows));
    CHECK(last_move(rows) <= 4.0637 + 0.5);
    CHECK(last_move(rows) >= 4.0637 - 0.5);
    // A touch at no more than two steps of gravity goes no deeper than two and a half in a step.
    CHECK(std::abs(rows.back().height) <= 2.5 * 9.81 / (rate * rate));
  }
}

TEST_CASE("after gravity, e = 0.8 never falls below 4 steps of gravity: no rest", "[case:S17]")
{
  // u = 0.8 (u + g h) for u = 4 g h, twice the threshold.
  const double pull = 9.81 / 60;
  const double threshold = restitution_threshold(9.81, 1.0 / 60);
  CHECK(
      rebound_after_gravity(-5 * pull, 0.8, threshold) ==
      Catch::Approx(4 * pull).epsilon(rounding));
  const std::vector<Flight> rows = flight({1, 0.8, 60}, rule("after gravity, threshold"));
  CHECK(last_move(rows) == rows.back().time);
}
// [S17]

// [J8]
TEST_CASE("stopped at the floor in time, 10 m/s comes back as 10, unless forgotten", "[case:J8]")
{
  int lost_half = 0;
  for (int i = 0; i < 40; ++i)
  {
    Drop drop{5.0 + i / 100.0, 1, 3, 1.0 / 60, Speculative::stop_and_remember};
    const auto apex = [&]
    {
      const std::vector<double> high =
          apexes(flight(drop, rule("at the touch, threshold")), drop.gravity);
      return high.empty() ? 0 : high[0];
    };
    CHECK(apex() == Catch::Approx(drop.height).epsilon(1e-12));
    drop.speculative = Speculative::stop;
    lost_half += apex() < drop.height / 4 ? 1 : 0; // half the speed, a quarter of the height
  }
  INFO(lost_half);
  CHECK(lost_half >= 12);
}
// [J8]

TEST_CASE("what holds and what fails at drops", "[case:S15][case:S16][case:S17][case:J8]")
{
  check_verdicts(
      drop_verdicts(), names_of(bounce_rules()),
      {{"S15", {"at the touch", "at the touch, threshold"}},
       {"e = 0.5 from 5 m: up to 1.25, 0.3125 m", {"at the touch", "at the touch, threshold"}},
       {"S16", {"at the touch", "at the touch, threshold"}},
       {"S17", {"at the touch, threshold"}},
       {"e = 0.5 from 1 m: rests by 1.355 + 0.5 s",
        {"after gravity, threshold", "at the touch", "at the touch, threshold"}},
       {"J8", {}},
       {"the same, and the speed remembered", {"at the touch", "at the touch, threshold"}}});
}
