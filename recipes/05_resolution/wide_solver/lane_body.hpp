#pragma once

/// \file
/// \brief What the wide solver reads and writes of a body: floats in rows of four.

#include "05_resolution/contacts/rigid_body.hpp"

namespace cookbook
{

// [lane_body]
/// What a solver needs of a body, in float, so that those of several are gathered by whole rows.
struct LaneBody
{
  alignas(16) float velocity[4] = {};         ///< [m/s], world; the last is not used
  alignas(16) float angular_velocity[4] = {}; ///< [rad/s], world; the last is not used
  alignas(16) float inertia[3][4] = {};       ///< [1/(kg m²)], columns of the inverse; see below
  /// The inverse mass [1/kg].
  float& inverse_mass() { return inertia[0][3]; }
};

/// Copies three numbers.
inline void put(const Vector3<double>& from, float (&to)[4])
{
  for (int i = 0; i < 3; ++i)
  {
    to[i] = static_cast<float>(from[i]);
  }
}

/// Copies how a body moves.
inline void put_motion(const RigidBody& from, LaneBody& to)
{
  put(from.motion.velocity, to.velocity);
  put(from.motion.angular_velocity, to.angular_velocity);
}

/// Copies how much a push changes a body.
inline void put_inverse_masses(const RigidBody& from, LaneBody& to)
{
  for (int i = 0; i < 3; ++i)
  {
    put(from.inverse_inertia.col(i), to.inertia[i]);
  }
  to.inverse_mass() = static_cast<float>(from.inverse_mass);
}

/// Takes three numbers back, unless they are still what was put.
inline void take_changed(const float (&from)[4], Vector3<double>& to)
{
  float put_then[4];
  put(to, put_then);
  if (from[0] != put_then[0] || from[1] != put_then[1] || from[2] != put_then[2])
  {
    to = {from[0], from[1], from[2]};
  }
}

/// Takes back how a body moves; what nothing has pushed keeps every digit that it had.
inline void take_motion(const LaneBody& from, RigidBody& to)
{
  take_changed(from.velocity, to.motion.velocity);
  take_changed(from.angular_velocity, to.motion.angular_velocity);
}
// [lane_body]

} // namespace cookbook
