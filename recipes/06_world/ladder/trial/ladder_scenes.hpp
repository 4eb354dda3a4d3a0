#pragma once

/// \file
/// \brief The scenes that step 7 of the small world fails, and what is measured of it.

#include "05_resolution/small_world/trial/small_scenes.hpp"
#include "06_world/scenes/trial/stack_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cookbook
{

/// A cube of 20 cm and 8 kg at a height [m] that comes down at 5 m/s.
inline Scene cube_thrown_down(double height)
{
  Scene scene = scenes::standing(1);
  scene.bodies.push_back(box_body("cube", {0.1, 0.1, 0.1}, {0, height, 0}, 8));
  scene.bodies.back().velocity = {0, -5, 0};
  return scene;
}

/// Without gravity, a cube of 20 cm that flies at a speed [m/s] at a fixed wall of 2 cm.
inline Scene cube_at_wall(double speed)
{
  Scene scene{.gravity = {0, 0, 0}, .duration = 2};
  scene.bodies.push_back(box_body("wall", {0.01, 5, 5}, {0, 0, 0}, 0));
  scene.bodies.push_back(box_body("cube", {0.1, 0.1, 0.1}, {-2, 0, 0}));
  scene.bodies.back().velocity.x() = speed;
  scene.bodies.back().restitution = 0.5;
  return scene;
}

/// Without gravity, a smooth sphere at 5 m/s and three like it in a row that touch; e = 1.
inline Scene sphere_at_row()
{
  Scene scene{.gravity = {0, 0, 0}, .duration = 0.5};
  for (int i = 0; i < 4; ++i)
  {
    scene.bodies.push_back(
        ball_body(numbered("sphere", i + 1), 0.1, {i == 0 ? 0 : 0.3 + 0.2 * i, 0, 0}));
    scene.bodies.back().friction = 0;
    scene.bodies.back().restitution = 1;
  }
  scene.bodies.front().velocity.x() = 5;
  return scene;
}

/// Cubes of 1 m on the ground in a row along z, with gaps of 10 cm.
inline Scene row_of_cubes(int count)
{
  Scene scene = scenes::standing();
  for (int i = 0; i < count; ++i)
  {
    scene.bodies.push_back(
        cube_body(numbered("cube", i + 1), {0, 0.5, 1.1 * (i - 0.5 * (count - 1))}));
  }
  return scene;
}

/// A cube on the ground that slides from 5 m/s.
inline Scene sliding_cube()
{
  Scene scene = scenes::tower(1);
  scene.bodies.back().velocity.x() = 5;
  return scene;
}

/// A sphere in flight.
inline Scene thrown_sphere()
{
  SceneBody sphere = ball_body("sphere", 0.1, {0, 0, 0});
  sphere.velocity = {5, 10, 0};
  return {.duration = 2, .bodies = {sphere}};
}

/// A sphere of 10 cm that falls from 1 m, with a restitution of 0.5.
inline Scene dropped_sphere()
{
  Scene scene = scenes::standing(3);
  scene.bodies.push_back(ball_body("sphere", 0.1, {0, 1.1, 0}));
  scene.bodies.back().restitution = 0.5;
  return scene;
}

/// Has no body of a small world fall asleep, where it is of a step that lets them.
template <class World>
void keep_awake(World& world)
{
  if constexpr (requires { world.rest_times; })
  {
    std::fill(world.rest_times.begin(), world.rest_times.end(), 0.0);
  }
}

/// The deepest overlap [m] of any two bodies of a small world, of which one can move.
template <class World>
double deepest_now(const World& world)
{
  double most = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    for (std::size_t j = i + 1; j < world.bodies.size(); ++j)
    {
      const small_world::RigidBody &a = world.bodies[i], &b = world.bodies[j];
      const bool may_touch =
          (a.inverse_mass > 0 || b.inverse_mass > 0) &&
          small_world::step_4::bounds_of(a).intersects(small_world::step_4::bounds_of(b));
      if (const auto manifold = may_touch ? small_world::manifold_of(a, b) : std::nullopt)
      {
        for (const ContactPoint<double>& point : manifold->points)
        {
          most = std::max(most, point.depth);
        }
      }
    }
  }
  return most;
}

/// The deepest overlap [m] after any step of a small world within a time [s].
template <class World>
double deepest_in_run(World world, double time)
{
  double most = 0;
  const long frames = std::lround(time / small_world::frame);
  for (long i = 0; i < frames; ++i)
  {
    step(world, small_world::frame);
    most = std::max(most, deepest_now(world));
  }
  return most;
}

} // namespace cookbook
