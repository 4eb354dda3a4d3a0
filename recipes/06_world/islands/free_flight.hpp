#pragma once

/// \file
/// \brief Bodies of a world that nothing touches: gravity, forces and spin.

#include "06_world/contacts/integrate_body.hpp"

namespace cookbook
{

// [free_flight]
/// Has what pulls a body alone move it for a time [s]: exactly along its parabola.
inline void integrate_free_flight(RigidBody& body, const ExternalAcceleration& by, double time)
{
  body.motion.center += time * (body.motion.velocity + time / 2 * by.acceleration);
  apply_forces(body, by, time);
  rotate_freely(body, time);
  body.lagged_orientation = body.orientation; // nothing pushes it at any
}
// [free_flight]

} // namespace cookbook
