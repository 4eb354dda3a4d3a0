#pragma once

/// \file
/// \brief Scenes for AVBD: a cable, a loaded chain, a tower.

#include "06_world/game_world/solvers.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "07_constraints/avbd/avbd.hpp"
#include "07_constraints/avbd/plain_avbd.hpp"
#include "07_constraints/rope/rope.hpp"
#include "07_constraints/taut/trial/taut_scenes.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace cookbook
{

// [avbd_scenes]
/// By how much [m] the sag of a cable is off after 20 s: 10 m in 40 links between poles 8 m apart,
/// 2.65526 m is right for so many links.
inline double cable_off(const AvbdSettings& settings)
{
  Rope cable = make_rope({0, 0, 0}, {8, 0, 0}, 40, 10);
  for (DistanceConstraint& link : cable.links)
  {
    link.length = 0.25;
  }
  cable.particles.inverse_masses.front() = cable.particles.inverse_masses.back() = 0;
  std::vector<AvbdMemory> memories;
  for (int frame = 0; frame < 1200; ++frame)
  {
    step_plain_avbd(
        cable.particles, cable.links, memories, {.damping = 2, .iterations = settings.iterations},
        settings);
  }
  return std::abs(-cable.particles.positions[20].y() - 2.65526);
}

/// By how much [m] the load [kg] on a chain of twenty links of 1 kg has sunk after 10 s.
inline double chain_sink(double load, const AvbdSettings& settings)
{
  GameWorld world = world_of(TrialChain{.load = load}, one_by_one(Avbd(settings)));
  for (int step = 0; step < 600; ++step)
  {
    world.step();
  }
  return 9.75 - world.body(21).motion.center.y();
}

/// By how much [m] the topmost cube of a tower has sunk after 10 s.
inline double tower_sink(int cubes, const AvbdSettings& settings)
{
  Scene scene{.bodies = {ground()}};
  for (int i = 0; i < cubes; ++i)
  {
    scene.bodies.push_back(cube_body("cube", {0, 0.5 + i, 0}));
  }
  GameWorld world(scene, one_by_one(Avbd(settings)));
  for (int step = 0; step < 600; ++step)
  {
    world.step();
  }
  return cubes - 0.5 - world.body(static_cast<BodyId>(cubes)).motion.center.y();
}
// [avbd_scenes]

} // namespace cookbook
