#pragma once

/// \file
/// \brief What is measured of a world: energy, momentum, overlap, loads, how far bodies went, what
/// is missing.

#include "06_world/game_world/game_world.hpp"
#include "06_world/islands/previous_state.hpp"
#include "06_world/scenes/trial/frames.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace cookbook
{

/// All bodies of a world as they are.
inline Frame frame_of(const GameWorld& world)
{
  Frame frame{world.time(), {}};
  for (const RigidBody& body : world.bodies())
  {
    frame.bodies.push_back(
        {body.motion.center, body.orientation, body.motion.velocity, body.motion.angular_velocity});
  }
  return frame;
}

/// The energy [J] of the movable bodies of a world: of motion, and of height against gravity.
inline double energy(std::span<const RigidBody> bodies, const Vector3<double>& gravity)
{
  double sum = 0;
  for (const RigidBody& body : bodies)
  {
    if (!is_fixed(body))
    {
      sum += kinetic_energy(body) - gravity.dot(body.motion.center) / body.inverse_mass;
    }
  }
  return sum;
}

/// That of a world, in its own gravity.
inline double energy(const GameWorld& world)
{
  return energy(world.bodies(), world.scene().gravity);
}

/// The momentum [kg m/s] of the movable bodies of a world.
inline Vector3<double> momentum(std::span<const RigidBody> bodies)
{
  Vector3<double> sum = Vector3<double>::Zero();
  for (const RigidBody& body : bodies)
  {
    if (!is_fixed(body))
    {
      sum += body.motion.velocity / body.inverse_mass;
    }
  }
  return sum;
}

/// The angular momentum [kg m²/s] of the movable bodies of a world, about the origin.
inline Vector3<double> angular_momentum(std::span<const RigidBody> bodies)
{
  Vector3<double> sum = Vector3<double>::Zero();
  for (const RigidBody& body : bodies)
  {
    if (!is_fixed(body))
    {
      const Vector3<double> spin = body.axes.transpose() * body.motion.angular_velocity;
      sum += body.motion.center.cross(body.motion.velocity / body.inverse_mass);
      sum += body.axes * body.moments.cwiseProduct(spin);
    }
  }
  return sum;
}

/// The deepest overlap [m] at any contact point of a world.
inline double deepest_overlap(const GameWorld& world)
{
  double most = 0;
  for (const WorldContact& contact : world.contacts())
  {
    const RigidBody& a = world.bodies()[static_cast<std::size_t>(contact.a)];
    const RigidBody& b = world.bodies()[static_cast<std::size_t>(contact.b)];
    for (const WorldPoint& point : contact.points)
    {
      most = std::max(most, -separation_of(a, b, contact.normal, point));
    }
  }
  return most;
}

/// How fast [m/s] surfaces move that a solver should have stopped: closing where nothing pushes,
/// moving at all along the normal where something does; R10.
inline double residual(const GameWorld& world)
{
  double most = 0;
  const auto axes = [&](int i) -> Matrix3<double>
  {
    return with_state(world.bodies()[index_of(i)], start_state(world.scene().bodies[index_of(i)]))
        .axes;
  };
  for (const WorldContact& contact : world.contacts())
  {
    const RigidBody& a = world.bodies()[static_cast<std::size_t>(contact.a)];
    const RigidBody& b = world.bodies()[static_cast<std::size_t>(contact.b)];
    for (const WorldPoint& point : contact.points)
    {
      const Arms<double> arms{axes(contact.a) * point.anchor_a, axes(contact.b) * point.anchor_b};
      const double speed = separating_velocity<double>(a, b, contact.normal, arms);
      const bool touches = separation_of(a, b, contact.normal, point) <= 0;
      const double wrong = point.impulse > 0 ? std::abs(speed) : touches ? -speed : 0;
      most = std::max(most, wrong);
    }
  }
  return most;
}

/// The impulses [N s] that each body gets, against gravity and in the last step, from all contacts
/// with bodies before it in the scene: what carries it, where each stands on the one before.
inline std::vector<double> carried_in(const GameWorld& world)
{
  const Vector3<double>& gravity = world.scene().gravity;
  std::vector<double> sums(world.bodies().size(), 0.0);
  for (const WorldContact& contact : world.contacts())
  {
    for (const WorldPoint& point : contact.points)
    {
      const Vector3<double> impulse = point.impulse * contact.normal + point.friction;
      sums[static_cast<std::size_t>(contact.b)] -=
          impulse.dot(gravity) / std::max(gravity.norm(), 1e-300);
    }
  }
  return sums;
}

/// The farthest that any body has moved from where its scene put it.
struct FarthestMove
{
  double sideways = 0; ///< [m], across gravity
  double along = 0;    ///< [m], up or down
};

/// How far the bodies of a scene have gone in a world; along y where there is no gravity.
inline FarthestMove farthest_move(const Scene& scene, const GameWorld& world)
{
  const Vector3<double>& gravity = world.scene().gravity;
  const double size = gravity.norm();
  const Vector3<double> up = size > 0 ? Vector3<double>(-gravity / size) : Vector3<double>(0, 1, 0);
  FarthestMove most;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
  {
    const Vector3<double> displacement = world.bodies()[i].motion.center - scene.bodies[i].position;
    const double height = displacement.dot(up);
    most.along = std::max(most.along, std::abs(height));
    most.sideways = std::max(most.sideways, (displacement - height * up).norm());
  }
  return most;
}

} // namespace cookbook
