#pragma once

/// \file
/// \brief Friction without a cone: a pyramid, a polygon, a constant bound, a dead zone; kept to be
/// asserted to fail.

#include "05_resolution/friction/friction.hpp"
#include "05_resolution/impulse/impulse.hpp"

#include <cmath>
#include <numbers>

namespace cookbook
{

// [within_pyramid]
/// An impulse [N s] along a surface, cut along each of its axes to at most a length [N s]: along
/// the diagonal it may be √2 times as long.
template <class Real>
Vector2<Real> within_pyramid(const Vector2<Real>& impulse, const Real& max_friction)
{
  const auto cut = [&](const Real& along)
  { return std::max(Real(-max_friction), std::min(max_friction, along)); };
  return {cut(impulse.x()), cut(impulse.y())};
}
// [within_pyramid]

/// An impulse [N s] along a surface, shortened to end on a regular polygon of 2 `axes`
/// sides around the circle of radius `max_friction` [N s]: a scalar product for each axis.
template <class Real>
Vector2<Real> within_polygon(const Vector2<Real>& impulse, const Real& max_friction, int axes)
{
  using std::abs;
  using std::cos;
  using std::sin;
  Real farthest(0);
  for (int i = 0; i < axes; ++i)
  {
    const Real angle = std::numbers::pi_v<Real> * Real(i) / Real(axes);
    const Vector2<Real> axis(cos(angle), sin(angle));
    farthest = std::max(farthest, Real(abs(impulse.dot(axis))));
  }
  return farthest <= max_friction ? impulse : Vector2<Real>(impulse * (max_friction / farthest));
}

// [answered_as_published]
/// What the code published with the seed book takes for zero, whatever the unit.
inline constexpr double published_zero = 0.005;

/// Two bodies after one visit to one of `count` contact points, with dead zones.
///
/// Bounce and friction are both divided by the count. Friction goes by the sliding as it was before
/// the bounce, is left out where the square of that speed, or the impulse itself, passes for zero,
/// and is held against the impulse of this visit instead of the sum of all.
template <class Real>
BodyPair<Real> answered_as_published(
    BodyPair<Real> bodies, const Vector3<Real>& normal, const Vector3<Real>& point, int count,
    Real restitution, Real friction)
{
  auto& [a, b] = bodies;
  const Arms<Real> arms = arms_to(bodies, point);
  const Real j = bounce_impulse(a, b, normal, arms, restitution) / Real(count);
  if (j == Real(0))
  {
    return bodies;
  }
  const Vector3<Real> sliding =
      along_surface<Real>(relative_velocity(a.motion, b.motion, arms), normal);
  apply_impulse<Real>(a, b, arms, j * normal);
  const Real speed = sliding.norm();
  if (speed * speed <= Real(published_zero))
  {
    return bodies;
  }
  const Vector3<Real> direction = sliding / speed;
  const Real rub = speed / inverse_mass_at(a, b, direction, arms) / Real(count);
  if (rub > Real(published_zero))
  {
    apply_impulse<Real>(a, b, arms, -std::min(rub, Real(friction * j)) * direction);
  }
  return bodies;
}
// [answered_as_published]

} // namespace cookbook
