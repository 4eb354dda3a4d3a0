#pragma once

/// \file
/// \brief What the wide solver reads and writes of a body: floats in rows of four.

#include "06_world/contacts/rigid_body.hpp"

namespace cookbook
{

/// What a solver needs of a body, in float: one line of a cache, so that those of several are
/// gathered by whole rows. The last number of how it moves is not used.
struct alignas(64) LaneBody
{
  float velocity[4] = {};         ///< [m/s], world
  float angular_velocity[4] = {}; ///< [rad/s], world
  float inverse_masses[4] = {};   ///< mass [1/kg], then xx, xy, yy of inertia [1/(kg m²)], world
  float inverse_inertia[4] = {}; ///< of the same xz, yz, zz; then how fast [m/s] it leaves overlaps
};

/// Copies three numbers, or four.
template <int Size>
void put(const Eigen::Matrix<double, Size, 1>& from, float (&to)[4])
{
  for (int i = 0; i < Size; ++i)
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
  const Matrix3<double>& inertia = from.inverse_inertia;
  put<4>({from.inverse_mass, inertia(0, 0), inertia(0, 1), inertia(1, 1)}, to.inverse_masses);
  put<3>(inertia.col(2), to.inverse_inertia);
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

} // namespace cookbook
