#pragma once

/// \file
/// \brief The table of stacks and ways to solve many contacts.

#include "06_world/position_based/trial/solvers_cases.hpp"

namespace cookbook
{

/// A stack or a question about one, and how a method is judged.
struct StackCase
{
  std::string id;                                      ///< in the book, or empty
  std::string what;                                    ///< in a few words
  std::function<Verdict(const ContactMethod&)> oracle; ///< of a method
};

/// The power of ten that a length [m] is below, in millimetres: where a body drifts to hangs on the
/// last bits.
inline std::string below_millimetres(double length)
{
  double bound = 0.01;
  while (1000 * length >= bound)
  {
    bound *= 10;
  }
  return "under " + number(bound) + " mm";
}

/// A length [m] in millimetres, to a hundredth.
inline std::string in_millimetres(double length)
{
  const double rounded = std::round(length * 1e5) / 100;
  return rounded == 0 ? "under 0.01 mm" : number(rounded) + " mm";
}

/// What a stack must not exceed.
struct StackLimits
{
  double sink;  ///< [m]
  double drift; ///< [m]
  double tilt;  ///< [°]
};

/// The verdict on a stack after a time [s].
inline Verdict
stands(const ContactMethod& method, const Scene& scene, double duration, const StackLimits& limits)
{
  const StackMeasures most = stack_measures(scene, method.solver(), duration);
  const double degrees = most.tilt * 45 / std::atan(1.0);
  if (most.fell > 0)
  {
    return {false, "falls at " + number(std::round(100 * most.fell) / 100) + " s"};
  }
  const bool holds =
      most.sink <= limits.sink && most.drift <= limits.drift && degrees <= limits.tilt;
  return {
      holds, "sinks " + in_millimetres(most.sink) + ", drifts " + below_millimetres(most.drift)};
}

/// S4: the error shrinks by r / (1 + r) a pass, to 5 %; asked of those that come to an answer.
inline Verdict shrinks(const ContactMethod& method, double ratio)
{
  if (!method.no_factor.empty())
  {
    return does_not_apply(method.no_factor);
  }
  const double factor = measured_factor(method, ratio);
  return {
      std::abs(factor * (1 + ratio) / ratio - 1) <= 0.05, number(std::round(factor * 1e4) / 1e4)};
}

/// All stacks.
inline std::vector<StackCase> stack_cases()
{
  const auto stack = [](const Scene& scene, double duration, const StackLimits& limits)
  { return [=](const ContactMethod& method) { return stands(method, scene, duration, limits); }; };
  const auto ratio = [](double r)
  { return [r](const ContactMethod& method) { return shrinks(method, r); }; };
  const auto spread = [](const ContactMethod& method)
  {
    const double most = order_spread(method.solver(), 100);
    return Verdict{most <= 0.01, below_millimetres(most)};
  };
  return {
      {"S1", "a cube, 10 s: 1 mm, 0.1°", stack(scenes::tower(1), 10, {0.01, 0.001, 0.1})},
      {"S2", "five cubes, 10 s: 1 cm, 0.5°", stack(scenes::tower(5), 10, {0.5, 0.01, 0.5})},
      {"", "ten cubes, 20 s: they stand", stack(scenes::tower(10), 20, {0.5, 0.5, 10})},
      {"S4", "1 kg on 1 kg: error × 0.5 a pass", ratio(1)},
      {"", "10 kg on 1 kg: × 0.9091", ratio(10)},
      {"", "100 kg on 1 kg: × 0.9901", ratio(100)},
      {"S5", "100 kg on 1 kg, 10 s: 2 cm", stack(scenes::heavy_on_light(100), 10, {0.02, 1, 90})},
      {"S19", "five cubes in 100 orders, 2 s: 1 cm apart", spread}};
}

/// The verdicts on stacks: a row for each, a column for each method.
inline std::vector<VerdictRow> stack_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const StackCase& one : stack_cases())
  {
    rows.push_back({one.id, one.what, {}});
    for (const ContactMethod& method : contact_methods())
    {
      rows.back().verdicts.push_back(one.oracle(method));
    }
  }
  return rows;
}

} // namespace cookbook
