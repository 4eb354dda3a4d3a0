#pragma once

/// \file
/// \brief Scenes on which solvers of joints are tried, each with what is right in it.

#include "06_world/ball_joint/ball_joint.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "07_constraints/taut/taut.hpp"
#include "07_constraints/taut/trial/taut_scenes.hpp"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace cookbook
{

// [jointed_scene]
/// Twenty links of 1 kg, and a cube of 50 cm with a mass [kg] at their end.
inline JointedScene loaded_chain_of(double load, double sine = 0, double cosine = 1)
{
  return chain_of(std::vector<double>(20, 1.0), sine, cosine, load);
}

/// The same, hanging, its middle link pushed aside at a speed [m/s].
inline JointedScene nudged_chain(double load, double speed = 0.5)
{
  JointedScene chain = loaded_chain_of(load);
  chain.scene.bodies[10].velocity = {speed, 0, 0};
  return chain;
}

/// A chain with 100 kg, let go 45° from hanging.
inline JointedScene swung_chain()
{
  return loaded_chain_of(100, std::sqrt(0.5), std::sqrt(0.5));
}

/// The energy [J] of a chain that hangs with a load [kg], from the height of its hook.
inline double energy_hanging(double load)
{
  return -9.81 * (20 * 5 + 10.25 * load);
}

/// Ten links, 1 kg and 1,000 kg in turn.
inline JointedScene light_and_heavy()
{
  return chain_of({1, 1000, 1, 1000, 1, 1000, 1, 1000, 1, 1000});
}

/// A ball of 2 kg and 10 cm, its centre 1 m from a hook, let go at an angle with this sine and
/// cosine.
inline JointedScene pendulum_of(double sine, double cosine)
{
  return {
      {.bodies =
           {box_body("hook", {0.1, 0.1, 0.1}, {0, 0, 0}, 0),
            ball_body("bob", 0.1, {sine, -cosine, 0}, 2)}},
      {{0, 1, {0, 0, 0}}}};
}

/// Two boxes in space that turn about a point between them.
inline JointedScene tumbling_pair_of()
{
  Scene scene{.gravity = {0, 0, 0}};
  scene.bodies = {
      box_body("one", {0.1, 0.2, 0.3}, {0, 0, 0}, 1),
      box_body("other", {0.1, 0.5, 0.1}, {1, 0, 0}, 3)};
  scene.bodies[0].velocity = {1, 0, 0};
  scene.bodies[0].angular_velocity = {0, 2, 1};
  scene.bodies[1].velocity = {0, 1, 0};
  scene.bodies[1].angular_velocity = {3, 0, 1};
  return {scene, {{0, 1, {0.5, 0.1, 0}}}};
}

/// Twelve links of half a metre in a ring, which hangs from one of its joints: a closed loop.
inline JointedScene closed_ring()
{
  JointedScene ring{{.bodies = {box_body("hook", {0.1, 0.1, 0.1}, {0, 0, 0}, 0)}}, {}};
  const double tall = std::sqrt(3.0) / 2;
  const double cosines[] = {1, tall, 0.5, 0, -0.5, -tall, -1, -tall, -0.5, 0, 0.5, tall};
  Vector3<double> at(0, 0, 0);
  for (int i = 0; i < 12; ++i)
  {
    const double cosine = cosines[i], sine = -cosines[(i + 9) % 12]; // it goes on to the right
    const Vector3<double> along(cosine, sine, 0);
    SceneBody link = box_body("link", {0.25, 0.05, 0.05}, at + 0.25 * along, 1);
    link.orientation = i == 6 ? Quaternion<double>(0, 0, 0, 1) : turn_about_z(sine, cosine);
    ring.scene.bodies.push_back(link);
    ring.joints.push_back({i, i + 1, at});
    at += 0.5 * along;
  }
  ring.joints.push_back({12, 1, {0, 0, 0}});
  return ring;
}
// [jointed_scene]

// [bridge]
/// Thirty planks of 1 m and 20 kg between two hooks 28 m apart, as they hang at rest; R65.
inline JointedScene hanging_bridge()
{
  const HangingBridge planks{.planks = 30, .length = 1, .weight = 20 * 9.81, .span = 28};
  const std::vector<Vector2<double>> half = half_bridge(planks); // from the middle outwards
  JointedScene bridge{{.bodies = {box_body("hook", {0.1, 0.1, 0.1}, {0, 0, 0}, 0)}}, {}};
  Vector3<double> at(0, 0, 0);
  for (int i = 0; i < 30; ++i)
  {
    const Vector2<double> rise = half[static_cast<std::size_t>(i < 15 ? 14 - i : i - 15)];
    const Vector3<double> along(rise.x(), i < 15 ? -rise.y() : rise.y(), 0);
    SceneBody plank = box_body("plank", {0.5, 0.05, 0.5}, at + 0.5 * along, 20);
    plank.orientation = turn_about_z(along.y(), along.x());
    bridge.scene.bodies.push_back(plank);
    bridge.joints.push_back({i, i + 1, at});
    at += along;
  }
  bridge.scene.bodies.push_back(box_body("hook", {0.1, 0.1, 0.1}, at, 0));
  bridge.joints.push_back({30, 31, at});
  return bridge;
}
// [bridge]

/// A tower of ten cubes of 1 m: contacts, no joints.
inline Scene tower_of_ten()
{
  Scene scene{.bodies = {ground()}};
  for (int i = 0; i < 10; ++i)
  {
    scene.bodies.push_back(cube_body("cube", {0, 0.5 + i, 0}));
  }
  return scene;
}

} // namespace cookbook
