#pragma once

/// \file
/// \brief Bodies that rest may sleep: when islands of them fall asleep, and what wakes them.

#include "03_sphere_manifolds/collision/motion.hpp"
#include "05_resolution/damping/damping.hpp"
#include "06_world/islands/find_islands.hpp"
#include "common/math/vector.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace cookbook
{

// [sleep_state]
/// How little a body must move, and for how long, before it may sleep.
template <class Real>
struct SleepLimits
{
  Real speed = Real(0.05);         ///< [m/s], of its fastest point, at any time
  Real displacement = Real(0.002); ///< [m], all that its fastest point goes in the time
  Real change = Real(0.005);       ///< [m/s], between its velocity at the start and at any time
  Real time = Real(0.5);           ///< [s]
  Real damping = Real(2);          ///< [1/s], of what is not faster and lies on something
};

/// What is known of a body that is watched until it rests.
template <class Real>
struct SleepState
{
  Vector3<Real> velocity = Vector3<Real>::Zero();         ///< [m/s], when the watch began
  Vector3<Real> angular_velocity = Vector3<Real>::Zero(); ///< [rad/s], when the watch began
  Real displacement = Real(0);                            ///< [m], gone since
  Real time_at_rest = Real(0);                            ///< [s], since the watch began
  bool asleep = false;      ///< whether the body is left out of the simulation
  bool island_rests = true; ///< at the first body of an island: whether all of it may sleep
};

/// By what the velocities of a body that lies on something are multiplied in a step [s]; R32.
///
/// A sphere that rolls on the spot in a heap, or spins there, would do so for ever, and keep all
/// awake: no friction opposes that. So slow a motion is what sleep ends anyway.
template <class Real>
Real rest_damping(
    const Vector3<Real>& velocity, const Vector3<Real>& angular_velocity, const Real& radius,
    const Real& step, const SleepLimits<Real>& limits)
{
  const bool slow = fastest_point(velocity, angular_velocity, radius) <= limits.speed;
  return slow ? damping_factor(limits.damping, step) : Real(1);
}

/// The watch of an awake body a step [s] later; it begins anew where the body has moved too much.
///
/// A velocity that is not a number is too much.
template <class Real>
SleepState<Real> update_sleep_state(
    SleepState<Real> state, const Vector3<Real>& velocity, const Vector3<Real>& angular_velocity,
    const Real& radius, const Real& step, const SleepLimits<Real>& limits)
{
  const Real speed = fastest_point(velocity, angular_velocity, radius);
  const Real change = fastest_point<Real>(
      velocity - state.velocity, angular_velocity - state.angular_velocity, radius);
  const Real displacement = state.displacement + step * speed;
  if (speed <= limits.speed && displacement <= limits.displacement && change <= limits.change)
  {
    state.displacement = displacement;
    state.time_at_rest += step;
    return state;
  }
  return {velocity, angular_velocity, Real(0), Real(0), false};
}

/// Whether a body has been watched long enough.
template <class Real>
bool may_sleep(const SleepState<Real>& state, const SleepLimits<Real>& limits)
{
  return state.time_at_rest >= limits.time;
}
// [sleep_state]

// [update_sleep]
/// Puts to sleep every island all of whose bodies may, and wakes every other.
template <class Real>
void update_sleep(
    std::vector<SleepState<Real>>& states, const std::vector<int>& island_of,
    const SleepLimits<Real>& limits)
{
  const auto island_rests = [&](std::size_t i) -> bool&
  { return states[static_cast<std::size_t>(island_of[i])].island_rests; };
  for (SleepState<Real>& state : states)
  {
    state.island_rests = true;
  }
  for (std::size_t i = 0; i < states.size(); ++i)
  {
    if (island_of[i] >= 0 && !may_sleep(states[i], limits))
    {
      island_rests(i) = false;
    }
  }
  for (std::size_t i = 0; i < states.size(); ++i)
  {
    if (island_of[i] >= 0 && states[i].asleep != island_rests(i))
    {
      const bool rests = island_rests(i);
      states[i] = rests ? states[i] : SleepState<Real>{};
      states[i].asleep = states[i].island_rests = rests;
    }
  }
}

/// Wakes the whole islands of some bodies: before one is removed, and when one is pushed or moved
/// by hand.
template <class Real>
void wake(
    std::vector<SleepState<Real>>& states, const std::vector<int>& island_of,
    std::span<const int> bodies)
{
  std::vector<bool> woken(states.size(), false);
  for (const int body : bodies)
  {
    const int island = island_of[static_cast<std::size_t>(body)];
    if (island >= 0)
    {
      woken[static_cast<std::size_t>(island)] = true;
    }
  }
  for (std::size_t i = 0; i < states.size(); ++i)
  {
    if (island_of[i] >= 0 && woken[static_cast<std::size_t>(island_of[i])])
    {
      states[i] = {};
    }
  }
}

/// Wakes the whole island of one body.
template <class Real>
void wake(std::vector<SleepState<Real>>& states, const std::vector<int>& island_of, int body)
{
  wake(states, island_of, std::span<const int>(&body, 1));
}
// [update_sleep]

} // namespace cookbook
