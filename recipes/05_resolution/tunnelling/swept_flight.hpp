#pragma once

/// \file
/// \brief A fast ball among walls: it goes on to its first touch, bounces, and goes on.

#include "05_resolution/tunnelling/swept_sphere.hpp"

#include <span>

namespace cookbook
{

// [flight]
/// A ball that flies straight on between bounces.
template <class Real>
struct MovingSphere
{
  Sphere<Real> sphere;
  Vector3<Real> velocity; ///< [m/s], world
};

/// The flight after a time [s] in which nothing is in the way.
template <class Real>
MovingSphere<Real> moved(MovingSphere<Real> flight, const Real& time)
{
  flight.sphere.center += time * flight.velocity;
  return flight;
}

/// A velocity after a bounce off something immovable, towards which a normal points; R5.
///
/// As it was where the surfaces part already.
template <class Real>
Vector3<Real> rebound_velocity(
    const Vector3<Real>& velocity, const Vector3<Real>& normal, const Real& restitution)
{
  const Real approach = velocity.dot(normal);
  return approach > Real(0) ? velocity - (Real(1) + restitution) * approach * normal : velocity;
}
// [flight]

// [swept_step]
/// The first touch of a moving ball with any of these walls; the wall that comes first, if several.
template <class Real>
std::optional<SweptHit<Real>> first_hit(
    const Sphere<Real>& sphere, const Vector3<Real>& displacement, std::span<const Obb<Real>> walls)
{
  std::optional<SweptHit<Real>> first;
  for (const Obb<Real>& wall : walls)
  {
    const std::optional<SweptHit<Real>> hit = swept_sphere_box(sphere, displacement, wall);
    if (hit && (!first || hit->time < first->time))
    {
      first = hit;
    }
  }
  return first;
}

/// The most bounces of one ball in one step.
inline constexpr int max_bounces = 32;

/// Moves the ball to where it first touches, lets it bounce there, and goes on with the rest of the
/// step. After `max_bounces` it waits for the next step where it is.
template <class Real>
MovingSphere<Real> swept_step(
    MovingSphere<Real> flight, std::span<const Obb<Real>> walls, const Real& restitution, Real step)
{
  for (int i = 0; i < max_bounces; ++i)
  {
    const std::optional<SweptHit<Real>> hit =
        first_hit<Real>(flight.sphere, step * flight.velocity, walls);
    if (!hit)
    {
      return moved(flight, step);
    }
    flight = moved<Real>(flight, hit->time * step);
    flight.velocity = rebound_velocity(flight.velocity, hit->normal, restitution);
    step -= hit->time * step;
  }
  return flight;
}
// [swept_step]

} // namespace cookbook
