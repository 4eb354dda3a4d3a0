#pragma once

/// \file
/// \brief What the published particle and spring do, beside ours.

#include "05_resolution/integrators/trial/integrators_pitfalls.hpp"
#include "05_resolution/integrators/trial/integrators_verdicts.hpp"

#include <array>

namespace cookbook
{

/// What the published way and ours come to.
using AsPublishedAndOurs = std::array<double, 2>;

/// Where [m] a particle of a mass [kg] is after 1 s of fall at 60 Hz.
inline AsPublishedAndOurs fallen(double mass)
{
  const double step = 1 / game_rate, weight = -mass * falling;
  const AccelerationAt<double> gravity = [&](double, double) { return weight / mass; };
  PositionPair<double> published{0, 0};
  PhasePoint<double> ours{0, 0};
  for (int i = 0; i < 60; ++i)
  {
    published = verlet_as_published(published, weight, step);
    ours = velocity_verlet(ours, step, gravity);
  }
  return {published.now, ours.position};
}

/// The period [s] of 1 kg let go 10 cm too far out on the published spring, over 40 s.
inline double published_period(const Spring<double>& spring, double rate)
{
  PhasePoint<Vector3<double>> at{{spring.rest_length + 0.1, 0, 0}, {0, 0, 0}};
  std::vector<double> stretches;
  for (int i = 0; i < static_cast<int>(40 * rate); ++i)
  {
    stretches.push_back(at.position.x() - spring.rest_length);
    at.velocity += spring_as_published(spring, at.position, at.velocity);
    at.position += at.velocity / rate;
  }
  return measured_period(stretches, 1 / rate);
}

/// The power [W] of a damper alone on an end that comes back at 1 m/s.
inline AsPublishedAndOurs damper_power()
{
  const Spring<double> damper{0, 1, 1};
  const Vector3<double> arm(2, 0, 0), inwards(-1, 0, 0);
  return {
      spring_as_published(damper, arm, inwards).dot(inwards),
      spring_force(damper, arm, inwards).dot(inwards)};
}

/// Both judged alike.
template <class Result, class Oracle>
VerdictRow published_row(
    const std::string& id, const std::string& what, const std::array<Result, 2>& results,
    const Oracle& oracle)
{
  return {id, what, {oracle(results[0]), oracle(results[1])}};
}

/// A second's fall of some masses.
inline std::vector<VerdictRow> fall_rows()
{
  const auto oracle = [](double y) -> Verdict {
    return {std::abs(y + falling / 2) <= 0.1, std::string("y = ").append(decimals(y, 1)) + " m"};
  };
  std::vector<VerdictRow> rows;
  for (const double mass : {1.0, 2.0, 100.0})
  {
    const std::string what = number(mass) + " kg falls for 1 s: −4.905 m to 0.1";
    rows.push_back(published_row(rows.empty() ? "I7" : "", what, fallen(mass), oracle));
  }
  return rows;
}

/// A mass on a spring with steps of several lengths.
inline std::vector<VerdictRow> period_rows()
{
  const auto oracle = [](double period) -> Verdict
  {
    const bool holds = std::abs(period / spring_period(soft_spring, 1.0) - 1) <= 0.01;
    return {holds, std::string("period ").append(decimals(period, 3)) + " s"};
  };
  const auto verlet = integrators<Vector3<double>>()[3];
  std::vector<VerdictRow> rows;
  for (const double rate : {30.0, 60.0, 960.0})
  {
    const std::string what = "10 N/m, 1 kg, " + number(rate) + " Hz: 1.987 s to 1 %";
    const AsPublishedAndOurs periods{
        published_period(soft_spring, rate), spring_measured(verlet, rate)};
    rows.push_back(published_row(rows.empty() ? "X43" : "", what, periods, oracle));
  }
  return rows;
}

/// All cases of the published particle and spring.
inline std::vector<VerdictRow> published_verdicts()
{
  const auto takes = [](double watts) -> Verdict {
    return {watts <= 0, std::string("power ").append(number(watts)) + " W"};
  };
  const auto finite = [](const Vector3<double>& force) -> Verdict {
    return {force.allFinite(), force.allFinite() ? "pushes up" : "not a number"};
  };
  const Vector3<double> none(0, 0, 0);
  const std::array<Vector3<double>, 2> at_none{
      spring_as_published(soft_spring, none, none), spring_force(soft_spring, none, none)};
  std::vector<VerdictRow> rows = fall_rows();
  for (const VerdictRow& row : period_rows())
  {
    rows.push_back(row);
  }
  rows.push_back(published_row("", "damper, its end comes back at 1 m/s", damper_power(), takes));
  rows.push_back(published_row("", "spring of length zero", at_none, finite));
  return rows;
}

} // namespace cookbook
