#pragma once

/// \file
/// \brief How bodies move, gathered into packs and put back.

#include "05_resolution/impulse/body.hpp"
#include "06_world/lanes/each_number.hpp"
#include "06_world/wide_solver/lane_body.hpp"
#include "common/simd/pack.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace cookbook
{

// [gather]
/// Fours read from where `four(i)` points, i from a first one on, side by side.
template <class Lanes, class Four>
Lanes load_fours(const Four& four, std::size_t first = 0)
{
  if constexpr (lanes_of<Lanes> == 4)
  {
    return load_pack<Lanes>(four(first));
  }
  else
  {
    using Half = Pack<float, lanes_of<Lanes> / 2>;
    const Half low = load_fours<Half>(four, first);
    const Half high = load_fours<Half>(four, first + lanes_of<Lanes> / 8);
    return [&]<std::size_t... I>(std::index_sequence<I...>)
    {
      return Half::template shuffled<I...>(low, high);
    }
    (std::make_index_sequence<lanes_of<Lanes>>());
  }
}

/// Fours written to where `four(i)` points, i from a first one on.
template <class Lanes, class Four>
void store_fours(const Lanes& from, const Four& four, std::size_t first = 0)
{
  if constexpr (lanes_of<Lanes> == 4)
  {
    store_pack(from, four(first));
  }
  else
  {
    constexpr std::size_t half = lanes_of<Lanes> / 2;
    [&]<std::size_t... I>(std::index_sequence<I...>)
    {
      store_fours(Lanes::template shuffled<I...>(from, from), four, first);
      store_fours(Lanes::template shuffled<half + I...>(from, from), four, first + half / 4);
    }
    (std::make_index_sequence<half>());
  }
}

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
  transpose_fours(rows[0], rows[1], rows[2], rows[3]);
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
  transpose_fours(rows[0], rows[1], rows[2], rows[3]);
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
