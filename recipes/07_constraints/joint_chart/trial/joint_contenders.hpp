#pragma once

/// \file
/// \brief What takes part where solvers of joints are timed: this book's, and those of engines.

#include "07_constraints/joint_chart/trial/joint_peer_multibody.hpp"
#include "07_constraints/joint_chart/trial/joint_peer_ode.hpp"
#include "07_constraints/joint_chart/trial/joint_peer_tree.hpp"
#include "07_constraints/joint_trial/trial/joint_methods.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cookbook
{

/// A solver with one of its settings.
struct JointContender
{
  std::string line;     ///< its name, and its curve's
  std::string settings; ///< in words
  int number;           ///< of the setting in its curve, from zero
  int substeps;         ///< of a frame, in an engine; zero: as a solver of this book takes them
  bool chains_only;     ///< whether it takes no other scene
  int count;            ///< what its method is given
  std::function<JointMethod(const JointedScene&)> on;              ///< as a method, to be measured
  std::function<std::function<void()>(const JointedScene&)> build; ///< to be timed, by frames
};

/// A solver of this book, given so much of what it counts.
inline JointContender contender(const JointMethod& method, int count, int number)
{
  const auto build = [method, count](const JointedScene& scene) -> std::function<void()>
  {
    const int steps = method.steps(count);
    const GameWorld world = jointed_world(scene, method.solver(count), 60 * steps);
    return [world = std::make_shared<GameWorld>(world), steps]
    {
      for (int i = 0; i < steps; ++i)
      {
        world->step();
      }
    };
  };
  const auto on = [method](const JointedScene&) { return method; };
  const std::string settings = std::to_string(count) + " " + method.counted;
  return {method.name, settings, number, 0, false, count, on, build};
}

/// What is made of a scene and settings, as a contender.
template <class Peer, class Settings>
JointContender contender(
    const std::string& line, const std::string& words, int number, int substeps,
    const Settings& settings)
{
  const auto made = [settings](const JointedScene& scene)
  {
    const auto peer = std::make_shared<Peer>(scene, settings);
    return JointPeer{[peer] { peer->go(); }, [peer] { return peer->state(); }};
  };
  const auto on = [made, line](const JointedScene& scene) {
    return JointMethod{line, "", 1, [made, scene](int) { return follow(made(scene)); }, 1};
  };
  const auto build = [made](const JointedScene& scene) { return made(scene).go; };
  return {line, words, number, substeps, Peer::chains_only, 1, on, build};
}

// [joint_contenders]
/// Adds a curve of an engine: the settings with which it comes, and 4, 8 and 16 times as much.
template <class Peer, class SettingsOf>
void add_curve(
    std::vector<JointContender>& all, const std::string& line, const std::string& words,
    const std::string& counted, const SettingsOf& settings_of)
{
  int number = 0;
  for (const int times : {1, 4, 8, 16})
  {
    const auto [count, settings] = settings_of(times);
    const std::string text = words + std::to_string(count) + " " + counted + (count > 1 ? "s" : "");
    const int substeps = counted == "substep" ? count : 1;
    all.push_back(contender<Peer>(line, text, number++, substeps, settings));
  }
}

/// All solvers of joints: this book's with 1 to 8 times what they take, engines with 1 to 16 times
/// the substeps, or the iterations.
inline std::vector<JointContender> joint_contenders()
{
  std::vector<JointContender> all;
  for (const JointMethod& method : joint_methods())
  {
    int number = 0;
    for (const int times : {1, 2, 4, 8})
    {
      const int count = times * method.usual;
      if (method.name != "wide_steps" && count * method.price <= 64) // that has soft_steps' answers
      {
        all.push_back(contender(method, count, number++));
      }
    }
  }
  const auto substeps = [](int times) { return std::pair(times, times); };
  add_curve<JointTree>(all, "articulated", "", "substep", substeps);
#if defined(COOKBOOK_HAS_BULLET)
  add_curve<BulletJoints>(
      all, "Bullet", "10 iterations, ", "substep",
      [](int times) { return std::pair(times, BulletSettings{.substeps = times}); });
  add_curve<BulletJoints>(
      all, "Bullet, iterations", "", "iteration",
      [](int times) { return std::pair(10 * times, BulletSettings{.iterations = 10 * times}); });
  add_curve<BulletJoints>(
      all, "Bullet, Dantzig", "", "substep",
      [](int times) { return std::pair(times, BulletSettings{.substeps = times, .exact = true}); });
  add_curve<BulletMultibody>(all, "Bullet, multibody", "", "substep", substeps);
#endif
#if defined(COOKBOOK_HAS_ODE)
  add_curve<OdeJoints>(
      all, "ODE, direct", "", "substep",
      [](int times) { return std::pair(times, OdeSettings{.substeps = times}); });
  add_curve<OdeJoints>(
      all, "ODE, quick", "20 iterations, ", "substep",
      [](int times) { return std::pair(times, OdeSettings{.substeps = times, .iterations = 20}); });
  add_curve<OdeJoints>(
      all, "ODE, iterations", "", "iteration",
      [](int times) { return std::pair(20 * times, OdeSettings{.iterations = 20 * times}); });
#endif
  return all;
}
// [joint_contenders]

} // namespace cookbook
