#pragma once

/// \file
/// \brief What solvers of joints cost, and how wrong they are, on the scenes of the trial.

#include "06_world/game_world/trial/world_cost_measured.hpp"
#include "07_constraints/joint_chart/trial/joint_contenders.hpp"
#include "07_constraints/joint_trial/trial/joint_laws.hpp"
#include "07_constraints/joint_trial/trial/joint_trial.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace cookbook
{

// [joint_errors]
/// A scene, and what is measured of it.
struct JointError
{
  std::string name;
  JointedScene scene;
  std::function<double(const JointRun&)> of; ///< [m]
};

/// How far joints of a scene come apart.
inline JointError stretch_error(const std::string& name, const JointedScene& scene)
{
  return {name, scene, [scene](const JointRun& run) { return stretch_of(run, scene); }};
}

/// How far a body sinks.
inline JointError sink_error(const std::string& name, const JointedScene& scene, std::size_t body)
{
  return {name, scene, [scene, body](const JointRun& run) { return sink_of(run, scene, body); }};
}

/// What is measured of all: a chain under loads at rest, nudged and swung, of light and heavy
/// links, and a bridge.
inline std::vector<JointError> joint_errors()
{
  return {
      sink_error("1 kg", loaded_chain_of(1), 21),
      sink_error("100 kg", loaded_chain_of(100), 21),
      sink_error("1,000 kg", loaded_chain_of(1000), 21),
      stretch_error("100 kg nudged", nudged_chain(100)),
      stretch_error("1,000 kg nudged", nudged_chain(1000)),
      stretch_error("1:1000", light_and_heavy()),
      sink_error("bridge", hanging_bridge(), 15),
      {"swung, 1 s", swung_chain(), swing_off}};
}

/// Whether a contender can take a scene: some take chains alone, whose last body is not fixed.
inline bool takes(const JointContender& contender, const JointedScene& scene)
{
  return !contender.chains_only || scene.scene.bodies.back().mass > 0;
}

/// The error of a contender.
inline double error_of(const JointContender& contender, const JointError& error)
{
  const JointMethod method = contender.on(error.scene);
  return error.of({method, contender.count});
}

/// For how many of the first frames [1/60 s] no joint bursts.
inline int frames_held(const JointContender& contender, const JointedScene& scene, int frames)
{
  const JointMethod method = contender.on(scene);
  int held = 0;
  run_joints({method, contender.count}, scene, frames, [&](GameWorld&) { ++held; });
  return held;
}
// [joint_errors]

// [joint_costs]
/// Frames that a contender goes on by before it is the next one's turn: with a frame each, all of
/// them would wait for their code to be read anew.
inline constexpr int frames_in_turn = 5;

/// What contenders cost on a scene, a movable body and frame [s]: the mean over so many turns from
/// the start, each the least of some repetitions. A turn in which a joint bursts does not count,
/// but the first.
inline std::vector<double> joint_costs(
    const std::vector<JointContender>& contenders, const JointedScene& scene, int turns,
    int repetitions)
{
  const auto in_turns = [](const std::function<void()>& frame)
  {
    return [frame]
    {
      for (int i = 0; i < frames_in_turn; ++i)
      {
        frame();
      }
    };
  };
  std::vector<TimedWorld> worlds;
  for (const JointContender& contender : contenders)
  {
    worlds.push_back({contender.line, [&] { return in_turns(contender.build(scene)); }});
  }
  const auto movable = [](const SceneBody& body) { return body.mass > 0; };
  const std::vector<SceneBody>& bodies = scene.scene.bodies;
  const auto count = static_cast<double>(std::count_if(bodies.begin(), bodies.end(), movable));
  std::vector<double> costs;
  for (const std::vector<double>& times : each_step_seconds(worlds, turns, repetitions))
  {
    const JointContender& contender = contenders[costs.size()];
    const int held = frames_held(contender, scene, turns * frames_in_turn) / frames_in_turn;
    const std::span<const double> counted = std::span(times).first(index_of(std::max(1, held)));
    costs.push_back(mean_of(counted) / frames_in_turn / count);
  }
  return costs;
}
// [joint_costs]

} // namespace cookbook
