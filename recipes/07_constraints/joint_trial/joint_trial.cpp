/// \file
/// \brief Solvers of joints on trial: chains, loops, towers and pairs in space by each of them,
/// against what is right.

#include "07_constraints/joint_trial/trial/joint_trial.hpp"
#include "07_constraints/joint_trial/trial/joint_laws.hpp"
#include "07_constraints/joint_trial/trial/joint_trial_figures.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <iostream>
#include <string>

namespace
{

using namespace cookbook;

/// How far [m] a tower sinks, in millimetres with one digit: at ten cubes on each other rounding
/// errors grow, and compilers differ in the second.
std::string one_digit(double length)
{
  const double size = 1000 * std::abs(length), unit = size < 10 ? 1 : 10;
  return size < 1e-3 ? "<0.001" : size < 1 ? "<1" : number(unit * std::round(size / unit));
}

/// A fraction that is to be zero.
std::string lost(double fraction)
{
  return fraction < 1e-9 ? "<1e-09" : rounded(fraction);
}

// [print_chains]
void print_chains()
{
  Table table(
      {"stretch [mm]", "1 kg", "100 kg", "1,000 kg", "10,000 kg", "100 nudged", "1,000 nudged",
       "100 swung", "1:1000"});
  for (const JointMethod& method : joint_methods())
  {
    const JointRun run{method, method.usual};
    const auto sink = [&](double load)
    { return millimetres(sink_of(run, loaded_chain_of(load), 21)); };
    const auto apart = [&](const JointedScene& scene)
    { return millimetres(stretch_of(run, scene)); };
    table.row(
        {method.name, sink(1), sink(100), sink(1000), sink(10000), apart(nudged_chain(100)),
         apart(nudged_chain(1000)), apart(swung_chain()), apart(light_and_heavy())});
  }
  std::cout << table.text();
}

// [print_chains]

// [print_laws]
void print_loops()
{
  Table table(
      {"off by [mm]", "settings", "swung, 1 s", "bridge sags", "ring opens", "tower sinks"});
  for (const JointMethod& method : joint_methods())
  {
    const JointRun run{method, method.usual};
    table.row(
        {method.name, std::to_string(method.usual) + " " + method.counted,
         millimetres(swing_off(run)), millimetres(sink_of(run, hanging_bridge(), 15)),
         millimetres(stretch_of(run, closed_ring())), one_digit(tower_sink_of(run))});
  }
  std::cout << '\n' << table.text();
}

void print_laws()
{
  Table table(
      {"energy left", "pendulum", "swung chain", "pair", "period off", "momentum off",
       "angular off"});
  for (const JointMethod& method : joint_methods())
  {
    const JointRun run{method, method.usual};
    const MomentaOff momenta = momenta_off(run);
    table.row(
        {method.name, kept(energy_left(run, pendulum_of(0.96, 0.28), -2 * 9.81, 1200)),
         kept(energy_left(run, swung_chain(), energy_hanging(100), 300)), kept(momenta.energy),
         lost(period_off(run, 0.96, 0.28)), lost(momenta.linear), lost(momenta.angular)});
  }
  std::cout << '\n' << table.text();
}
// [print_laws]

void run(const Arguments& given)
{
  print_chains();
  print_loops();
  print_laws();
  save_figure(given, "joint_trial.svg", stretch_chart(1000).svg());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "joint_trial",
      .summary = "Chains, loops, towers and pairs by each solver of joints."};
  return run_program(argc, argv, arguments, run);
}
