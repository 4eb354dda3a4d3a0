#pragma once

/// \file
/// \brief A small world as a picture: its bodies with their shadows, and where they touch.

#include "02_primitives/picture/picture.hpp"
#include "05_resolution/small_world/small_body.hpp"

#include <cstddef>
#include <vector>

namespace cookbook::small_world
{

/// Whether a body of a world is asleep; in a step without sleeping none is.
template <class World>
bool sleeps(const World& world, std::size_t i)
{
  if constexpr (requires { is_asleep(world, i); })
  {
    return is_asleep(world, i);
  }
  return false;
}

/// Draws a body.
inline void draw_body(
    Picture& picture, const Camera<double>& camera, const RigidBody& body, const Colour& colour)
{
  if (body.is_sphere)
  {
    draw_sphere(picture, camera, sphere_of(body), body.orientation.toRotationMatrix(), colour);
    return;
  }
  draw_box(picture, camera, box_of(body), colour);
}

/// Draws a body's shadow on a floor that is drawn already.
inline void draw_body_shadow(
    Picture& picture, const Camera<double>& camera, const Obb<double>& floor, const RigidBody& body,
    const Colour& colour)
{
  if (body.is_sphere)
  {
    draw_shadow(picture, camera, floor, sphere_of(body), colour);
    return;
  }
  draw_shadow(picture, camera, floor, box_of(body), colour);
}

/// The colour of a body: orange and blue by turns; paler asleep, grey if it is fixed.
template <class World>
Colour body_colour(const World& world, std::size_t i, const Palette& palette)
{
  const Colour colour = i % 2 == 0 ? palette.a : palette.b;
  return world.bodies[i].inverse_mass == 0 ? palette.muted
         : sleeps(world, i)                ? mixed(colour, palette.muted, 150)
                                           : colour;
}

/// Whether a body is the ground: a fixed one that is wider than the floor that is drawn for it.
inline bool is_ground(const RigidBody& body, const Obb<double>& floor)
{
  return body.inverse_mass == 0 && body.half_extents.x() > floor.half_extents.x();
}

/// Draws bodies, a colour for each, and their shadows on the top of a floor, over the sky.
inline void draw_bodies(
    Picture& picture, const Camera<double>& camera, const std::vector<RigidBody>& bodies,
    const std::vector<Colour>& colours, const Obb<double>& floor, const Palette& palette)
{
  clear(picture, palette);
  draw_ground(picture, camera, floor, palette);
  for (const RigidBody& body : bodies)
  {
    if (!is_ground(body, floor))
    {
      draw_body_shadow(picture, camera, floor, body, palette.shadow);
    }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    if (!is_ground(bodies[i], floor))
    {
      draw_body(picture, camera, bodies[i], colours[i]);
    }
  }
}

/// Draws a world: its bodies in the colours of `body_colour`.
template <class World>
void draw_world(
    Picture& picture, const Camera<double>& camera, const World& world, const Obb<double>& floor,
    const Palette& palette)
{
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    colours.push_back(body_colour(world, i, palette));
  }
  draw_bodies(picture, camera, world.bodies, colours, floor, palette);
}

/// Draws the contact points that a step solved: a red dot at each, and its normal [m] long, over
/// what is before them.
template <class World>
void draw_contacts(
    Picture& picture, const Camera<double>& camera, const World& world, double length,
    const Palette& palette)
{
  for (const auto& contact : world.contacts)
  {
    const Vector3<double> at = world.bodies[contact.a].motion.center + contact.arms.a;
    const Vector3<double> normal = length * contact.normal;
    draw_arrow(picture, camera, at, normal, palette.ink, 1, Cover::none);
    draw_dot(picture, camera, at, palette.overlap, 2, Cover::none);
  }
}

} // namespace cookbook::small_world
