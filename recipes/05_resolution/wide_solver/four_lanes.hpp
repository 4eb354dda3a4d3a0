#pragma once

/// \file
/// \brief Four bodies side by side: what solvers read and write of them, gathered and put back.

#include "05_resolution/contacts/rigid_body.hpp"
#include "common/simd/registers.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace cookbook
{

// [either]
/// In every lane the number of the first, if a test says so there; otherwise that of the second.
template <class Real, std::size_t Width, class Second>
Pack<Real, Width> either(
    const typename Pack<Real, Width>::Mask& first, const Pack<Real, Width>& yes,
    const Second& second)
{
  return all(first) ? yes : select(first, yes, Pack<Real, Width>(second()));
}

/// The same for each number of a vector or matrix.
template <class Real, std::size_t Width, int Rows, int Columns, class Second>
Eigen::Matrix<Pack<Real, Width>, Rows, Columns> either(
    const typename Pack<Real, Width>::Mask& first,
    const Eigen::Matrix<Pack<Real, Width>, Rows, Columns>& yes, const Second& second)
{
  Eigen::Matrix<Pack<Real, Width>, Rows, Columns> chosen = yes;
  if (!all(first))
  {
    const Eigen::Matrix<Pack<Real, Width>, Rows, Columns> no = second();
    for (int i = 0; i < yes.size(); ++i)
    {
      chosen(i) = select(first, yes(i), no(i));
    }
  }
  return chosen;
}
// [either]

// [four_lanes]
/// Four floats, computed with at once: one of each of four contacts.
using Four = Registers<float>;

/// What a solver needs of a body, in float, so that four of them are gathered by whole rows.
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
// [four_lanes]

// [gather]
/// Four rows of four numbers, as columns: the first number of each, the second, …
template <class Row>
std::array<Four, 4>
gathered(std::span<LaneBody> bodies, const std::array<int, 4>& of, const Row& row)
{
  Four rows[4];
  for (std::size_t lane = 0; lane < 4; ++lane)
  {
    rows[lane] = load_pack<Four>(row(bodies[static_cast<std::size_t>(of[lane])]));
  }
  transpose(rows);
  return {rows[0], rows[1], rows[2], rows[3]};
}

/// How four bodies move now.
inline void gather_motion(std::span<LaneBody> bodies, const std::array<int, 4>& of, Body<Four>& to)
{
  const auto v = gathered(bodies, of, [](LaneBody& body) { return body.velocity; });
  const auto w = gathered(bodies, of, [](LaneBody& body) { return body.angular_velocity; });
  to.motion.velocity = {v[0], v[1], v[2]};
  to.motion.angular_velocity = {w[0], w[1], w[2]};
}

/// How much a push changes each of four bodies.
inline void
gather_inverse_masses(std::span<LaneBody> bodies, const std::array<int, 4>& of, Body<Four>& to)
{
  for (int i = 0; i < 3; ++i)
  {
    const auto column = gathered(bodies, of, [i](LaneBody& body) { return body.inertia[i]; });
    to.inverse_inertia.col(i) = Vector3<Four>(column[0], column[1], column[2]);
    if (i == 0)
    {
      to.inverse_mass = column[3];
    }
  }
}

/// Puts three numbers of four bodies back.
template <class Row>
void scatter(
    const Vector3<Four>& from, std::span<LaneBody> bodies, const std::array<int, 4>& of,
    const Row& row)
{
  Four rows[] = {from.x(), from.y(), from.z(), Four(0)};
  transpose(rows);
  for (std::size_t lane = 0; lane < 4; ++lane)
  {
    store_pack(rows[lane], row(bodies[static_cast<std::size_t>(of[lane])]));
  }
}

/// Puts back how four bodies move.
inline void
scatter_motion(const Body<Four>& from, std::span<LaneBody> bodies, const std::array<int, 4>& of)
{
  scatter(from.motion.velocity, bodies, of, [](LaneBody& body) { return body.velocity; });
  scatter(
      from.motion.angular_velocity, bodies, of,
      [](LaneBody& body) { return body.angular_velocity; });
}
// [gather]

} // namespace cookbook
