#pragma once

/// \file
/// \brief Scenes with joints and a load, to be dragged by the mouse under each solver.

#include "07_constraints/joint_trial/trial/joint_methods.hpp"
#include "07_constraints/joint_trial/trial/joint_scenes.hpp"
#include "07_constraints/joints/trial/ragdoll.hpp"
#include "07_constraints/play/trial/play_world.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cookbook::play
{

/// A cube of 50 cm with a mass [kg] that hangs on a body of a scene by a point [m], world.
inline JointedScene with_load(JointedScene of, int body, const Vector3<double>& point, double load)
{
  const Vector3<double> half(0.25, 0.25, 0.25);
  of.joints.push_back({body, static_cast<int>(of.scene.bodies.size()), point});
  of.scene.bodies.push_back(box_body("load", half, point - Vector3<double>(0, 0.25, 0), load));
  return of;
}

/// The bridge of the trial with a load on its middle.
inline JointedScene loaded_bridge(double load)
{
  JointedScene bridge = hanging_bridge();
  const Vector3<double> middle = bridge.joints[15].point;
  return with_load(std::move(bridge), 15, middle, load);
}

/// The ring of the trial with a load below.
inline JointedScene loaded_ring(double load)
{
  JointedScene ring = closed_ring();
  const Vector3<double> lowest = ring.joints[6].point;
  return with_load(std::move(ring), 6, lowest, load);
}

/// A ragdoll on the ground, with a small load in one hand.
inline JointedScene ragdoll_with_load(double load)
{
  JointedScene ragdoll{{.bodies = {ground()}}, {}};
  for (const SceneBody& limb : ragdoll_limbs({0, 0.6, 0}))
  {
    ragdoll.scene.bodies.push_back(limb);
  }
  const int hand = 8;
  ragdoll.joints.push_back({hand, 11, {0.27, 1.5, 0}});
  ragdoll.scene.bodies.push_back(box_body("load", {0.08, 0.08, 0.08}, {0.27, 1.42, 0}, load));
  return ragdoll;
}

/// A scene to choose, with what can be dragged at first.
struct LiveJoints
{
  std::string name;
  JointedScene (*scene)(double load);
  std::size_t grip; ///< a body
  bool ragdoll = false;
};

/// All of them.
inline std::vector<LiveJoints> live_joints()
{
  const auto swung = [](double load)
  { return loaded_chain_of(load, std::sqrt(0.5), std::sqrt(0.5)); };
  return {
      {"chain of 20 links, let go at 45°", swung, 21},
      {"the same, hanging and nudged", [](double load) { return nudged_chain(load); }, 21},
      {"bridge of 30 planks", loaded_bridge, 32},
      {"ring of 12 links", loaded_ring, 13},
      {"ragdoll", ragdoll_with_load, 1, true}};
}

/// A world of one of them under a solver, in steps [s].
inline std::unique_ptr<Play>
play_joints(const LiveJoints& chosen, double load, const WorldSolver& solver, double step)
{
  JointedScene of = chosen.scene(load);
  of.scene.step = step;
  const Scene scene = chosen.ragdoll ? of.scene : without_contacts(of.scene);
  auto play = std::make_unique<Play>(scene, false);
  play->solver.change(solver);
  add_ball_joints(play->world, of.joints);
  if (chosen.ragdoll)
  {
    const RagdollJoints limbs = ragdoll_joints(play->world, 1);
    play->world.add(limbs.cones);
    play->world.add(limbs.hinges);
  }
  play->orbit.yaw = 0.25;
  play->orbit.distance *= 1.2;
  return play;
}

} // namespace cookbook::play
