#pragma once

/// \file
/// \brief Between two orientations: at a constant rate, and along the straight line.

#include "01_math/rotations/unit_quaternion.hpp"
#include "common/math/trigonometry.hpp"

#include <cmath>
#include <limits>

namespace cookbook
{

/// Two orientations as quaternions of length one, the second with the sign that is nearer.
template <class Real>
struct TurnEnds
{
  Quaternion<Real> a; ///< where the way begins
  Quaternion<Real> b; ///< where it ends; half a turn from a, as it was given
};

/// Takes two quaternions as their directions, and the sign of b so that the way is the shorter one.
///
/// Half a turn apart is what rounding can make of it: a dot product of four roundings or less.
template <class Real>
TurnEnds<Real> turn_ends(const Quaternion<Real>& a, const Quaternion<Real>& b)
{
  const Quaternion<Real> from = unit_quaternion(a), to = unit_quaternion(b);
  const Real rounding = 4 * std::numeric_limits<Real>::epsilon();
  return {from, times<Real>(dot(from, to) < -rounding ? Real(-1) : Real(1), to)};
}

// [slerp]
/// The orientation at the fraction t of the shorter way from a to b, which is turned at a constant
/// rate; beyond 0 and 1 the way goes on.
///
/// Any finite quaternions are taken as their directions, zero as 1. The signs of q and -q do not
/// matter; half a turn apart to rounding, the way leads to b as given. The answer has a's sign.
/// Where |t| is 1/ε or more no digit of the angle would be left, and the answer is a. Right to four
/// ulps of one for t from 0 to 1; beyond, the roundings of the ends are enlarged |t| times.
template <class Real>
Quaternion<Real> slerp(const Quaternion<Real>& a, const Quaternion<Real>& b, const Real& t)
{
  using std::abs, std::sqrt;
  const TurnEnds<Real> ends = turn_ends(a, b);
  const Quaternion<Real> step = combined<Real>(Real(1), ends.b, Real(-1), ends.a);
  // What the step has across the start is sin θ long; what it has along it is cos θ - 1.
  const Real along = dot(ends.a, step);
  const Quaternion<Real> across = combined<Real>(Real(1), step, -along, ends.a);
  const Real off = sqrt(dot(across, across));
  const bool digits = !(abs(t) * std::numeric_limits<Real>::epsilon() >= Real(1));
  const Real turned = digits ? t * arc_tangent<Real>(off, Real(1) + along) : Real(0);
  const auto [s, c] = sine_cosine<Real>(turned);
  const Real fraction = off > Real(0) ? s / off : digits ? t : Real(0);
  return combined<Real>(c, ends.a, fraction, across);
}
// [slerp]

// [nlerp]
/// The orientation at the fraction t of the line from a to b, brought back to length one.
///
/// It takes the same way as slerp(), at a rate that is not constant. Degenerate ends as there.
template <class Real>
Quaternion<Real> nlerp(const Quaternion<Real>& a, const Quaternion<Real>& b, const Real& t)
{
  const TurnEnds<Real> ends = turn_ends(a, b);
  const Real fraction = std::abs(t) * std::numeric_limits<Real>::epsilon() >= Real(1) ? Real(0) : t;
  const Quaternion<Real> step = combined<Real>(Real(1), ends.b, Real(-1), ends.a);
  const Quaternion<Real> chord = combined<Real>(Real(1), ends.a, fraction, step);
  return times<Real>(Real(1) / std::sqrt(dot(chord, chord)), chord);
}
// [nlerp]

} // namespace cookbook
