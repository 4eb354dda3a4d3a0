#pragma once

/// \file
/// \brief Slides, slopes and rolls with closed forms, and what each rule of friction makes of them.

#include "05_resolution/friction/trial/friction_scenes.hpp"
#include "common/math/trigonometry.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

/// A direction of the floor, from x towards z, by an angle in degrees.
inline Vector3<double> heading(double degrees)
{
  const double angle = degrees * std::numbers::pi / 180;
  return {cosine(angle), 0, sine(angle)};
}

/// A box of 1 kg on a slope that falls towards a heading: the floor stays, gravity is turned.
inline OneContactScene
on_slope(const Vector3<double>& half_extents, double friction, double slope, double towards = 0)
{
  OneContactScene scene = on_floor({box_on_floor(1, half_extents)}, friction);
  const double angle = slope * std::numbers::pi / 180;
  scene.gravity = 9.81 * sine(angle) * heading(towards);
  scene.gravity.y() = -9.81 * cosine(angle);
  return scene;
}

/// The unit cube on a slope.
inline OneContactScene cube_on_slope(double friction, double slope, double towards = 0)
{
  return on_slope(Vector3<double>::Constant(0.5), friction, slope, towards);
}

/// A block of 1 kg that slides over the floor with a friction of 0.4 [1] at a velocity [m/s].
inline OneContactScene sliding_block(const Vector3<double>& velocity, double friction = 0.4)
{
  OneContactScene scene = on_floor({box_on_floor(1, {0.5, 0.5, 0.5})}, friction);
  scene.solids[1].body.motion.velocity = velocity;
  return scene;
}

/// A ball of 1 kg and half a metre that slides at 7 m/s and does not spin yet.
inline OneContactScene sliding_ball()
{
  OneContactScene scene = on_floor({ball_at({0, 0.5, 0}, 1, 0.5)}, 0.2);
  scene.solids[1].body.motion.velocity = {7, 0, 0};
  return scene;
}

/// A box of 10 kg, pushed by 150 N along its diagonal, with 25 balls of 1 kg on top.
inline OneContactScene box_under_balls()
{
  std::vector<Solid> solids{box_on_floor(10, {1.5, 0.1, 1.5})};
  for (int i = 0; i < 25; ++i)
  {
    solids.push_back(ball_at({0.5 * (i % 5 - 2), 0.3, 0.5 * (i / 5 - 2)}, 1, 0.1));
  }
  OneContactScene scene = on_floor(solids, 0.4);
  for (Touch& touch : scene.touches)
  {
    touch.friction = touch.a == 0 ? 0.4 : 0.8;
  }
  scene.force = 150 * heading(45);
  return scene;
}

/// How far [m] a solid has come along the floor.
inline double way(const OneContactScene& scene)
{
  const Vector3<double>& center = mover(scene).center;
  return std::hypot(center.x(), center.z());
}

/// The shortest and the longest way [m] of a block at 5 m/s with μ = 0.4, over headings from 0° to
/// 90° in steps of 5°.
inline std::pair<double, double> stopping_ways(const FrictionRule& rule)
{
  std::pair<double, double> ways(1e9, 0);
  for (int degrees = 0; degrees <= 90; degrees += 5)
  {
    const double here = way(advanced(sliding_block(5 * heading(degrees)), rule, 2));
    ways = {std::min(ways.first, here), std::max(ways.second, here)};
  }
  return ways;
}

/// A ball that begins to roll.
struct Rolling
{
  double time;  ///< [s], when its lowest point came to rest, or the limit
  double speed; ///< [m/s], then
  double slip;  ///< [m/s], of its lowest point, then
};

/// When and how a ball's lowest point stops sliding, to a millimetre a second, within a limit [s].
inline Rolling begins_to_roll(OneContactScene scene, const FrictionRule& rule, double limit)
{
  Rolling rolling{0, 0, 1};
  while (rolling.slip > 1e-3 && rolling.time < limit)
  {
    advance(scene, rule);
    rolling.time += scene.step;
    const Motion<double>& ball = mover(scene);
    const Vector3<double> lowest = ball.center - Vector3<double>(0, 0.5, 0);
    rolling.slip = velocity_at<double>(ball, lowest).norm();
  }
  rolling.speed = mover(scene).velocity.norm();
  return rolling;
}

/// The accelerations [m/s²] of the box and of the ball in the middle, from 0.2 s to 1.2 s.
inline std::pair<double, double> accelerations(const FrictionRule& rule)
{
  const OneContactScene early = advanced(box_under_balls(), rule, 0.2);
  const OneContactScene late = advanced(early, rule, 1);
  const auto gained = [&](std::size_t i)
  {
    const Vector3<double>& before = early.solids[i].body.motion.velocity;
    return (late.solids[i].body.motion.velocity - before).norm();
  };
  return {gained(1), gained(14)};
}

} // namespace cookbook
