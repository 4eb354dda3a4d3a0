#pragma once

/// \file
/// \brief Chains, bridges and cantilevers on trial.

#include "06_world/game_world/direct_or_soft.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "07_constraints/taut/taut.hpp"
#include "07_constraints/taut/trial/jointed_scene.hpp"
#include "07_constraints/taut/trial/taut_joints.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace cookbook
{

// [taut_scenes]
/// A world of bodies that hang on each other in their order, the first of them on nothing, at
/// these points [m]: joint i between bodies i and i + 1.
template <class Kind>
GameWorld
row_of(const Scene& scene, const std::vector<Vector3<double>>& points, const WorldSolver& by)
{
  GameWorld world(without_contacts(scene), by);
  JointSet<Kind> joints;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto a = static_cast<BodyId>(i);
    joints.add(trial_joint<Kind>(world, a, a + 1, points[i]));
  }
  world.add(joints);
  return world;
}

/// A chain of links of half a metre on a hook, let go or hanging, with a load of 50 cm.
struct TrialChain
{
  int links = 20;
  double load = 0;               ///< [kg], a cube on the last link; zero for none
  double light = 1;              ///< [kg], every other link; the rest are of 1 kg
  Vector2<double> towards{0, 1}; ///< sine and cosine of its angle from straight down
  double nudge = 0;              ///< [m/s], of the middle link
};

/// The direct solver with these substeps.
inline WorldSolver directly(const JointSubsteps& joints = {})
{
  return one_by_one(DirectOrSoft(8, {}, joints));
}

/// The direct solver with exactly so many explicit substeps, however taut joints are.
inline WorldSolver explicitly(int substeps)
{
  return directly({substeps, substeps, std::numeric_limits<double>::infinity()});
}

/// Soft steps, so many a frame.
inline WorldSolver softly(int substeps)
{
  return one_by_one([substeps](IslandView world, const Island& island, double step)
                    { soft_steps(world, island, step, {.substeps = substeps}); });
}

/// A chain as it starts, its hook 20 m up.
inline GameWorld world_of(const TrialChain& chain, const WorldSolver& by = directly())
{
  std::vector<double> masses;
  for (int i = 0; i < chain.links; ++i)
  {
    masses.push_back(i % 2 == 1 ? chain.light : 1);
  }
  JointedScene made =
      chain_of(masses, chain.towards.x(), chain.towards.y(), chain.load, {0, 20, 0});
  made.scene.bodies[index_of(1 + chain.links / 2)].velocity.x() = chain.nudge;
  return jointed_world(made, by);
}

/// A bridge of planks of 1 kg as it hangs without its load, which is put on the middle; its motion
/// is damped.
inline GameWorld world_of(HangingBridge bridge, const WorldSolver& by = directly())
{
  const double load = bridge.load / 9.81;
  bridge.load = 0;
  std::vector<Vector2<double>> planks;
  for (const Vector2<double>& plank : half_bridge(bridge))
  {
    planks.insert(planks.begin(), {plank.x(), -plank.y()});
  }
  for (const Vector2<double>& plank : half_bridge(bridge))
  {
    planks.push_back(plank);
  }
  Vector3<double> at(-bridge.span / 2, 20, 0);
  Scene scene{.bodies = {box_body("left", {0.1, 0.1, 0.1}, at, 0)}};
  std::vector<Vector3<double>> points{at};
  for (const Vector2<double>& plank : planks)
  {
    const Vector3<double> reach = bridge.length * Vector3<double>(plank.x(), plank.y(), 0);
    SceneBody body = box_body("plank", {bridge.length / 2, 0.05, 0.5}, at + reach / 2);
    body.orientation = turn_about_z(plank.y(), plank.x());
    scene.bodies.push_back(body);
    at += reach;
    points.push_back(at);
  }
  scene.bodies.push_back(box_body("right", {0.1, 0.1, 0.1}, at, 0));
  const std::size_t middle = planks.size() / 2;
  scene.bodies.push_back(
      box_body("load", {0.25, 0.25, 0.25}, points[middle] - Vector3<double>(0, 0.25, 0), load));
  for (SceneBody& body : scene.bodies)
  {
    body.damping = body.angular_damping = 3;
  }
  GameWorld world = row_of<BallJoint>(scene, points, by);
  const auto load_body = static_cast<BodyId>(scene.bodies.size() - 1);
  BallJoints joints;
  joints.add(ball_joint_at(world, static_cast<BodyId>(middle), load_body, points[middle]));
  world.add(joints);
  return world;
}

/// Beams of half a metre and 1 kg, welded to a wall and to each other.
inline GameWorld cantilever(int beams, const WorldSolver& by = directly())
{
  Scene scene{.bodies = {box_body("wall", {0.1, 0.5, 0.5}, {-0.1, 5, 0}, 0)}};
  std::vector<Vector3<double>> points;
  for (int i = 0; i < beams; ++i)
  {
    scene.bodies.push_back(box_body("beam", {0.25, 0.05, 0.05}, {0.5 * i + 0.25, 5, 0}));
    points.push_back({0.5 * i, 5, 0});
  }
  return row_of<WeldJoint>(scene, points, by);
}
// [taut_scenes]

} // namespace cookbook
