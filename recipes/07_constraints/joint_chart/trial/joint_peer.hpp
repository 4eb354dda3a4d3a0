#pragma once

/// \file
/// \brief Another engine as a solver of a world: it steps its own copy of a jointed scene, and the
/// bodies of the world follow.

#include "06_world/islands/previous_state.hpp"
#include "06_world/scenes/trial/frames.hpp"
#include "07_constraints/joint_trial/trial/joint_scenes.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <utility>

namespace cookbook
{

// [joint_peer]
/// A jointed scene in an engine.
struct JointPeer
{
  std::function<void()> go;     ///< on by a frame of 1/60 s: this is what is timed
  std::function<Frame()> state; ///< where its bodies are, in the scene's order
};

/// The solver that has such an engine move a world's bodies, a frame a step. What is measured of
/// a world is so measured of the engine.
inline WorldSolver follow(JointPeer peer)
{
  return [peer = std::move(peer)](IslandView world, std::span<const Island>, double)
  {
    peer.go();
    const Frame now = peer.state();
    for (std::size_t i = 0; i < now.bodies.size(); ++i)
    {
      const BodyState& is = now.bodies[i];
      world.bodies[i] = with_state(
          world.bodies[i], {{is.position, is.velocity, is.angular_velocity}, is.orientation});
    }
  };
}
// [joint_peer]

} // namespace cookbook
