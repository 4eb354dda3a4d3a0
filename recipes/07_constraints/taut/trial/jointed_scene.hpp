#pragma once

/// \file
/// \brief Bodies and their ball joints, and a chain of them.

#include "06_world/ball_joint/ball_joint.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"

#include <cstddef>
#include <vector>

namespace cookbook
{

// [jointed_world]
/// A ball joint of two bodies, by their places in a scene, at a point [m], world.
struct JointPlace
{
  int a, b;
  Vector3<double> point;
};

/// Bodies and their ball joints.
struct JointedScene
{
  Scene scene;
  std::vector<JointPlace> joints;
};

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

/// Adds ball joints to a world of their scene, as one set.
inline void add_ball_joints(GameWorld& world, const std::vector<JointPlace>& places)
{
  BallJoints joints;
  for (const JointPlace& one : places)
  {
    joints.add(
        ball_joint_at(world, static_cast<BodyId>(one.a), static_cast<BodyId>(one.b), one.point));
  }
  world.add(joints);
}

/// A world of it with a solver, at so many steps a second. Bodies do not touch.
inline GameWorld jointed_world(JointedScene of, const WorldSolver& solver, int rate = 60)
{
  of.scene.step = 1.0 / rate;
  GameWorld world(without_contacts(of.scene), solver);
  add_ball_joints(world, of.joints);
  return world;
}

/// Links of half a metre, one below the other from a fixed hook [m], each with a mass [kg], turned
/// about the hook by an angle with this sine and cosine; and at their end, unless its mass is zero,
/// a cube of 50 cm.
inline JointedScene chain_of(
    const std::vector<double>& masses, double sine = 0, double cosine = 1, double load = 0,
    const Vector3<double>& hook = {0, 0, 0})
{
  const Vector3<double> down(sine, -cosine, 0);
  JointedScene chain{{.bodies = {box_body("hook", {0.1, 0.1, 0.1}, hook, 0)}}, {}};
  const auto hang = [&](SceneBody body, double above)
  {
    const int upper = static_cast<int>(chain.joints.size());
    body.orientation = turn_about_z(sine, cosine);
    chain.scene.bodies.push_back(body);
    chain.joints.push_back({upper, upper + 1, hook + above * down});
  };
  for (std::size_t i = 0; i < masses.size(); ++i)
  {
    const double above = 0.5 * static_cast<double>(i);
    hang(box_body("link", {0.05, 0.25, 0.05}, hook + (above + 0.25) * down, masses[i]), above);
  }
  if (load > 0)
  {
    const double above = 0.5 * static_cast<double>(masses.size());
    hang(box_body("load", {0.25, 0.25, 0.25}, hook + (above + 0.25) * down, load), above);
  }
  return chain;
}
// [jointed_world]

} // namespace cookbook
