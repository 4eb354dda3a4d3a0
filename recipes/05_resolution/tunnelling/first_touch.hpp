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
  Real time;            ///< [1], the share of the displacement that is free, 0 to 1
  Vector3<Real> normal; ///< [1], unit, world, from the sphere to what it touches
};

// [first_touch]
/// What a moving sphere sees of a convex shape, at one time; rates are those of the whole time.
template <class Real>
struct Outlook
{
  Direction<Real> ahead; ///< to the nearest point of the shape's surface, and how far it is [m]
  Real closing;          ///< [m], what the gap loses at the present rate
  Real pull = Real(0);   ///< [m], how fast that rate grows by itself, where it is steady
};

/// How long a gap [m] lasts that loses `closing` [m] in the whole time, a rate that grows by no
/// more than `bend` [m] in that time; P23. Without end if it loses nothing.
template <class Real>
Real lasting_time(const Real& gap, const Real& closing, const Real& bend)
{
  using std::sqrt;
  if (!(closing > Real(0)) && !(bend > Real(0)))
  {
    return std::numeric_limits<Real>::max();
  }
  const Real root = bend > Real(0) ? sqrt(closing * closing + Real(2) * bend * gap) : closing;
  return closing > Real(0) ? Real(2) * gap / (closing + root) : (root - closing) / bend;
}

/// The most steps that an advance takes.
inline constexpr int most_advances = 64;

/// Advances a sphere by what its gap allows, again and again, until it touches; P20.
///
/// `look(time)` is the outlook at a time, from `start` to 1. On a path that curves, or past a shape
/// that turns, the gap closes faster and faster, but by no more than `bend` [m] in the whole time.
/// Gaps and approaches up to `rounding` [m] count as none. Nothing where the sphere never touches
/// or parts for good; the start where it overlaps there and goes on inwards. After `most_advances`
/// it stops short, where it is: it has not touched yet.
template <class Real, class Look>
std::optional<SweptHit<Real>>
first_touch(const Real& start, const Real& bend, const Real& rounding, const Look& look)
{
  using std::max;
  const bool bends = bend > Real(0);
  Real time = start;
  Outlook<Real> now = look(time);
  for (int i = 0; i < most_advances; ++i)
  {
    const Real closing = now.closing, gap = max(now.ahead.length, Real(0));
    const bool closes = closing > rounding || (closing >= -rounding && now.pull > rounding);
    if (!closes && !bends)
    {
      return std::nullopt;
    }
    if (closes && gap <= rounding)
    {
      return SweptHit<Real>{time, now.ahead.unit};
    }
    const Real safe = lasting_time(gap, closing, bend);
    const bool stuck = bends && (gap <= rounding || 2 * i >= most_advances);
    time += stuck ? max(safe, Real(2) / Real(most_advances)) : safe;
    if (!(time <= Real(1)))
    {
      return std::nullopt;
    }
    now = look(time);
  }
  return SweptHit<Real>{time, now.ahead.unit};
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
        const Direction<Real> ahead = gap(Vector3<Real>(time * displacement));
        return Outlook<Real>{ahead, displacement.dot(ahead.unit)};
      });
}
// [first_touch]

} // namespace cookbook
