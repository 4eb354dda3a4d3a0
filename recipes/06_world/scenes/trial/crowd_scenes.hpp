#pragma once

/// \file
/// \brief Scenes as games have them: walls of bricks, crates let fall, balls in a pit and in
/// flight.

#include "06_world/scenes/trial/heap_scenes.hpp"

namespace cookbook::scenes
{

/// Courses of bricks of 1 m by 50 cm by 50 cm in bond: twice as many bricks as courses in the
/// lowest, each second course shifted by half a brick and one brick shorter.
inline Scene wall(int trajectories)
{
  Scene scene = standing(10);
  for (int course = 0; course < trajectories; ++course)
  {
    const int bricks = 2 * trajectories - course % 2;
    for (int i = 0; i < bricks; ++i)
    {
      const Vector3<double> middle(i - 0.5 * (bricks - 1), 0.5 * course + 0.25, 0);
      const std::string name = numbered(numbered("course", course + 1), i + 1);
      scene.bodies.push_back(box_body(name, {0.5, 0.25, 0.25}, middle));
    }
  }
  return scene;
}

/// The wall, and a ball of 50 kg that comes at the middle of it at 20 m/s.
inline Scene wall_hit(int trajectories)
{
  Scene scene = wall(trajectories);
  SceneBody sphere = ball_body("ball", 0.5, {0, 0.25 * trajectories, 5}, 50);
  sphere.velocity = {0, 0, -20};
  scene.bodies.push_back(sphere);
  return scene;
}

/// A movable table top on so many legs.
inline Scene table_on(int legs)
{
  Scene scene = standing(5);
  for (int i = 0; i < legs; ++i)
  {
    const Vector3<double> middle(0.25 * i, 0.5, 0);
    scene.bodies.push_back(box_body(numbered("leg", i + 1), {0.1, 0.5, 0.1}, middle));
  }
  const double half = 0.125 * (legs - 1);
  scene.bodies.push_back(box_body("top", {half + 0.2, 0.1, 0.5}, {half, 1.1, 0}, 10));
  return scene;
}

/// How many cells a cube has along a side that holds so many.
inline int cells_along(int count)
{
  int side = 1;
  while (side * side * side < count)
  {
    ++side;
  }
  return side;
}

/// The middle [m] of a cell of unit size, in the cube of cells that stands on the ground.
inline Vector3<double> cell(int i, int side)
{
  const double middle = 0.5 * (side - 1);
  return {i % side - middle, i / (side * side) + 0.5, i / side % side - middle};
}

/// Cubes of 1 m, upright, that fall together from a cube of cells 10 cm apart, each layer 3 cm
/// beside the one below.
inline Scene cubes(int count)
{
  Scene scene = standing(10);
  const int side = cells_along(count);
  for (int i = 0; i < count; ++i)
  {
    Vector3<double> middle = 1.1 * cell(i, side);
    middle.x() += i / (side * side) % 2 == 0 ? 0.015 : -0.015;
    scene.bodies.push_back(cube_body(numbered("cube", i + 1), middle));
  }
  return scene;
}

/// Cubes of 1 m side by side on the ground, too far apart to touch.
inline Scene floor_of_cubes(int count)
{
  Scene scene = standing(10);
  int side = 1;
  while (side * side < count)
  {
    ++side;
  }
  for (int i = 0; i < count; ++i)
  {
    const Vector3<double> middle(
        1.25 * (i % side - 0.5 * (side - 1)), 0.5, 1.25 * (i / side - 0.5 * (side - 1)));
    scene.bodies.push_back(cube_body(numbered("cube", i + 1), middle));
  }
  return scene;
}

/// Balls of 50 cm across that fall into a pit with four walls.
inline Scene pit(int count)
{
  Scene scene = standing(10);
  const int side = cells_along(count);
  const double half = 0.3 * side + 0.05;
  for (const double displacement : {-1.0, 1.0})
  {
    const double middle = displacement * (half + 0.25);
    const std::string name = displacement < 0 ? "low" : "high";
    scene.bodies.push_back(
        box_body(name + "_x", {0.25, 2.0 * half, half + 0.5}, {middle, 2.0 * half, 0}, 0));
    scene.bodies.push_back(
        box_body(name + "_z", {half, 2.0 * half, 0.25}, {0, 2.0 * half, middle}, 0));
  }
  Mixer mixer;
  for (int i = 0; i < count; ++i)
  {
    Vector3<double> middle = 0.6 * cell(i, side);
    middle.x() += mixer.between(-4, 4) / 100.0;
    middle.z() += mixer.between(-4, 4) / 100.0;
    scene.bodies.push_back(ball_body(numbered("ball", i + 1), 0.25, middle));
  }
  return scene;
}

/// Balls of 50 cm across that fly through each other's ways without gravity, and lose nothing when
/// they meet.
inline Scene swarm(int count)
{
  Scene scene{.gravity = {0, 0, 0}, .duration = 10};
  const int side = cells_along(count);
  Mixer mixer;
  for (int i = 0; i < count; ++i)
  {
    SceneBody sphere = ball_body(numbered("ball", i + 1), 0.25, 2.0 * cell(i, side));
    const auto speed = [&mixer] { return mixer.between(-20, 20) / 10.0; };
    const double x = speed(), y = speed(), z = speed();
    sphere.velocity = {x, y, z};
    sphere.restitution = 1;
    scene.bodies.push_back(sphere);
  }
  return scene;
}

} // namespace cookbook::scenes
