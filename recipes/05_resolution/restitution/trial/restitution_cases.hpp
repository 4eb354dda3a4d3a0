#pragma once

/// \file
/// \brief Drops of a ball, and what each rule for its bounces makes of them.

#include "05_resolution/restitution/trial/restitution_scenes.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace cookbook
{

/// A drop, and how its flight is judged.
struct DropCase
{
  std::string id;                                                         ///< in the book, or empty
  std::string what;                                                       ///< in a few words
  Drop drop;                                                              ///< the scene
  std::function<Verdict(const Drop&, const std::vector<Flight>&)> oracle; ///< of a flight
};

/// A number for a table: rounding errors below a millionth are none.
inline std::string tidied(double value)
{
  return number(std::round(value * 1e6) / 1e6);
}

/// S15: the first two apexes are e² and e⁴ of the height, to a millimetre.
inline Verdict right_apexes(const Drop& drop, const std::vector<Flight>& flight)
{
  const std::vector<double> found = apexes(flight, drop.gravity);
  const double share = drop.restitution * drop.restitution;
  const double first = found.at(0), second = found.at(1);
  const bool holds = std::abs(first - share * drop.height) <= 1e-3 &&
                     std::abs(second - share * share * drop.height) <= 1e-3;
  std::string text = tidied(first);
  return {holds, text.append(", ").append(tidied(second)).append(" m")};
}

/// S16: no energy comes or goes, to a millionth.
inline Verdict energy_kept(const Drop& drop, const std::vector<Flight>& flight)
{
  const double change = energy_change(flight, drop.gravity);
  std::string text = "energy × ";
  return {std::abs(change) <= 1e-6, change > -1 ? text.append(tidied(1 + change)) : "loses it all"};
}

/// S17: at rest on the floor, to a centimetre, half a second after the last bounce is due.
inline Verdict comes_to_rest(const Drop& drop, const std::vector<Flight>& flight)
{
  const double due = settling_time(drop.height, drop.gravity, drop.restitution);
  const double last = last_move(flight), height = flight.back().height;
  const bool rests = last < flight.back().time;
  std::string text = rests ? "rests at " : "moves for ever";
  if (rests)
  {
    text.append(tidied(last)).append(" s");
  }
  else if (height < -0.01)
  {
    text.append(", sinks ").append(tidied(-height)).append(" m");
  }
  return {rests && last <= due + 0.5 && std::abs(height) <= 0.01, text};
}

/// J8: it comes up as fast as it came down, to a hundredth.
inline Verdict keeps_speed(const Drop& drop, const std::vector<Flight>& flight)
{
  const auto speed = [&](double height) { return std::sqrt(2 * drop.gravity * height); };
  const double up = speed(apexes(flight, drop.gravity).at(0));
  return {std::abs(up / speed(drop.height) - 1) <= 0.01, tidied(up) + " m/s"};
}

/// All drops.
inline std::vector<DropCase> drop_cases()
{
  const double ten = 100 / 19.62;
  return {
      {"S15", "e = 0.5 from 1 m: up to 0.25, 0.0625 m", {1, 0.5, 2}, right_apexes},
      {"", "e = 0.5 from 5 m: up to 1.25, 0.3125 m", {5, 0.5, 4}, right_apexes},
      {"S16", "e = 1 from 1 m, 20 s: the same energy", {1, 1, 20}, energy_kept},
      {"S17", "e = 0.8 from 1 m: rests by 4.064 + 0.5 s", {1, 0.8, 20}, comes_to_rest},
      {"", "e = 0.5 from 1 m: rests by 1.355 + 0.5 s", {1, 0.5, 20}, comes_to_rest},
      {"J8",
       "e = 1 at 10 m/s, stopped at the floor: up at 10 m/s",
       {ten, 1, 4, 1.0 / 60, Speculative::stop},
       keeps_speed},
      {"",
       "the same, and the speed remembered",
       {ten, 1, 4, 1.0 / 60, Speculative::stop_and_remember},
       keeps_speed}};
}

/// The verdicts on drops: a row for each, a column for each rule.
inline std::vector<VerdictRow> drop_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const DropCase& one : drop_cases())
  {
    rows.push_back({one.id, one.what, {}});
    for (const BounceRule& rule : bounce_rules())
    {
      rows.back().verdicts.push_back(one.oracle(one.drop, flight(one.drop, rule)));
    }
  }
  return rows;
}

} // namespace cookbook
