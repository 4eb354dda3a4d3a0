#pragma once

/// \file
/// \brief Ways to meet a fast body that fail somewhere, beside those of the page's own.

#include "05_resolution/tunnelling/swept_box.hpp"
#include "05_resolution/tunnelling/tunnelling.hpp"

namespace cookbook
{

/// Speculative without a margin; a ball that was braked gets the bounce of its full speed at once.
///
/// Restitution is kept. So is that of walls which the ball would have missed.
template <class Real>
MovingSphere<Real> speculative_bounce_step(
    const MovingSphere<Real>& flight, const Obb<Real>& wall, const Real& restitution,
    const Real& step)
{
  const Direction<Real> gap = direction_to(flight.sphere, wall);
  const Vector3<Real> braked =
      speculative_velocity<Real>(flight.velocity, gap.unit, std::max(gap.length, Real(0)), step);
  const bool brakes = braked != flight.velocity;
  return {
      moved<Real>({flight.sphere, braked}, step).sphere,
      brakes ? rebound_velocity(flight.velocity, gap.unit, restitution) : flight.velocity};
}

// [box_sweep_pitfalls]
/// Looks at the end of the way only: time 1 where the boxes overlap there.
template <class Real>
std::optional<Real> touch_at_end(const SweptBox<Real>& a, const SweptBox<Real>& b)
{
  const bool overlap = box_gap(box_at(a, Real(1)), box_at(b, Real(1))).length <= Real(0);
  return overlap ? std::optional<Real>(Real(1)) : std::nullopt;
}

/// Halves the way between far and near until the gap is `tolerance` [m], and takes it for granted
/// that there is such a time. Nothing after `most` halvings, where the loop would run on.
template <class Real>
std::optional<Real>
touch_by_halving(const SweptBox<Real>& a, const SweptBox<Real>& b, Real tolerance, int most)
{
  Real clear(0), touches(1);
  for (int i = 0; i < most; ++i)
  {
    const Real middle = (clear + touches) / Real(2);
    const Real gap = box_gap(box_at(a, middle), box_at(b, middle)).length;
    if (gap >= Real(0) && gap <= tolerance)
    {
      return middle;
    }
    (gap > tolerance ? clear : touches) = middle;
  }
  return std::nullopt;
}

/// Advances by the gap and the velocities of the centres: turning is left out of the bound.
template <class Real>
std::optional<Real>
touch_without_turning(const SweptBox<Real>& a, const SweptBox<Real>& b, Real tolerance)
{
  Real time(0);
  for (int i = 0; i < max_box_advances; ++i)
  {
    const Direction<Real> gap = box_gap(box_at(a, time), box_at(b, time));
    const Real closing = (a.displacement - b.displacement).dot(gap.unit);
    if (gap.length <= tolerance)
    {
      return time;
    }
    time += gap.length / closing;
    if (!(closing > Real(0)) || time > Real(1))
    {
      return std::nullopt;
    }
  }
  return time;
}
// [box_sweep_pitfalls]

} // namespace cookbook
