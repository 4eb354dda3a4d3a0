#pragma once

/// \file
/// \brief How bodies move, gathered into packs and put back.

#include "05_resolution/impulse/body.hpp"
#include "05_resolution/wide_solver/lane_body.hpp"
#include "common/simd/fours.hpp"

#include <array>
#include <cstddef>

namespace cookbook
{

// [gather]
/// The same row of four numbers of a body for each lane, as columns: the first of each, the second,
/// …
template <class Lanes, class Row>
std::array<Lanes, 4> gathered(LaneBody* bodies, const int* of, const Row& row)
{
  Lanes rows[4];
  for (std::size_t i = 0; i < 4; ++i)
  {
    rows[i] = load_fours<Lanes>(
        [&](std::size_t four) -> const float* { return row(bodies[of[4 * four + i]]); });
  }
  transpose(rows);
  return {rows[0], rows[1], rows[2], rows[3]};
}

/// The bodies of all lanes: how they move now, and their inverse masses, but not where they are;
/// and how fast [m/s] they leave overlaps.
template <class Lanes>
Lanes gather_body(LaneBody* bodies, const int* of, Body<Lanes>& to)
{
  const auto v = gathered<Lanes>(bodies, of, [](LaneBody& body) { return body.velocity; });
  const auto w = gathered<Lanes>(bodies, of, [](LaneBody& body) { return body.angular_velocity; });
  to.motion.velocity = {v[0], v[1], v[2]};
  to.motion.angular_velocity = {w[0], w[1], w[2]};
  const auto [inverse_mass, xx, xy, yy] =
      gathered<Lanes>(bodies, of, [](LaneBody& body) { return body.inverse_masses; });
  const auto k = gathered<Lanes>(bodies, of, [](LaneBody& body) { return body.inverse_inertia; });
  to.inverse_mass = inverse_mass;
  to.inverse_inertia.col(0) = Vector3<Lanes>(xx, xy, k[0]);
  to.inverse_inertia.col(1) = Vector3<Lanes>(xy, yy, k[1]);
  to.inverse_inertia.col(2) = Vector3<Lanes>(k[0], k[1], k[2]);
  return k[3];
}

/// Puts three numbers of the bodies of all lanes back.
template <class Lanes, class Row>
void scatter(const Vector3<Lanes>& from, LaneBody* bodies, const int* of, const Row& row)
{
  Lanes rows[] = {from.x(), from.y(), from.z(), Lanes(0)};
  transpose(rows);
  for (std::size_t i = 0; i < 4; ++i)
  {
    store_fours(rows[i], [&](std::size_t four) { return row(bodies[of[4 * four + i]]); });
  }
}

/// Puts back how they move.
template <class Lanes>
void scatter_motion(const Body<Lanes>& from, LaneBody* bodies, const int* of)
{
  scatter(from.motion.velocity, bodies, of, [](LaneBody& body) { return body.velocity; });
  scatter(
      from.motion.angular_velocity, bodies, of,
      [](LaneBody& body) { return body.angular_velocity; });
}
// [gather]

} // namespace cookbook
