#pragma once

/// \file
/// \brief A scene of the game's world in the small world, at any of its steps.

#include "05_resolution/small_world/small_body.hpp"
#include "06_world/contacts/scene.hpp"

#include <variant>

namespace cookbook
{

// [small_of]
/// The shape of a body of a scene, where it is: a plane becomes a box of 200 m whose top it is.
inline small_world::RigidBody small_shape(const SceneBody& body)
{
  if (const SphereShape* sphere = std::get_if<SphereShape>(&body.shape))
  {
    return small_world::sphere(body.position, sphere->radius, body.mass);
  }
  if (const BoxShape* box = std::get_if<BoxShape>(&body.shape))
  {
    return small_world::box(body.position, box->half_extents, body.mass);
  }
  const PlaneShape& plane = std::get<PlaneShape>(body.shape);
  small_world::RigidBody slab =
      small_world::box((plane.offset - 1) * plane.normal, {100, 1, 100}, 0);
  const Vector3<double> up = Vector3<double>::UnitY();
  slab.orientation = Quaternion<double>::FromTwoVectors(up, plane.normal);
  return slab;
}

/// A body of a scene as the small world has it.
inline small_world::RigidBody small_body(const SceneBody& body)
{
  small_world::RigidBody made = small_shape(body);
  small_world::set_orientation(made, made.orientation * body.orientation);
  made.motion.velocity = body.velocity;
  made.motion.angular_velocity = body.angular_velocity;
  made.friction = body.friction;
  made.restitution = body.restitution;
  return made;
}

/// A scene as a world of one of the steps, its bodies in the scene's order.
template <class World>
World small_of(const Scene& scene)
{
  World world;
  world.gravity = scene.gravity;
  for (const SceneBody& body : scene.bodies)
  {
    add(world, small_body(body));
  }
  return world;
}
// [small_of]

} // namespace cookbook
