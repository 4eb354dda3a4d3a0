#pragma once

/// \file
/// \brief Conservative advancement: when a moving sphere first touches a convex shape.

#include "common/math/norm.hpp"

#include <limits>
#include <optional>

namespace cookbook
{

/// The first touch of a moving sphere.
template <class Real>
struct SweptHit
{
  Real time;            ///< [1], the fraction of the displacement that is free, 0 to 1
  Vector3<Real> normal; ///< [1], unit, world, from the sphere to what it touches
};

// [first_touch]
/// What a moving sphere sees of a convex shape, at one time; rates are those of the whole time.
template <class Real>
struct GapState
{
  Direction<Real> gap; ///< to the nearest point of the shape's surface, and how far it is [m]
  Real closing;        ///< [m], what the gap loses at the present rate
  Real acceleration = Real(0); ///< [m], how fast that rate grows by itself, where it is steady
};

/// How long a gap [m] lasts that loses `closing` [m] in the whole time, a rate that grows by no
/// more than `acceleration_bound` [m] in that time; P23. Without end if it loses nothing.
template <class Real>
Real safe_time(const Real& gap, const Real& closing, const Real& acceleration_bound)
{
  using std::sqrt;
  if (!(closing > Real(0)) && !(acceleration_bound > Real(0)))
  {
    return std::numeric_limits<Real>::max();
  }
  const Real root = acceleration_bound > Real(0)
                        ? sqrt(closing * closing + Real(2) * acceleration_bound * gap)
                        : closing;
  return closing > Real(0) ? Real(2) * gap / (closing + root)
                           : (root - closing) / acceleration_bound;
}

/// The most steps that an advance takes.
inline constexpr int max_advances = 64;

/// Advances a sphere by what its gap allows, again and again, until it touches; P20.
///
/// `query(time)` is the outlook at a time, from `start` to 1. On a path that curves, or past a
/// shape that turns, the gap closes faster and faster, but by no more than `acceleration_bound` [m]
/// in the whole time. Gaps and approaches up to `rounding` [m] count as none. Nothing where the
/// sphere never touches or parts for good; the start where it overlaps there and goes on inwards.
/// After `max_advances` it stops short, where it is: it has not touched yet.
template <class Real, class Query>
std::optional<SweptHit<Real>> first_touch(
    const Real& start, const Real& acceleration_bound, const Real& rounding, const Query& query)
{
  using std::max;
  const bool bends = acceleration_bound > Real(0);
  Real time = start;
  GapState<Real> now = query(time);
  for (int i = 0; i < max_advances; ++i)
  {
    const Real closing = now.closing, gap = max(now.gap.length, Real(0));
    const bool closes = closing > rounding || (closing >= -rounding && now.acceleration > rounding);
    if (!closes && !bends)
    {
      return std::nullopt;
    }
    if (closes && gap <= rounding)
    {
      return SweptHit<Real>{time, now.gap.unit};
    }
    const Real safe = safe_time(gap, closing, acceleration_bound);
    const bool stuck = bends && (gap <= rounding || 2 * i >= max_advances);
    time += stuck ? max(safe, Real(2) / Real(max_advances)) : safe;
    if (!(time <= Real(1)))
    {
      return std::nullopt;
    }
    now = query(time);
  }
  return SweptHit<Real>{time, now.gap.unit};
}

/// The same straight past a shape that stands still: `gap(offset)` is the direction to it and how
/// far away it is [m], once the sphere has moved by `offset` [m] of a displacement [m].
template <class Real, class Gap>
std::optional<SweptHit<Real>>
first_touch(const Vector3<Real>& displacement, const Real& rounding, const Gap& gap)
{
  return first_touch<Real>(
      Real(0), Real(0), rounding,
      [&](const Real& time)
      {
        const Direction<Real> direction = gap(Vector3<Real>(time * displacement));
        return GapState<Real>{direction, displacement.dot(direction.unit)};
      });
}
// [first_touch]

} // namespace cookbook
