#pragma once

/// \file
/// \brief What each integrator costs, in evaluations of the force, and how wrong it then is.

#include "05_resolution/integrators/trial/integrators_scenes.hpp"
#include "tools/measure/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// Periods that a swing goes on for; a quarter more, so that it ends where it is fast.
inline constexpr int whole_periods = 10;

/// What a swing of 10¼ periods costs, in evaluations a period, and how far it ends from the truth,
/// in the plane of position and velocity / pace.
///
/// The truth is known without integrating: it is where it was after the first quarter.
inline measure::CostAndError
cost_and_error(const Swing& swing, const Integrator<double>& method, int steps_a_period)
{
  long evaluations = 0;
  const AccelerationAt<double> counted = [&](double x, double v)
  {
    ++evaluations;
    return swing.acceleration(x, v);
  };
  const int steps = whole_periods * steps_a_period + steps_a_period / 4;
  const double step = swing.period / steps_a_period;
  const PhasePoint<double> end = method.follow(swing.start, step, steps, counted).back();
  const double ahead = end.position - swing.quarter.position;
  const double faster = (end.velocity - swing.quarter.velocity) / swing.pace;
  const double periods = whole_periods + 0.25;
  return {static_cast<double>(evaluations) / periods, std::hypot(ahead, faster)};
}

/// The curve of an integrator: 8, 16, 32 … steps a period, up to about 2,000 evaluations.
///
/// Each error is the worst of several steps from this one to half of it, for luck may favour one.
inline std::vector<measure::CostAndError>
cost_curve(const Swing& swing, const Integrator<double>& method)
{
  std::vector<measure::CostAndError> curve;
  for (int steps = 8; steps <= 2048; steps *= 2)
  {
    measure::CostAndError worst = cost_and_error(swing, method, steps);
    if (worst.cost > 2060)
    {
      break;
    }
    for (int more = steps; more < 2 * steps; more += std::max(4, steps / 8))
    {
      worst.error = std::max(worst.error, cost_and_error(swing, method, more).error);
    }
    curve.push_back(worst);
  }
  return curve;
}

/// Costs and errors of ever shorter steps, up to 4,096 evaluations a period.
inline std::vector<measure::CostAndError>
shorter_steps(const Swing& swing, const Integrator<double>& method)
{
  std::vector<measure::CostAndError> all;
  for (int steps = 4; all.empty() || all.back().cost <= 4096; steps += 4 * (1 + steps / 256))
  {
    all.push_back(cost_and_error(swing, method, steps));
  }
  return all;
}

/// The number of evaluations a period from which on the error stays below a tolerance; 0 if 2,048
/// are too few.
inline double evaluations_needed(const std::vector<measure::CostAndError>& all, double tolerance)
{
  double needed = 0;
  for (const measure::CostAndError& point : all)
  {
    const double first = needed > 0 ? needed : point.cost;
    needed = point.error < tolerance ? first : 0;
  }
  return needed <= 2048 ? needed : 0;
}

/// A step length of an integrator.
struct Choice
{
  std::string name;          ///< of the integrator
  measure::CostAndError has; ///< infinite error where it is of no use
};

/// All choices for a swing; those that end half an amplitude beside the truth are of no use.
inline std::vector<Choice> choices(const Swing& swing)
{
  std::vector<Choice> all;
  for (const Integrator<double>& method : integrators<double>())
  {
    for (const measure::CostAndError& point : cost_curve(swing, method))
    {
      const bool of_use = point.error < 0.5;
      all.push_back({method.name, {point.cost, of_use ? point.error : HUGE_VAL}});
    }
  }
  return all;
}

/// The choices that none beats in both cost and error, the cheapest first.
inline std::vector<Choice> best_choices(const Swing& swing)
{
  const std::vector<Choice> all = choices(swing);
  std::vector<measure::CostAndError> points;
  for (const Choice& choice : all)
  {
    points.push_back(choice.has);
  }
  std::vector<Choice> best;
  for (const std::size_t i : measure::pareto_front(points))
  {
    best.push_back(all[i]);
  }
  return best;
}

} // namespace cookbook
