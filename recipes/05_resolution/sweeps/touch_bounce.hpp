#pragma once

/// \file
/// \brief The bounce of a ball off what it has touched on its way: the whole impulse at one point.

#include "05_resolution/contacts/contact_cache.hpp"
#include "05_resolution/sweeps/simultaneous_impacts.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace cookbook
{

// [ball_touch]
/// A ball and what it touches first.
struct BallTouch
{
  double time;                  ///< [s], of the step
  int ball, other;              ///< numbers of bodies
  Vector3<double> normal;       ///< [1], unit, world, from the ball to the other
  std::pair<int, int> versions; ///< of the two courses, which may have changed since

  /// Whether it comes later: the earliest is on top of a queue.
  bool operator<(const BallTouch& next) const
  {
    return std::tie(next.time, next.ball, next.other) < std::tie(time, ball, other);
  }
};

// [ball_touch]

// [bounce_at]
/// The contact of two bodies of a scene at one point, where a ball has touched something.
inline WorldContact touch_contact(
    const Scene& scene, std::pair<int, int> bodies, const RigidBody& a, const RigidBody& b,
    const Vector3<double>& normal)
{
  WorldContact contact = new_contact(scene, bodies.first, bodies.second);
  const SphereShape& ball =
      std::get<SphereShape>(scene.bodies[static_cast<std::size_t>(bodies.first)].shape);
  const Vector3<double> place = a.position + ball.radius * normal;
  contact.memory.manifold = Manifold<double>{normal, 0, ContactPoints<double, 8>({place, 0, 0})};
  anchor(contact, a, b);
  return contact;
}

/// Lets two bodies bounce where they touch, with friction, and says at what speed [m/s] they met;
/// R2, R6. An approach up to a threshold [m/s] only ends; 0, and nothing changes, if they part.
inline double bounce(RigidBody& a, RigidBody& b, WorldContact& contact, double threshold)
{
  const IslandPoint point = island_point(a, b, contact, contact.points()[0]);
  const double approach = std::max(0.0, -parting_speed(point));
  const double target = approach > threshold ? contact.restitution * approach : 0;
  if (approach > 0)
  {
    std::vector<ImpactPoint> points{{point, target}};
    RigidBody* const bodies[] = {&a, &b};
    bounce(points, bodies);
  }
  return approach;
}
// [bounce_at]

} // namespace cookbook
