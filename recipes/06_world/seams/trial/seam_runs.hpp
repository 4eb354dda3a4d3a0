#pragma once

/// \file
/// \brief The same body on flush tiles and on one slab: how far its two runs differ.

#include "06_world/game_world/solvers.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace cookbook::seams
{

/// A body that starts on a floor, whose top is y = 0, and moves along it.
struct SeamRun
{
  SceneBody body;        ///< at its place on the floor, with its velocity
  double tile = 1;       ///< [m], the edge of a tile, a cube
  double friction = 0.6; ///< [1], of all surfaces
  double duration = 1;   ///< [s]
};

/// How far a run on tiles is from that on the slab, at worst.
struct SeamError
{
  double height = 0; ///< [m]
  double speed = 0;  ///< [1], of the speed at the start
  double place = 0;  ///< [m], across and along, at the end
};

/// A sphere [m] which rolls at a speed [m/s] on a heading [rad] from a place.
inline SceneBody rolling_sphere(double radius, double speed, double heading, double x, double z)
{
  SceneBody body = ball_body("sphere", radius, {x, radius, z});
  const Vector3<double> along(std::cos(heading), 0, std::sin(heading));
  body.velocity = speed * along;
  body.angular_velocity = Vector3<double>::UnitY().cross(along) * (speed / radius);
  return body;
}

/// A crate [m] which slides at a speed [m/s] on a heading [rad] from a place, turned [rad].
inline SceneBody sliding_crate(
    const Vector3<double>& half_extents, double speed, double heading, double turn, double x,
    double z)
{
  SceneBody body = box_body("crate", half_extents, {x, half_extents.y(), z});
  body.velocity = speed * Vector3<double>(std::cos(heading), 0, std::sin(heading));
  body.orientation = Quaternion<double>(std::cos(turn / 2), 0, std::sin(turn / 2), 0);
  return body;
}

/// How far [m] a body reaches from its centre.
inline double reach_of(const SceneBody& body)
{
  const BoxShape* const box = std::get_if<BoxShape>(&body.shape);
  return box ? box->half_extents.norm() : std::get<SphereShape>(body.shape).radius;
}

/// The run on one slab.
inline Scene on_slab(const SeamRun& run)
{
  Scene scene;
  scene.name = "slab";
  scene.bodies.push_back(box_body("slab", {1000, run.tile / 2, 1000}, {0, -run.tile / 2, 0}, 0));
  scene.bodies.push_back(run.body);
  for (SceneBody& body : scene.bodies)
  {
    body.friction = run.friction;
  }
  return scene;
}

/// The same on tiles, as many as the body may come near.
inline Scene on_tiles(const SeamRun& run)
{
  Scene scene;
  scene.name = "tiles";
  const Vector3<double> start = run.body.position;
  const Vector3<double> end = start + run.duration * run.body.velocity;
  const double half = run.tile / 2, near_path = reach_of(run.body) + run.tile + 0.02;
  const auto tiles = [&](double length) { return static_cast<int>(std::floor(length / run.tile)); };
  const Vector3<double> low = start.cwiseMin(end), high = start.cwiseMax(end);
  const Vector3<double> along = (end - start).normalized();
  for (int i = tiles(low.x() - near_path); i <= tiles(high.x() + near_path) + 1; ++i)
  {
    for (int j = tiles(low.z() - near_path); j <= tiles(high.z() + near_path) + 1; ++j)
    {
      const Vector3<double> center(i * run.tile, -half, j * run.tile);
      const Vector3<double> from = center - start;
      if (std::abs(along.z() * from.x() - along.x() * from.z()) <= near_path)
      {
        scene.bodies.push_back(box_body("tile", Vector3<double>::Constant(half), center, 0));
      }
    }
  }
  scene.bodies.push_back(run.body);
  for (SceneBody& body : scene.bodies)
  {
    body.friction = run.friction;
  }
  return scene;
}

/// Runs a scene beside another, and compares their last bodies in every step.
inline SeamError
difference(const Scene& tiles, const Scene& slab, const std::string& solver, double duration)
{
  GameWorld one(tiles, solver_named(solver)), other(slab, solver_named(solver));
  const double start = std::max(1e-3, slab.bodies.back().velocity.norm());
  SeamError error;
  while (one.time() < duration)
  {
    one.step();
    other.step();
    const Motion<double>&a = one.bodies().back().motion, &b = other.bodies().back().motion;
    const double height = slab.gravity.normalized().dot(a.center - b.center);
    error.height = std::max(error.height, std::abs(height));
    error.speed = std::max(error.speed, std::abs(a.velocity.norm() - b.velocity.norm()) / start);
    error.place = (a.center - b.center).norm();
  }
  return error;
}

/// The same for a run on tiles and on the slab.
inline SeamError difference(const SeamRun& run, const std::string& solver)
{
  return difference(on_tiles(run), on_slab(run), solver, run.duration);
}

} // namespace cookbook::seams
