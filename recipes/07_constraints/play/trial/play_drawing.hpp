#pragma once

/// \file
/// \brief A world as a picture: bodies, shadows, contacts, impulses, islands and sleep.

#include "02_primitives/picture/picture.hpp"
#include "07_constraints/play/trial/play_colours.hpp"
#include "07_constraints/play/trial/play_joints.hpp"
#include "07_constraints/play/trial/play_world.hpp"

#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

namespace cookbook::play
{

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

/// Draws the shadow of a body on a floor.
inline void draw_shadow_of(const Drawing& in, std::size_t i, const Obb<double>& floor)
{
  const RigidBody& body = in.world.bodies()[i];
  const auto& shape = in.world.scene().bodies[i].shape;
  if (const auto* const box = std::get_if<BoxShape>(&shape))
  {
    draw_shadow(in.picture, in.camera, floor, box_at(body, *box), in.palette.shadow);
  }
  else if (const auto* const sphere = std::get_if<SphereShape>(&shape))
  {
    const Sphere<double> round{body.motion.center, sphere->radius};
    draw_shadow(in.picture, in.camera, floor, round, in.palette.shadow);
  }
}

/// Draws the floors, and the shadows of all bodies on them.
inline void draw_floors(const Drawing& in, const Vector3<double>& around)
{
  for (const SceneBody& body : in.world.scene().bodies)
  {
    if (const auto* const plane = std::get_if<PlaneShape>(&body.shape))
    {
      const Obb<double> floor = floor_of(*plane, around);
      draw_ground(in.picture, in.camera, floor, in.palette);
      for (std::size_t i = 0; i < in.world.bodies().size(); ++i)
      {
        if (in.world.has(in.world.id(i)))
        {
          draw_shadow_of(in, i, floor);
        }
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

/// Draws joints over everything: a dot at each anchor and a line in between, red where they are to
/// be at one point; and the axis of those that have one.
inline void draw_joints(const Drawing& in, const std::vector<JointMark>& joints)
{
  const auto& [picture, camera, world, shown, palette] = in;
  for (const JointMark& joint : joints)
  {
    const RigidBody& a = world.bodies()[index_of(joint.a)];
    const RigidBody& b = world.bodies()[index_of(joint.b)];
    const Vector3<double> at_a = a.motion.center + a.orientation * joint.anchor_a;
    const Vector3<double> at_b = b.motion.center + b.orientation * joint.anchor_b;
    if (joint.axis_a)
    {
      const Vector3<double> half = 0.15 * (a.orientation * *joint.axis_a);
      draw_segment(picture, camera, {at_a - half, at_a + half}, palette.ink, 1.5, Cover::none);
    }
    const Colour& between = joint.together ? palette.overlap : palette.ink;
    draw_segment(picture, camera, {at_a, at_b}, between, 2, Cover::none);
    draw_dot(picture, camera, at_a, palette.ink, 2, Cover::none);
    draw_dot(picture, camera, at_b, palette.ink, 2, Cover::none);
  }
}

/// Draws what the hand holds, and where it pulls it.
inline void draw_hand(const Drawing& in, const Hand& hand)
{
  if (hand.held && in.world.has(hand.held->body))
  {
    const RigidBody& body = in.world.body(hand.held->body);
    const Vector3<double> at = body.motion.center + body.orientation * hand.held->anchor;
    draw_segment(in.picture, in.camera, {at, hand.held->target}, in.palette.ink, 2, Cover::none);
    draw_dot(in.picture, in.camera, at, in.palette.b, 4, Cover::none);
  }
}

/// Draws all of it.
inline void draw(
    Picture& picture, const Camera<double>& camera, Play& play, const Shown& shown,
    const Islands& islands)
{
  const Palette palette = shown.dark ? dark_palette() : light_palette();
  const Drawing in{picture, camera, play.world, shown, palette};
  clear(picture, palette);
  draw_floors(in, play.orbit.target);
  draw_bodies(in, islands);
  draw_contacts(in);
  draw_joints(in, joint_marks(play.world, play.hand.place));
  draw_hand(in, play.hand);
}

} // namespace cookbook::play
