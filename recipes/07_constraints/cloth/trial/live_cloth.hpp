#pragma once

/// \file
/// \brief A cloth that is dragged by a pointer, and its picture.

#include "02_primitives/picture/picture.hpp"
#include "07_constraints/cloth/trial/cloth_scenes.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace cookbook
{

/// A scene to choose: a cloth, what is around it, and how it is looked at.
struct LiveCloth
{
  std::string name;
  Cloth (*make)();
  Orbit orbit;
  std::size_t grip;      ///< a particle that can be dragged
  Obstacles obstacles{}; ///< spheres alone
};

/// All of them.
inline std::vector<LiveCloth> live_cloths()
{
  return {
      {"flag", flag, {{0.7, -0.6, 0}, 2.6, -0.35, 0.15}, 24 + 8 * 25},
      {"square held at its corners",
       [] { return held_square(); },
       {{0, -0.2, 0}, 2, 0.5, 0.4},
       136},
      {"square that falls on a ball",
       [] { return falling_square(); },
       {{0, 0.05, 0}, 2.9, 0.5, 0.3},
       0,
       {.spheres = {{{0, 0, 0}, 0.35}}}}};
}

/// A particle of a cloth that a pointer holds: pinned, it goes where the pointer is.
struct DraggedParticle
{
  std::size_t place;      ///< in the lists
  double inverse_mass;    ///< [1/kg], which it gets back
  Vector3<double> target; ///< [m], world
};

/// Takes hold of the particle that is closest to a ray, if one is within 10 cm of it.
inline std::optional<DraggedParticle> take_hold(Cloth& cloth, const Ray<double>& ray)
{
  Particles& particles = cloth.particles;
  double least = 0.1;
  std::optional<DraggedParticle> held;
  for (std::size_t i = 0; i < particles.positions.size(); ++i)
  {
    const Vector3<double> to = particles.positions[i] - ray.origin;
    const double off = (to - to.dot(ray.direction) * ray.direction).norm();
    if (off < least)
    {
      least = off;
      held = {i, particles.inverse_masses[i], particles.positions[i]};
    }
  }
  if (held)
  {
    particles.inverse_masses[held->place] = 0;
  }
  return held;
}

/// Lets go, and what is held is free, or pinned, as it was.
inline void let_go(Cloth& cloth, std::optional<DraggedParticle>& held)
{
  if (held)
  {
    cloth.particles.inverse_masses[held->place] = held->inverse_mass;
    cloth.particles.velocities[held->place] *= held->inverse_mass > 0 ? 1 : 0;
  }
  held.reset();
}

/// Gives what is held the velocity with which it is at its target after a step [s], or 3 m/s.
inline void pull(Cloth& cloth, const DraggedParticle& held, double step)
{
  const Direction<double> way =
      normalize<double>(held.target - cloth.particles.positions[held.place]);
  cloth.particles.velocities[held.place] = std::min(way.length / step, 3.0) * way.unit;
}

/// Draws a cloth, blue in front and orange on its back, and the spheres around it.
inline void draw_cloth(
    Picture& picture, const Camera<double>& camera, const Cloth& cloth, const Obstacles& obstacles,
    const Palette& palette)
{
  clear(picture, palette);
  for (const Sphere<double>& sphere : obstacles.spheres)
  {
    draw_sphere(picture, camera, sphere, Matrix3<double>::Identity(), palette.muted);
  }
  const std::vector<Vector3<double>>& x = cloth.particles.positions;
  const Vector3<double> eye = camera.pose.translation();
  for (const auto& [a, b, c] : cloth.triangles)
  {
    const Vector3<double> n = normalize<double>((x[b] - x[a]).cross(x[c] - x[a])).unit;
    const bool front = n.dot(eye - x[a]) > 0;
    const double light = brightness(Light{}, front ? n : Vector3<double>(-n));
    draw_triangle(picture, camera, {x[a], x[b], x[c]}, lit(front ? palette.a : palette.b, light));
  }
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    if (cloth.particles.inverse_masses[i] == 0)
    {
      draw_dot(picture, camera, x[i], palette.ink, 2, Cover::none);
    }
  }
}

} // namespace cookbook
