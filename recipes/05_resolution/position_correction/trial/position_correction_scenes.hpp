#pragma once

/// \file
/// \brief A cube that starts inside the floor, and the ways to get it out, frame by frame.

#include "03_sphere_manifolds/collision/collision.hpp"
#include "05_resolution/position_correction/position_correction.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace cookbook
{

/// A cube that goes up and down only, over a floor of one tile or more that all report it.
struct SunkCube
{
  double bottom = -0.5;                 ///< [m], of its underside over the floor
  double speed = 0;                     ///< [m/s], upwards
  double fastest = 0;                   ///< [m/s], that it has been so far
  double mass = 1;                      ///< [kg]
  std::vector<double> impulses = {0.0}; ///< [N s], of each tile in this step
};

inline constexpr double frame_time = 1.0 / 60; ///< [s]
inline constexpr double earth_gravity = 9.81;  ///< [m/s²]
inline constexpr double push_limit =
    3; ///< [m/s], the largest correction speed, where it is limited
inline constexpr double push_share = 0.2; ///< [1], of the depth, taken away in a step or pass
inline constexpr double no_limit = std::numeric_limits<double>::infinity(); ///< [m/s]

// [push_out]
/// Lets each tile push until the speeds are right: once is enough, for the tiles agree.
inline void push(SunkCube& cube, const Softness<double>& soft, double bias)
{
  for (double& impulse : cube.impulses)
  {
    const double change = soft_change(soft, cube.mass, cube.speed, bias, impulse);
    impulse += change;
    cube.speed += change / cube.mass;
  }
  cube.fastest = std::max(cube.fastest, std::abs(cube.speed));
}

/// Adds gravity to the speed, and pushes from zero where the cube touches the floor.
inline void fall_and_push(SunkCube& cube, double bias)
{
  cube.speed -= earth_gravity * frame_time;
  std::fill(cube.impulses.begin(), cube.impulses.end(), 0.0);
  if (cube.bottom <= 0)
  {
    push(cube, rigid<double>(), bias);
  }
}
// [push_out]

// [ways_out]
/// All of the depth that each tile found, at once; S6.
inline void project(SunkCube& cube)
{
  fall_and_push(cube, 0);
  cube.bottom += cube.speed * frame_time;
  Manifold<double> found{Vector3<double>::UnitY(), std::max(0.0, -cube.bottom), {}};
  for (std::size_t tile = 0; tile < cube.impulses.size(); ++tile)
  {
    cube.bottom += separating_moves(found, 0.0, 1 / cube.mass).b.y();
  }
}

/// A fraction of the depth, by a speed that the cube keeps; R11.
inline void push_with_speed(SunkCube& cube, double limit)
{
  fall_and_push(cube, bias_velocity(-cube.bottom, 0.0, push_share / frame_time, limit));
  cube.bottom += cube.speed * frame_time;
}

/// A fraction of the depth, by a speed of its own that the cube forgets: split impulse.
inline void push_beside_speed(SunkCube& cube, double limit)
{
  SunkCube beside = cube;
  beside.speed = earth_gravity * frame_time; // nothing pulls at this speed
  const double bias = bias_velocity(-cube.bottom, 0.0, push_share / frame_time, limit);
  fall_and_push(cube, 0);
  fall_and_push(beside, bias);
  cube.bottom += (cube.speed + beside.speed) * frame_time;
}

/// Passes over the positions, each by a fraction of the depth beyond a millimetre; R12.
inline void relax_positions(SunkCube& cube, int passes)
{
  fall_and_push(cube, 0);
  cube.bottom += cube.speed * frame_time;
  for (int pass = 0; pass < passes; ++pass)
  {
    for (std::size_t tile = 0; tile < cube.impulses.size(); ++tile)
    {
      cube.bottom += position_correction(-cube.bottom, 0.001, push_share);
    }
  }
}

/// Four small steps with a spring of so many turns a second [Hz], each followed by a push without
/// it that takes the speed of the spring away again; R13.
inline void push_softly(SunkCube& cube, double frequency, double limit, bool relax = true)
{
  const double step = frame_time / 4;
  const Softness<double> soft = softness(frequency, 10.0, step);
  for (int i = 0; i < 4; ++i)
  {
    const bool touches = cube.bottom <= 0;
    for (double& impulse : cube.impulses)
    {
      impulse = touches ? impulse : 0;
      cube.speed += impulse / cube.mass;
    }
    cube.speed -= earth_gravity * step;
    if (touches)
    {
      push(cube, soft, bias_velocity(-cube.bottom, 0.0, soft.bias_rate, limit));
    }
    cube.bottom += cube.speed * step;
    if (touches && relax)
    {
      push(cube, rigid<double>(), 0);
    }
  }
}
// [ways_out]

/// A method of position correction, a frame at a time.
struct Correction
{
  std::string name;                       ///< as on the page
  std::function<void(SunkCube&)> advance; ///< one frame
};

/// The ways that compete; the last is the one to take.
inline std::vector<Correction> corrections()
{
  return {
      {"projection", [](SunkCube& cube) { project(cube); }},
      {"Baumgarte", [](SunkCube& cube) { push_with_speed(cube, no_limit); }},
      {"Baumgarte, ≤ 3 m/s", [](SunkCube& cube) { push_with_speed(cube, push_limit); }},
      {"non-linear Gauss–Seidel, 4 passes", [](SunkCube& cube) { relax_positions(cube, 4); }},
      {"split impulse, ≤ 3 m/s", [](SunkCube& cube) { push_beside_speed(cube, push_limit); }},
      {"soft, 30 Hz, ≤ 3 m/s", [](SunkCube& cube) { push_softly(cube, 30, push_limit); }}};
}

/// The cube after each frame, for some time [s]; first as it starts.
inline std::vector<SunkCube> run_out(SunkCube cube, const Correction& way, double time)
{
  std::vector<SunkCube> rows;
  rows.push_back(cube);
  for (int i = 0; i < int(std::lround(time / frame_time)); ++i)
  {
    way.advance(cube);
    rows.push_back(cube);
  }
  return rows;
}

} // namespace cookbook
