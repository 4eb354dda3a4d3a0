#pragma once

/// \file
/// \brief Scenes in which bodies slide, roll, bounce, spin, fly and fall over.

#include "06_world/scenes/trial/scene_bodies.hpp"

#include <algorithm>

namespace cookbook::scenes
{

/// A cube at rest on a slope through the origin that falls towards +x, given by the sine of its
/// angle, 0 to below 1, with one friction for both surfaces: rows S9 to S11.
inline Scene incline(double sine, double friction)
{
  const double cosine = std::sqrt(1 - sine * sine);
  const Vector3<double> normal(sine, cosine, 0);
  SceneBody slope{.name = "slope", .shape = PlaneShape{normal, 0}, .friction = friction};
  SceneBody block = cube_body("block", 0.5 * normal);
  block.orientation = turn_about_z(-sine, cosine);
  block.friction = friction;
  return {.duration = 4, .bodies = {slope, block}};
}

/// A ball of 25 cm that slides at 7 m/s, with friction 0.2, until it rolls at 5 m/s: row S28.
inline Scene rolling()
{
  Scene scene{.duration = 3, .bodies = {ground(), ball_body("ball", 0.25, {0, 0.25, 0})}};
  scene.bodies[1].velocity = {7, 0, 0};
  scene.bodies[0].friction = scene.bodies[1].friction = 0.2;
  return scene;
}

/// A cube without friction that slides at 3 m/s over ten tiles laid flush: row S22.
inline Scene tiles()
{
  Scene scene{.duration = 3};
  for (int i = 0; i < 10; ++i)
  {
    const Vector3<double> middle(i + 0.5, -0.5, 0);
    scene.bodies.push_back(box_body(numbered("tile", i + 1), {0.5, 0.5, 1}, middle, 0));
  }
  SceneBody cube = cube_body("cube", {0.5, 0.5, 0});
  cube.velocity = {3, 0, 0};
  cube.friction = 0;
  scene.bodies.push_back(cube);
  return scene;
}

/// A ball with restitution 1 from 5 m, and a cube with restitution 0.5 from 1 m: rows S15, S16.
inline Scene bounce()
{
  Scene scene{.duration = 20, .bodies = {ground()}};
  scene.bodies.push_back(ball_body("ball", 0.5, {-1.5, 5.5, 0}));
  scene.bodies.back().restitution = 1;
  scene.bodies.push_back(cube_body("cube", {1.5, 1.5, 0}));
  scene.bodies.back().restitution = 0.5;
  return scene;
}

/// Without gravity, two balls of 5 cm at a speed [m/s]: one flies at a wall of 2 cm and bounces
/// with restitution 1, the other passes 3 cm above the wall's edge: row J1.
inline Scene thin_wall(int speed)
{
  Scene scene{.gravity = {0, 0, 0}, .duration = std::max(0.1, 6.0 / speed)};
  scene.bodies.push_back(box_body("wall", {0.01, 1, 1}, {0, 0, 0}, 0));
  for (const bool hits : {true, false})
  {
    SceneBody sphere =
        ball_body(hits ? "ball" : "passing_ball", 0.05, {-2.5, hits ? 0.0 : 1.08, 0});
    sphere.velocity.x() = speed;
    sphere.restitution = 1;
    scene.bodies.push_back(sphere);
  }
  return scene;
}

/// A box with moments of inertia 1, 2 and 2.6 kg m², free, that turns at 10 rad/s about the middle
/// axis, nearly: it flips; row I4.
inline Scene spinning_top()
{
  SceneBody top = box_body("top", {1.5, 1, 0.5}, {0, 0, 0}, 2.4);
  top.angular_velocity = {0.01, 10, 0.01};
  return {.gravity = {0, 0, 0}, .duration = 10, .bodies = {top}};
}

/// Upright tiles in a row, half a metre apart; the first one turns about its lower edge, and falls.
inline Scene domino(int count)
{
  Scene scene{.duration = 10, .bodies = {ground()}};
  for (int i = 0; i < count; ++i)
  {
    const Vector3<double> middle(0.5 * (i - 0.5 * (count - 1)), 0.5, 0);
    scene.bodies.push_back(box_body(numbered("tile", i + 1), {0.05, 0.5, 0.25}, middle));
  }
  SceneBody& first = scene.bodies[1];
  first.angular_velocity = {0, 0, -1.5};
  first.velocity = first.angular_velocity.cross(Vector3<double>(-0.05, 0.5, 0));
  return scene;
}

} // namespace cookbook::scenes
