#pragma once

/// \file
/// \brief Between two orientations: at a constant rate, and along the straight line.

#include "01_math/rotations/unit_quaternion.hpp"

#include <cmath>
#include <limits>

namespace cookbook
{

// [ends]
/// Two orientations as quaternions of length one, the second with the sign that is nearer.
template <class Real>
struct TurnEnds
{
  Quaternion<Real> a; ///< where the way begins
  Quaternion<Real> b; ///< where it ends; half a turn from a, as it was given
};

/// Takes two quaternions as their directions, and the sign of b so that the way is the shorter one.
template <class Real>
TurnEnds<Real> turn_ends(const Quaternion<Real>& a, const Quaternion<Real>& b)
{
  const Quaternion<Real> from = unit_quaternion(a), to = unit_quaternion(b);
  return {from, from.dot(to) < Real(0) ? Quaternion<Real>(-to.coeffs()) : to};
}
// [ends]

// [slerp]
/// The orientation at the share t of the shorter way from a to b, which is turned at a constant
/// rate; beyond 0 and 1 the way goes on.
///
/// Any finite quaternions are taken as their directions, zero as 1. The signs of q and -q do not
/// matter; half a turn apart, the way leads to b as given. The answer has a's sign. Where |t| is
/// 1/ε or more no digit of the angle would be left, and the answer is a.
template <class Real>
Quaternion<Real> slerp(const Quaternion<Real>& a, const Quaternion<Real>& b, const Real& t)
{
  using std::abs, std::atan2, std::cos, std::sin, std::sqrt;
  using Vector4 = Eigen::Matrix<Real, 4, 1>;
  const TurnEnds<Real> ends = turn_ends(a, b);
  const Vector4 start = ends.a.coeffs(), step = ends.b.coeffs() - start;
  // What the step has across the start is sin θ long; what it has along it is cos θ - 1.
  const Real along = start.dot(step);
  const Vector4 across = step - start * along;
  const Real sine = sqrt(across.squaredNorm());
  const bool digits = abs(t) * std::numeric_limits<Real>::epsilon() < Real(1);
  const Real turned = digits ? t * atan2(sine, Real(1) + along) : Real(0);
  const Real share = sine > Real(0) ? sin(turned) / sine : digits ? t : Real(0);
  return Quaternion<Real>(start * cos(turned) + across * share);
}
// [slerp]

// [nlerp]
/// The orientation at the share t of the straight line from a to b, brought back to length one.
///
/// It takes the same way as slerp(), at a rate that is not constant. Degenerate ends as there.
template <class Real>
Quaternion<Real> nlerp(const Quaternion<Real>& a, const Quaternion<Real>& b, const Real& t)
{
  const TurnEnds<Real> ends = turn_ends(a, b);
  const Real share = std::abs(t) * std::numeric_limits<Real>::epsilon() < Real(1) ? t : Real(0);
  return unit_quaternion(
      Quaternion<Real>(ends.a.coeffs() + (ends.b.coeffs() - ends.a.coeffs()) * share));
}
// [nlerp]

} // namespace cookbook
