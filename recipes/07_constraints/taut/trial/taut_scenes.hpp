#pragma once

/// \file
/// \brief Chains, bridges, cantilevers and loops on trial, and how far their joints come apart.

#include "06_world/game_world/direct_or_soft.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "07_constraints/taut/taut.hpp"
#include "07_constraints/taut/trial/taut_joints.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace cookbook
{

// [taut_scenes]
/// Has no two bodies of a scene touch: what is measured are its joints.
inline Scene without_contacts(Scene scene)
{
  const int count = static_cast<int>(scene.bodies.size());
  for (int i = 0; i < count; ++i)
  {
    for (int j = i + 1; j < count; ++j)
    {
      scene.ignored.emplace_back(i, j);
    }
  }
  return scene;
}

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

/// A chain as it starts.
inline GameWorld world_of(const TrialChain& chain, const WorldSolver& by = directly())
{
  const double length = 0.5;
  const Vector3<double> hook(0, 20, 0), along(chain.towards.x(), -chain.towards.y(), 0);
  const Quaternion<double> turn = turn_about_z(chain.towards.x(), chain.towards.y());
  Scene scene{.bodies = {box_body("hook", {0.1, 0.1, 0.1}, hook, 0)}};
  std::vector<Vector3<double>> points;
  for (int i = 0; i < chain.links; ++i)
  {
    SceneBody link = box_body(
        "link", {0.05, length / 2, 0.05}, hook + length * (i + 0.5) * along,
        i % 2 == 1 ? chain.light : 1);
    link.velocity.x() = i == chain.links / 2 ? chain.nudge : 0;
    scene.bodies.push_back(link);
    points.push_back(hook + length * i * along);
  }
  if (chain.load > 0)
  {
    const Vector3<double> end = hook + length * chain.links * along;
    scene.bodies.push_back(box_body("load", {0.25, 0.25, 0.25}, end + 0.25 * along, chain.load));
    points.push_back(end);
  }
  for (SceneBody& body : scene.bodies)
  {
    body.orientation = turn;
  }
  return row_of<BallJoint>(scene, points, by);
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
  return row_of<TrialWeld>(scene, points, by);
}

/// Links in a ring that hangs on a hook, each next one turned by 1/12 of a turn, and the last one
/// on the hook again.
inline GameWorld hanging_ring(const WorldSolver& by = directly())
{
  Scene scene{.bodies = {box_body("hook", {0.1, 0.1, 0.1}, {0, 5, 0}, 0)}};
  std::vector<Vector3<double>> points{{0, 5, 0}};
  const double cosine = std::sqrt(3.0) / 2;
  Vector2<double> along(-1, 0);
  for (int i = 0; i < 12; ++i)
  {
    const Vector3<double> reach(0.5 * along.x(), 0.5 * along.y(), 0);
    SceneBody link = box_body("link", {0.25, 0.05, 0.05}, points.back() + reach / 2);
    link.orientation = Quaternion<double>::FromTwoVectors(Vector3<double>::UnitX(), reach);
    scene.bodies.push_back(link);
    points.push_back(points.back() + reach);
    along = {cosine * along.x() - along.y() / 2, along.x() / 2 + cosine * along.y()};
  }
  const Vector3<double> end = points.back();
  points.pop_back();
  GameWorld world = row_of<BallJoint>(scene, points, by);
  BallJoints closing;
  closing.add(ball_joint_at(world, 12, 0, end));
  world.add(closing);
  return world;
}
// [taut_scenes]

} // namespace cookbook
