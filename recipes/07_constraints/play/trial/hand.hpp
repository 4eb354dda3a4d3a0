#pragma once

/// \file
/// \brief The pointer's hand in a world: it drags what it holds by a mouse joint.

#include "06_world/game_world/game_world.hpp"
#include "06_world/game_world/world_queries.hpp"
#include "07_constraints/mouse/mouse.hpp"

#include <cstddef>
#include <optional>

namespace cookbook::play
{

// [hand]
/// The body that the pointer holds.
struct Held
{
  BodyId body;            ///< which
  Vector3<double> anchor; ///< [m], in the body's frame, where it is held
  Vector3<double> target; ///< [m], world, where the pointer wants that point
};

/// A hand that drags a body of a world: a set with one mouse joint while it holds any, else none.
struct Hand
{
  BodyId ground;     ///< fixed, what targets stand in
  std::size_t place; ///< of the set among the world's
  std::optional<Held> held{};
};

/// Gives a world a hand, and what it stands on where nothing there is fixed.
inline Hand add_hand(GameWorld& world)
{
  BodyId ground = 0;
  while (world.has(ground) && !is_fixed(world.body(ground)))
  {
    ++ground;
  }
  if (!world.has(ground))
  {
    ground = world.add(
        {.name = "what the hand stands on", .shape = SphereShape{0.1}, .position = {0, -1e3, 0}});
  }
  return {ground, world.add(MouseJoints())};
}

/// The mouse joints of a hand.
inline MouseJoints& joints_of(GameWorld& world, const Hand& hand)
{
  return static_cast<MouseJoints&>(world.constraint_set(hand.place));
}

/// Lets go.
inline void let_go(GameWorld& world, Hand& hand)
{
  hand.held.reset();
  joints_of(world, hand) = MouseJoints();
}

/// Takes hold of the body that a ray meets first, with a largest force [N] that `force(body)`
/// says, and returns whether it did: not where that is fixed, or where there is none.
template <class Force>
bool take_hold(GameWorld& world, Hand& hand, const Ray<double>& ray, const Force& force)
{
  let_go(world, hand);
  const std::optional<BodyHit> met = WorldQueries(world).cast(ray);
  if (met && !is_fixed(world.body(met->body)))
  {
    const Vector3<double> point = ray.origin + met->hit.t * ray.direction;
    MouseJoint mouse = mouse_at(world, hand.ground, met->body, point);
    mouse.max_force = force(world.body(met->body));
    hand.held = {met->body, mouse.anchor_b, point};
    joints_of(world, hand).add(mouse);
  }
  return hand.held.has_value();
}

/// Has the joint ask for where the pointer is, before each step; what is held turns ever slower.
inline void pull(GameWorld& world, const Hand& hand)
{
  if (!hand.held || !world.has(hand.held->body))
  {
    return;
  }
  MouseJoints& mice = joints_of(world, hand);
  MouseJoint mouse = mice[0];
  mouse.target = anchor_at(world.body(hand.ground), hand.held->target);
  mice.set(0, mouse);
  const Motion<double> motion = world.body(hand.held->body).motion;
  world.set_velocity(hand.held->body, motion.velocity, 0.9 * motion.angular_velocity);
}
// [hand]

} // namespace cookbook::play
