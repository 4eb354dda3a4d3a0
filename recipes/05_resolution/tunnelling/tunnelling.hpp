#pragma once

/// \file
/// \brief A fast ball and a wall: how fast a step may be, and what a look after it or before it
/// does.

#include "05_resolution/tunnelling/swept_flight.hpp"

namespace cookbook
{

/// The speed [m/s] from which a ball that is looked at once a step may jump a wall unseen; R18.
template <class Real>
Real no_tunnel_speed(const Real& thickness, const Real& radius, const Real& step)
{
  return (thickness + Real(2) * radius) / step;
}

/// The speed [m/s] from which the ball may be seen, and pushed out on the far side; half of R18.
template <class Real>
Real no_push_through_speed(const Real& thickness, const Real& radius, const Real& step)
{
  return no_tunnel_speed(thickness, radius, step) / Real(2);
}

// [discrete_step]
/// Moves the ball, and looks afterwards: an overlap is pushed out, the velocity bounces.
template <class Real>
MovingSphere<Real> discrete_step(
    MovingSphere<Real> flight, const Obb<Real>& wall, const Real& restitution, const Real& step)
{
  flight = moved(flight, step);
  if (const auto manifold = sphere_box(flight.sphere, wall))
  {
    flight.sphere.center -= manifold->depth * manifold->normal;
    flight.velocity = rebound_velocity(flight.velocity, manifold->normal, restitution);
  }
  return flight;
}

/// The same in `count` shorter steps.
template <class Real>
MovingSphere<Real> substeps(
    MovingSphere<Real> flight, const Obb<Real>& wall, const Real& restitution, const Real& step,
    int count)
{
  for (int i = 0; i < count; ++i)
  {
    flight = discrete_step<Real>(flight, wall, restitution, step / Real(count));
  }
  return flight;
}
// [discrete_step]

// [speculative]
/// The velocity [m/s] that closes a gap [m] in one step at most, no faster; R17.
template <class Real>
Vector3<Real> speculative_velocity(
    const Vector3<Real>& velocity, const Vector3<Real>& normal, const Real& gap, const Real& step)
{
  const Real excess = velocity.dot(normal) - gap / step;
  return excess > Real(0) ? velocity - excess * normal : velocity;
}

/// Direction from the ball to the wall, and the gap [m] between them.
template <class Real>
Direction<Real> direction_to(const Sphere<Real>& sphere, const Obb<Real>& wall)
{
  const Direction<Real> gap =
      direction_to_box<Real>(box_coordinates(wall, sphere.center), wall.axes, wall.half_extents);
  return {gap.unit, gap.length - sphere.radius};
}

/// Brakes the ball before the step if the wall is no farther than a margin [m]; lets it bounce
/// where they touch, to a millionth of the radius.
template <class Real>
MovingSphere<Real> speculative_step(
    MovingSphere<Real> flight, const Obb<Real>& wall, const Real& restitution, const Real& step,
    const Real& margin)
{
  const Direction<Real> gap = direction_to(flight.sphere, wall);
  if (gap.length <= flight.sphere.radius * Real(1e-6))
  {
    flight.velocity = rebound_velocity(flight.velocity, gap.unit, restitution);
  }
  else if (gap.length <= margin)
  {
    flight.velocity = speculative_velocity(flight.velocity, gap.unit, gap.length, step);
  }
  return moved(flight, step);
}
// [speculative]

} // namespace cookbook
