#pragma once

/// \file
/// \brief A world as a picture: bodies, shadows, contacts, impulses, islands and sleep.

#include "02_primitives/picture/picture.hpp"
#include "06_world/islands/island.hpp"
#include "06_world/play/trial/play_world.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace cookbook::play
{

/// What is shown of a world besides its bodies.
struct Shown
{
  bool contacts = false; ///< contact points
  bool normals = false;  ///< their normals
  bool impulses = false; ///< what each point was given in the last step
  bool islands = false;  ///< a colour for each island
  bool dark = false;     ///< on a dark page
};

/// Six colours for islands, made of the palette's.
inline Colour island_colour(const Palette& palette, int island)
{
  const std::array<Colour, 6> colours{
      palette.a,
      palette.b,
      palette.good,
      mixed(palette.a, palette.overlap, 110),
      mixed(palette.a, palette.good, 130),
      mixed(palette.b, palette.good, 110)};
  return colours[static_cast<std::size_t>(island) % colours.size()];
}

/// The colour of a body of a world: thrown balls orange, all others in three shades of blue, or by
/// island; what sleeps is paler, what is fixed grey.
inline Colour body_colour(
    const Palette& palette, const Shown& shown, const GameWorld& world, std::size_t i,
    const Islands& islands)
{
  const RigidBody& body = world.bodies()[i];
  const bool thrown = world.scene().bodies[i].name.rfind("thrown", 0) == 0;
  Colour colour = thrown ? palette.b : mixed(palette.a, palette.sky, 35 * int(i % 3));
  if (is_fixed(body))
  {
    return palette.muted;
  }
  if (shown.islands)
  {
    colour = island_colour(palette, islands.numbers()[i]);
  }
  return world.is_asleep(world.id(i)) ? mixed(colour, palette.ground, 110) : colour;
}

/// A plane as a floor: its axes are the world's where it is level.
inline Obb<double> floor_of(const PlaneShape& plane, const Vector3<double>& around)
{
  constexpr double half = 20;
  const Vector3<double> n = plane.normal;
  const double length = std::sqrt(n.x() * n.x() + n.y() * n.y());
  const Vector3<double> x =
      length > 0 ? Vector3<double>(n.y() / length, -n.x() / length, 0) : Vector3<double>(1, 0, 0);
  Matrix3<double> axes;
  axes.col(0) = x;
  axes.col(1) = n;
  axes.col(2) = x.cross(n);
  const Vector3<double> level(std::floor(around.x()), around.y(), std::floor(around.z()));
  const Vector3<double> top = level - (n.dot(level) - plane.offset) * n;
  return {top - 0.5 * n, axes, {half, 0.5, half}};
}

/// What a scene's body is as a shape of chapter 2, where the world has it.
inline Obb<double> box_at(const RigidBody& body, const BoxShape& box)
{
  return {body.motion.center, body.axes, box.half_extents};
}

/// All that a picture of a world is drawn with.
struct Drawing
{
  Picture& picture;
  const Camera<double>& camera;
  const GameWorld& world;
  const Shown& shown;
  const Palette& palette;
};

/// Draws the floors, and the shadows of all bodies on them.
inline void draw_floors(const Drawing& in, const Vector3<double>& around)
{
  const auto& [picture, camera, world, shown, palette] = in;
  for (const SceneBody& body : world.scene().bodies)
  {
    const auto* const plane = std::get_if<PlaneShape>(&body.shape);
    if (plane == nullptr)
    {
      continue;
    }
    const Obb<double> floor = floor_of(*plane, around);
    draw_ground(picture, camera, floor, palette);
    for (std::size_t i = 0; i < world.bodies().size(); ++i)
    {
      const RigidBody& caster = world.bodies()[i];
      const auto& shape = world.scene().bodies[i].shape;
      if (const auto* const box = std::get_if<BoxShape>(&shape))
      {
        draw_shadow(picture, camera, floor, box_at(caster, *box), palette.shadow);
      }
      else if (const auto* const sphere = std::get_if<SphereShape>(&shape))
      {
        const Sphere<double> round{caster.motion.center, sphere->radius};
        draw_shadow(picture, camera, floor, round, palette.shadow);
      }
    }
  }
}

/// Draws all bodies that are there.
inline void draw_bodies(const Drawing& in, const Islands& islands)
{
  const auto& [picture, camera, world, shown, palette] = in;
  for (std::size_t i = 0; i < world.bodies().size(); ++i)
  {
    if (!world.has(world.id(i)))
    {
      continue;
    }
    const RigidBody& body = world.bodies()[i];
    const Colour colour = body_colour(palette, shown, world, i, islands);
    const auto& shape = world.scene().bodies[i].shape;
    if (const auto* const box = std::get_if<BoxShape>(&shape))
    {
      draw_box(picture, camera, box_at(body, *box), colour);
    }
    else if (const auto* const sphere = std::get_if<SphereShape>(&shape))
    {
      const Matrix3<double> axes = body.orientation.toRotationMatrix();
      draw_sphere(picture, camera, {body.motion.center, sphere->radius}, axes, colour);
    }
  }
}

/// Draws the contacts of the last step over everything: points that press are red, others grey.
inline void draw_contacts(const Drawing& in)
{
  const auto& [picture, camera, world, shown, palette] = in;
  const double weight_of_1_kg = 9.81 * world.scene().step; // [N s], in a step
  for (const WorldContact& contact : world.contacts())
  {
    const RigidBody& b = world.bodies()[index_of(contact.b)];
    for (const WorldPoint& point : contact.points)
    {
      const Vector3<double> at = b.motion.center + b.axes * point.anchor_b;
      if (shown.normals)
      {
        draw_arrow(picture, camera, at, 0.35 * contact.normal, palette.ink, 1.5, Cover::none);
      }
      if (shown.impulses && is_active(point))
      {
        const Vector3<double> impulse = point.impulse * contact.normal + point.friction;
        const Vector3<double> arrow = limited(0.5 / weight_of_1_kg * impulse, 3);
        draw_arrow(picture, camera, at, arrow, palette.overlap, 2, Cover::none);
      }
      if (shown.contacts)
      {
        const Colour colour = is_active(point) ? palette.overlap : palette.muted;
        draw_dot(picture, camera, at, colour, 2.5, Cover::none);
      }
    }
  }
}

/// Draws all of it.
inline void draw(
    Picture& picture, const Camera<double>& camera, const Play& play, const Shown& shown,
    const Islands& islands)
{
  const Palette palette = shown.dark ? dark_palette() : light_palette();
  const Drawing in{picture, camera, play.world, shown, palette};
  clear(picture, palette);
  draw_floors(in, play.orbit.target);
  draw_bodies(in, islands);
  draw_contacts(in);
  if (play.held)
  {
    const RigidBody& body = play.world.body(play.held->body);
    const Vector3<double> at = body.motion.center + body.orientation * play.held->anchor;
    draw_segment(picture, camera, {at, play.held->target}, palette.ink, 2, Cover::none);
    draw_dot(picture, camera, at, palette.b, 4, Cover::none);
  }
}

} // namespace cookbook::play
