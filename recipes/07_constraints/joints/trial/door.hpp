#pragma once

/// \file
/// \brief A door that is thrown against its limit.

#include "06_world/game_world/solvers.hpp"
#include "07_constraints/hinge/hinge.hpp"

#include <algorithm>
#include <string>

namespace cookbook
{

// [door]
/// A door of 20 kg and 1 m, which turns with 10 rad/s towards its limit at 1.5 rad.
inline GameWorld door_world(const std::string& solver)
{
  SceneBody leaf{.name = "door", .shape = BoxShape{{0.5, 1, 0.02}}, .mass = 20};
  leaf.position = {0.5, 0, 0};
  leaf.velocity = {0, 0, -5};
  leaf.angular_velocity = {0, 10, 0};
  const SceneBody post{.name = "post", .shape = BoxShape{{0.05, 1, 0.05}}};
  GameWorld world({.bodies = {post, leaf}}, solver_named(solver));
  HingeJoint hinge = hinge_at(world, 0, 1, {0, 0, 0}, {0, 1, 0});
  hinge.drive = {.lower = -1.5, .upper = 1.5};
  HingeJoints hinges;
  hinges.add(hinge);
  world.add(hinges);
  return world;
}

/// How far [rad] it went past its limit, and how fast [rad/s] it came back.
struct DoorEnd
{
  double overshoot = 0, rebound = 0;
};

/// That of the door within a second at 60 steps a second.
inline DoorEnd end_of_door(const std::string& solver)
{
  GameWorld world = door_world(solver);
  DoorEnd end;
  for (int i = 0; i < 60; ++i)
  {
    world.step();
    end.overshoot = std::max(end.overshoot, world.constraints<HingeJoints>(0)[0].angle - 1.5);
    end.rebound = std::max(end.rebound, -world.body(1).motion.angular_velocity.y());
  }
  return end;
}
// [door]

} // namespace cookbook
