#pragma once

/// \file
/// \brief Bodies that turn by themselves, one in every lane of a pack of doubles.

#include "05_resolution/spinning_bodies/mean_spin.hpp"
#include "06_world/lanes/each_number.hpp"

#include <cstddef>

namespace cookbook
{

// [turn_in_lanes]
/// A register of doubles, where `Lanes` is one of floats.
template <class Lanes>
using Doubles = Pack<double, lanes_of<Lanes> / 2>;

/// A body that turns by itself.
template <class Real>
struct TurningLane
{
  Spinning<Real> now;    ///< how it is turned, and how it spins
  Vector3<Real> moments; ///< [kg m²]
};

/// Its numbers, in the order in which they lie in memory: first what changes.
template <class Real, class Call>
void each_turned(TurningLane<Real>& of, Call& call)
{
  each_number(of.now.orientation.coeffs(), call);
  each_number(of.now.angular_velocity, call);
}

/// Then what stays.
template <class Real, class Call>
void each_stored(TurningLane<Real>& of, Call& call)
{
  each_number(of.moments, call);
}

inline constexpr std::size_t turning_numbers = 10; ///< all of a body

/// Turns the bodies of a pack for a time [s] in which they turn little; see turned_about_mean().
template <class Lanes>
[[gnu::flatten]] void turn_in_lanes(double* numbers, double time)
{
  TurningLane<Lanes> of;
  ReadLanes<Lanes> read{numbers};
  each_turned(of, read);
  each_stored(of, read);
  of.now = turned_about_mean<Lanes>(of.now, of.moments, time);
  WriteLanes<Lanes> write{numbers};
  each_turned(of, write);
}
// [turn_in_lanes]

} // namespace cookbook
