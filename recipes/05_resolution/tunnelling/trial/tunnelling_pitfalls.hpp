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
FlyingBall<Real> speculative_bounce_step(
    const FlyingBall<Real>& flight, const Obb<Real>& wall, const Real& restitution,
    const Real& step)
{
  const Direction<Real> ahead = gap_to(flight.ball, wall);
  const Vector3<Real> braked = speculative_velocity<Real>(
      flight.velocity, ahead.unit, std::max(ahead.length, Real(0)), step);
  const bool brakes = braked != flight.velocity;
  return {
      moved<Real>({flight.ball, braked}, step).ball,
      brakes ? bounced(flight.velocity, ahead.unit, restitution) : flight.velocity};
}

// [box_sweep_pitfalls]
/// Looks at the end of the way only: time 1 where the boxes overlap there.
template <class Real>
std::optional<Real> touch_at_end(const SweptBox<Real>& a, const SweptBox<Real>& b)
{
  const bool overlap = box_gap(box_at(a, Real(1)), box_at(b, Real(1))).length <= Real(0);
  return overlap ? std::optional<Real>(Real(1)) : std::nullopt;
}

/// Halves the way between far and near until the gap is `touching` [m], and takes it for granted
/// that there is such a time. Nothing after `most` halvings, where the loop would run on.
template <class Real>
std::optional<Real>
touch_by_halving(const SweptBox<Real>& a, const SweptBox<Real>& b, Real touching, int most)
{
  Real clear(0), touches(1);
  for (int i = 0; i < most; ++i)
  {
    const Real middle = (clear + touches) / Real(2);
    const Real gap = box_gap(box_at(a, middle), box_at(b, middle)).length;
    if (gap >= Real(0) && gap <= touching)
    {
      return middle;
    }
    (gap > touching ? clear : touches) = middle;
  }
  return std::nullopt;
}

/// Advances by the gap and the velocities of the centres: turning is left out of the bound.
template <class Real>
std::optional<Real>
touch_without_turning(const SweptBox<Real>& a, const SweptBox<Real>& b, Real touching)
{
  Real time(0);
  for (int i = 0; i < most_box_advances; ++i)
  {
    const Direction<Real> gap = box_gap(box_at(a, time), box_at(b, time));
    const Real closing = (a.displacement - b.displacement).dot(gap.unit);
    if (gap.length <= touching)
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
