#pragma once

/// \file
/// \brief A ball that is dropped on a floor, step by step, with a rule for its bounces.

#include "05_resolution/restitution/restitution.hpp"
#include "05_resolution/restitution/trial/restitution_pitfalls.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace cookbook
{

/// What a contact does with a ball that will touch the floor within the step.
enum class Speculative
{
  off,              ///< nothing: it answers a step later, a little inside the floor
  stop,             ///< stops it at the floor, and forgets how fast it came
  stop_and_remember ///< stops it at the floor, and remembers
};

/// A ball of 1 kg above a floor.
struct Drop
{
  double height;                              ///< [m], of its lowest point above the floor
  double restitution;                         ///< [1]
  double duration;                            ///< [s]
  double step = 1.0 / 60;                     ///< [s]
  Speculative speculative = Speculative::off; ///< what happens ahead of a touch
  double gravity = 9.81;                      ///< [m/s²]
};

/// The ball at an instant.
struct Flight
{
  double time;   ///< [s]
  double height; ///< [m], of its lowest point above the floor
  double speed;  ///< [m/s], upwards, at this instant
};

/// The energy [J] of the ball, the floor being zero.
inline double energy(const Flight& flight, double gravity)
{
  return flight.speed * flight.speed / 2 + gravity * flight.height;
}

/// A rule for a bounce: the separating velocity [m/s] it is to have after a step, from the speed
/// with the step's gravity in it, the step, and the drop.
struct BounceRule
{
  std::string name;                                                             ///< as on the page
  std::function<double(double, const ContactStep<double>&, const Drop&)> speed; ///< the rule
};

/// The rules that compete; the last is the one to take.
inline std::vector<BounceRule> bounce_rules()
{
  using Step = ContactStep<double>;
  const auto threshold = [](const Drop& drop)
  { return restitution_threshold(drop.gravity, drop.step); };
  return {
      {"before gravity, as published", [](double speed, const Step& step, const Drop& drop)
       { return rebound_before_gravity(speed, step, drop.restitution); }},
      {"after gravity", [](double speed, const Step&, const Drop& drop)
       { return rebound_after_gravity(speed, drop.restitution, 0.0); }},
      {"after gravity, threshold", [=](double speed, const Step&, const Drop& drop)
       { return rebound_after_gravity(speed, drop.restitution, threshold(drop)); }},
      {"at the touch", [](double speed, const Step& step, const Drop& drop)
       { return rebound_speed(speed, step, drop.restitution, 0.0); }},
      {"at the touch, threshold", [=](double speed, const Step& step, const Drop& drop)
       { return rebound_speed(speed, step, drop.restitution, threshold(drop)); }}};
}

/// The floor and the ball, at rest.
inline BodyPair<double> floor_and_ball(double height)
{
  const Vector3<double> zero = Vector3<double>::Zero();
  const double radius = 0.25;
  const Motion<double> motion{{0, height + radius, 0}, zero, zero};
  const Matrix3<double> upright = Matrix3<double>::Identity();
  return {static_body(zero), dynamic_body<double>(motion, solid_sphere(1.0, radius), upright)};
}

/// The speed [m/s] at which the ball moves during a step, which a contact ahead may slow down; the
/// ball's own speed is what it keeps for the next step.
inline double moving_speed(const Drop& drop, double gap, double& speed)
{
  if (drop.speculative == Speculative::off || gap <= 0 || speed * drop.step >= -gap)
  {
    return speed;
  }
  const ContactStep<double> step{-drop.gravity, drop.step, -gap};
  const double touch = impact_speed(speed, step);
  const double slow = -gap / drop.step;
  speed = drop.speculative == Speculative::stop ? slow : -touch + drop.gravity * drop.step / 2;
  return slow;
}

/// The ball's flight with a rule for its bounces, a row for each step.
///
/// A step adds gravity, lets the ball bounce if it has reached the floor, then moves it. The speed
/// that a step moves with is that of its middle, so the ball starts with half a step of gravity
/// taken out, and a row's speed has half a step put back.
inline std::vector<Flight> flight(const Drop& drop, const BounceRule& rule)
{
  const Vector3<double> up = Vector3<double>::UnitY();
  BodyPair<double> bodies = floor_and_ball(drop.height);
  Motion<double>& ball = bodies.b.motion;
  const double radius = ball.center.y() - drop.height;
  const double half = drop.gravity * drop.step / 2;
  ball.velocity.y() = half;
  std::vector<Flight> rows;
  rows.push_back({0, drop.height, 0});
  for (int i = 1; i * drop.step <= drop.duration + drop.step / 2; ++i)
  {
    ball.velocity.y() -= 2 * half;
    const ContactStep<double> step{-drop.gravity, drop.step, radius - ball.center.y()};
    const double speed = ball.velocity.y();
    if (step.depth >= 0 && speed < 0)
    {
      const double target = rule.speed(speed, step, drop);
      bodies = with_separating_velocity<double>(bodies, up, {0, 0, 0}, target);
    }
    ball.center.y() += drop.step * moving_speed(drop, -step.depth, ball.velocity.y());
    rows.push_back({i * drop.step, ball.center.y() - radius, ball.velocity.y() - half});
  }
  return rows;
}

/// How high [m] the ball comes after each touch, between two steps too.
inline std::vector<double> apexes(const std::vector<Flight>& flight, double gravity)
{
  std::vector<double> found;
  for (std::size_t i = 1; i + 1 < flight.size(); ++i)
  {
    if (flight[i].height > flight[i - 1].height && flight[i].height >= flight[i + 1].height)
    {
      found.push_back(energy(flight[i], gravity) / gravity);
    }
  }
  return found;
}

/// When [s] the ball moved last.
inline double last_move(const std::vector<Flight>& flight)
{
  std::size_t last = flight.size() - 1;
  while (last > 0 && flight[last].height == flight[last - 1].height)
  {
    --last;
  }
  return flight[last].time;
}

/// The greatest change of the ball's energy, as a fraction of what it had.
inline double energy_change(const std::vector<Flight>& flight, double gravity)
{
  const double before = energy(flight.front(), gravity);
  double greatest = 0;
  for (const Flight& row : flight)
  {
    const double change = energy(row, gravity) / before - 1;
    greatest = std::abs(change) > std::abs(greatest) ? change : greatest;
  }
  return greatest;
}

} // namespace cookbook
