#pragma once

/// \file
/// \brief What a run of a scene leaves behind: where every body is, and how it moves, in time.

#include "06_world/contacts/scene.hpp"

#include <cmath>
#include <stdexcept>

namespace cookbook
{

/// Where a body is, and how it moves.
struct BodyState
{
  Vector3<double> position;         ///< [m], world, centre of mass
  Quaternion<double> orientation;   ///< unit, body to world
  Vector3<double> velocity;         ///< [m/s], world
  Vector3<double> angular_velocity; ///< [rad/s], world
};

/// All bodies of a scene at one time.
struct Frame
{
  double time;                   ///< [s], from the scene's start
  std::vector<BodyState> bodies; ///< in the scene's order, fixed ones among them
};

/// The frame with which a scene starts.
inline Frame first_frame(const Scene& scene)
{
  Frame frame{0, {}};
  for (const SceneBody& body : scene.bodies)
  {
    frame.bodies.push_back({body.position, body.orientation, body.velocity, body.angular_velocity});
  }
  return frame;
}

/// The frame closest to a time [s], the earlier of two; std::invalid_argument where there is none.
inline const Frame& frame_at(const std::vector<Frame>& frames, double time)
{
  if (frames.empty())
  {
    throw std::invalid_argument("there are no frames");
  }
  const Frame* best = &frames.front();
  for (const Frame& frame : frames)
  {
    // A millionth of a second is no difference: times are sums of steps, each rounded.
    best = std::abs(frame.time - time) + 1e-6 < std::abs(best->time - time) ? &frame : best;
  }
  return *best;
}

} // namespace cookbook
