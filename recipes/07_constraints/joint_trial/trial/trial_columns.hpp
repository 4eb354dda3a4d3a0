#pragma once

/// \file
/// \brief The columns of the trial's tables.

#include "07_constraints/joint_trial/trial/joint_laws.hpp"
#include "07_constraints/joint_trial/trial/joint_trial.hpp"
#include "07_constraints/joint_trial/trial/trial_cells.hpp"

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace cookbook
{

// [trial_columns]
/// A column of a table: of a scene one measure, as text.
struct TrialColumn
{
  std::string title, scene, measure;
  std::function<std::string(const JointRun&)> cell;

  /// That of a run, or a dash where its method cannot have the scene.
  std::string of(const JointRun& run) const
  {
    try
    {
      return cell(run);
    }
    catch (const std::logic_error&)
    {
      return "-";
    }
  }
};

/// How far chains give way, or come apart.
inline std::vector<TrialColumn> chain_columns()
{
  const auto sink = [](double load)
  {
    return [load](const JointRun& run)
    { return millimetres(sink_of(run, loaded_chain_of(load), 21)); };
  };
  const auto apart = [](const JointedScene& scene)
  { return [scene](const JointRun& run) { return millimetres(stretch_of(run, scene)); }; };
  const std::string sinks = "load sinks [mm]", opens = "joints open [mm]";
  return {
      {"1 kg", "chain with 1 kg", sinks, sink(1)},
      {"100 kg", "chain with 100 kg", sinks, sink(100)},
      {"1,000 kg", "chain with 1000 kg", sinks, sink(1000)},
      {"10,000 kg", "chain with 10000 kg", sinks, sink(10000)},
      {"100 nudged", "chain with 100 kg nudged", opens, apart(nudged_chain(100))},
      {"1,000 nudged", "chain with 1000 kg nudged", opens, apart(nudged_chain(1000))},
      {"100 swung", "chain with 100 kg swung", opens, apart(swung_chain())},
      {"1:1000", "links of 1 and 1000 kg", opens, apart(light_and_heavy())}};
}

/// Where things are that should be elsewhere.
inline std::vector<TrialColumn> loop_columns()
{
  return {
      {"swung, 1 s", "chain with 100 kg swung", "load off after 1 s [mm]",
       [](const JointRun& run) { return millimetres(swing_off(run)); }},
      {"bridge sags", "bridge", "middle off [mm]",
       [](const JointRun& run) { return millimetres(sink_of(run, hanging_bridge(), 15)); }},
      {"ring opens", "ring", "joints open [mm]",
       [](const JointRun& run) { return millimetres(stretch_of(run, closed_ring())); }},
      {"tower sinks", "tower of ten", "top sinks [mm]",
       [](const JointRun& run) { return one_digit(tower_sink_of(run)); }}};
}

/// What is kept of energy, period and momenta.
inline std::vector<TrialColumn> law_columns()
{
  const std::string left = "energy left [1]";
  return {
      {"pendulum", "pendulum", left,
       [](const JointRun& run)
       { return kept(energy_left(run, pendulum_of(0.96, 0.28), -2 * 9.81, 1200)); }},
      {"swung chain", "chain with 100 kg swung", left,
       [](const JointRun& run)
       { return kept(energy_left(run, swung_chain(), energy_hanging(100), 300)); }},
      {"pair", "pair in space", left,
       [](const JointRun& run) { return kept(momenta_off(run).energy); }},
      {"period off", "pendulum", "period off [1]",
       [](const JointRun& run) { return lost(period_off(run, 0.96, 0.28)); }},
      {"momentum off", "pair in space", "momentum off [1]",
       [](const JointRun& run) { return lost(momenta_off(run).linear); }},
      {"angular off", "pair in space", "angular momentum off [1]",
       [](const JointRun& run) { return lost(momenta_off(run).angular); }}};
}
// [trial_columns]

} // namespace cookbook
