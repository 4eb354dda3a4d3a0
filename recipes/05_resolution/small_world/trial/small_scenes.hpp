#pragma once

/// \file
/// \brief The scenes that the steps of the small world hold or fail, for a world of any step.

#include "05_resolution/small_world/step_4.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace cookbook::small_world
{

/// A frame [s].
inline constexpr double frame = 1.0 / 60;

/// A world with the ground in it: a fixed box of 200 m, its top at y = 0.
template <class World>
World ground()
{
  World world;
  add(world, box({0, -1, 0}, {100, 1, 100}, 0));
  return world;
}

/// A cube of 1 m and 1 kg, upright and at rest.
inline RigidBody cube(const Vector3<double>& center)
{
  return box(center, {0.5, 0.5, 0.5}, 1);
}

/// Cubes one on top of the other.
template <class World>
World tower(int count)
{
  World world = ground<World>();
  for (int i = 0; i < count; ++i)
  {
    add(world, cube({0, i + 0.5, 0}));
  }
  return world;
}

/// Rows of cubes, each with one less than the row below, with gaps of 12.5 cm beside them.
template <class World>
World pyramid(int rows)
{
  World world = ground<World>();
  for (int row = 0; row < rows; ++row)
  {
    for (int i = 0; i < rows - row; ++i)
    {
      add(world, cube({1.125 * (i - 0.5 * (rows - row - 1)), row + 0.5, 0}));
    }
  }
  return world;
}

// [floor_of_cubes]
/// Cubes on the ground, so many along x and along z, with gaps of 10 cm between them.
template <class World>
World floor_of_cubes(int side)
{
  World world = ground<World>();
  for (int i = 0; i < side * side; ++i)
  {
    const double middle = 0.5 * (side - 1);
    add(world, cube({1.1 * (i % side - middle), 0.5, 1.1 * (i / side - middle)}));
  }
  return world;
}
// [floor_of_cubes]

/// A sphere of 10 cm that falls from a height [m] with a restitution [1].
template <class World>
World dropped_sphere(double height, double restitution)
{
  World world = ground<World>();
  RigidBody ball = sphere({0, height + 0.1, 0}, 0.1, 1);
  ball.restitution = restitution;
  add(world, ball);
  return world;
}

/// A sphere of 5 cm that flies at a speed [m/s] along x at a fixed wall of 2 cm, without gravity.
template <class World>
World shot_at_wall(double speed)
{
  World world;
  world.gravity.setZero();
  add(world, box({0, 0, 0}, {0.01, 5, 5}, 0));
  RigidBody ball = sphere({-2, 0, 0}, 0.05, 1);
  ball.restitution = 0.5;
  ball.motion.velocity.x() = speed;
  add(world, ball);
  return world;
}

/// Moves a world on by a time [s], frame by frame.
template <class World>
void run(World& world, double time)
{
  const int frames = static_cast<int>(std::lround(time / frame));
  for (int i = 0; i < frames; ++i)
  {
    step(world, frame);
  }
}

/// The largest of what is measured of each body's move [m] since a start.
inline double largest_of_moves(
    const std::vector<RigidBody>& start, const std::vector<RigidBody>& now, const auto& measure)
{
  double largest = 0;
  for (std::size_t i = 0; i < start.size(); ++i)
  {
    const Vector3<double> move = now[i].motion.center - start[i].motion.center;
    largest = std::max(largest, measure(move));
  }
  return largest;
}

/// By how much [m] the body that sank most is lower after a time [s].
template <class World>
double largest_sink(World world, double time)
{
  const std::vector<RigidBody> start = world.bodies;
  run(world, time);
  return largest_of_moves(start, world.bodies, [](const auto& move) { return -move.y(); });
}

/// How far [m] the body that moved most is from where it was at a start.
inline double farthest_move(const std::vector<RigidBody>& start, const std::vector<RigidBody>& now)
{
  return largest_of_moves(start, now, [](const auto& move) { return move.norm(); });
}

/// The same after a time [s].
template <class World>
double largest_move(World world, double time)
{
  const std::vector<RigidBody> start = world.bodies;
  run(world, time);
  return farthest_move(start, world.bodies);
}

/// Whether a stack of cubes stands: none has sunk by half its size.
inline bool stands(double sink)
{
  return sink < 0.5;
}

/// How high [m] the last body of a world comes after it has first gone down to the ground, within a
/// time [s]; zero if it does not come up.
template <class World>
double height_of_bounce(World world, double time)
{
  double highest = 0;
  bool bounced = false;
  for (double now = 0; now < time; now += frame)
  {
    step(world, frame);
    const RigidBody& ball = world.bodies.back();
    bounced = bounced || ball.motion.velocity.y() > 0;
    const double height = ball.motion.center.y() - ball.half_extents.y();
    highest = bounced ? std::max(highest, height) : 0;
  }
  return highest;
}

/// Whether a shot comes back from the wall: it is before it after 2 s, and flies away from it.
template <class World>
bool comes_back(World world)
{
  run(world, 2);
  const Motion<double>& ball = world.bodies.back().motion;
  return ball.center.x() < 0 && ball.velocity.x() < 0;
}

// [pairs_compared]
/// How many pairs of bodies step 4's sort and sweep holds against each other: those whose AABBs
/// overlap along x.
inline std::size_t pairs_compared(const std::vector<RigidBody>& bodies)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    for (std::size_t j = i + 1; j < bodies.size(); ++j)
    {
      const Aabb<double> one = step_4::bounds_of(bodies[i]), other = step_4::bounds_of(bodies[j]);
      count += one.min().x() <= other.max().x() && other.min().x() <= one.max().x() ? 1U : 0U;
    }
  }
  return count;
}
// [pairs_compared]

} // namespace cookbook::small_world
