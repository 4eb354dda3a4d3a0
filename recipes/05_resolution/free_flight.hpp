#pragma once

/// \file
/// \brief Bodies of a world that nothing touches: gravity, spin, and fast balls that meet a wall.

#include "05_resolution/island_points.hpp"
#include "05_resolution/narrow_phase.hpp"
#include "05_resolution/spinning_bodies.hpp"
#include "05_resolution/swept_sphere.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <variant>

namespace cookbook
{

// [fly]
/// A body after it has fallen and spun freely for a time [s]: exactly along its parabola.
inline RigidBody flown(RigidBody body, const Vector3<double>& gravity, double time)
{
  body.position += time * (body.velocity + time / 2 * gravity);
  body.velocity += time * gravity;
  const Spinning<double> spun =
      turned<double>({body.orientation, body.angular_velocity}, body.moments, time);
  body.orientation = spun.orientation;
  body.angular_velocity = spun.angular_velocity;
  update_axes(body);
  return body;
}
// [fly]

/// Whether a body, since it was at the start of a step [s], has been given anything but gravity.
inline bool was_pushed(
    const RigidBody& now, const RigidBody& start, const Vector3<double>& gravity, double step)
{
  const Vector3<double> fallen = start.velocity + step * gravity;
  const double turned = (now.angular_velocity - start.angular_velocity).norm();
  return (now.velocity - fallen).norm() > 1e-9 * fallen.norm() ||
         turned > 1e-9 * start.angular_velocity.norm();
}

// [first_touch]
/// The first touch of a ball that moves by a displacement [m] with another body's shape.
struct SweepBall
{
  Sphere<double> ball;
  Vector3<double> displacement;
  const RigidBody& other;

  std::optional<SweptHit<double>> operator()(const BoxShape& box) const
  {
    return swept_sphere_box(ball, displacement, placed(other, box, 0));
  }
  std::optional<SweptHit<double>> operator()(const SphereShape& sphere) const
  {
    return swept_sphere_sphere(ball, displacement, placed(other, sphere, 0));
  }
  std::optional<SweptHit<double>> operator()(const PlaneShape& plane) const
  {
    return swept_sphere_plane(ball, displacement, Plane<double>{plane.normal, plane.offset});
  }
};

/// What a ball touches first on its way.
struct FirstTouch
{
  std::size_t body;
  SweptHit<double> hit;
};

/// The first touch of ball number `number` as it moves by a displacement [m]; bodies of which
/// `ignored(i)` is true are not in its way.
template <class Ignored>
std::optional<FirstTouch> first_touch_in(
    const Scene& scene, std::span<const RigidBody> bodies, std::size_t number,
    const Vector3<double>& displacement, const Ignored& ignored)
{
  const double radius = std::get<SphereShape>(scene.bodies[number].shape).radius;
  std::optional<FirstTouch> first;
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    if (i == number || ignored(i))
    {
      continue;
    }
    const SweepBall sweep{{bodies[number].position, radius}, displacement, bodies[i]};
    const auto hit = std::visit(sweep, scene.bodies[i].shape);
    if (hit && (!first || hit->time < first->hit.time))
    {
      first = FirstTouch{i, *hit};
    }
  }
  return first;
}
// [first_touch]

// [bounce_off]
/// Lets a ball bounce off what it has touched, with their restitution; R2.
inline void bounce_off(
    const Scene& scene, std::span<RigidBody> bodies, std::size_t ball, const FirstTouch& touch)
{
  RigidBody &a = bodies[ball], &b = bodies[touch.body];
  const Vector3<double>& normal = touch.hit.normal;
  const double radius = std::get<SphereShape>(scene.bodies[ball].shape).radius;
  const Vector3<double> arm_a = radius * normal;
  const Vector3<double> arm_b = a.position + arm_a - b.position;
  const double speed = velocity_between(a, b, arm_a, arm_b).dot(normal);
  if (speed < 0)
  {
    const double restitution =
        std::max(scene.bodies[ball].restitution, scene.bodies[touch.body].restitution);
    const double felt = inverse_mass_between(a, b, arm_a, arm_b, normal);
    push_apart(a, b, arm_a, arm_b, -(1 + restitution) * speed / felt * normal);
  }
}

/// A ball at a share of its way [m] through a time [s]: on the straight way, with the speed that a
/// fall from where it was gives it there, so that a bounce neither gains nor loses height.
inline RigidBody at_touch(
    const RigidBody& ball, const Vector3<double>& gravity, double share, double time,
    const Vector3<double>& way)
{
  RigidBody there = flown(ball, gravity, share * time);
  there.position = ball.position + share * way;
  const double squared = ball.velocity.squaredNorm() + 2 * share * gravity.dot(way);
  const double speed = there.velocity.norm();
  if (squared > 0 && speed > 0)
  {
    there.velocity *= std::sqrt(squared) / speed;
  }
  return there;
}

/// Bounces of one ball in one step, after which it waits for the next.
inline constexpr int most_bounces_a_step = 32;

/// Moves a ball that nothing touches through a step [s]: from touch to touch, and on; bodies of
/// which `ignored(i)` is true are not in its way.
template <class Ignored>
void fly_ball(
    const Scene& scene, std::span<RigidBody> bodies, std::size_t number, double step,
    const Ignored& ignored)
{
  double left = step;
  for (int i = 0; i < most_bounces_a_step && left > 0; ++i)
  {
    const RigidBody& ball = bodies[number];
    const RigidBody there = flown(ball, scene.gravity, left);
    const Vector3<double> way = there.position - ball.position;
    const auto touch = first_touch_in(scene, bodies, number, way, ignored);
    if (!touch)
    {
      bodies[number] = there;
      return;
    }
    bodies[number] = at_touch(ball, scene.gravity, touch->hit.time, left, way);
    bounce_off(scene, bodies, number, *touch);
    left -= touch->hit.time * left;
  }
}
// [bounce_off]

} // namespace cookbook
