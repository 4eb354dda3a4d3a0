#pragma once

/// \file
/// \brief Contacts of a cloth's particles with planes, spheres, capsules and boxes, with friction.

#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"
#include "07_constraints/particles/particles.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace cookbook
{

// [obstacles]
/// What a cloth meets, all of it fixed.
struct Obstacles
{
  std::vector<Plane<double>> planes{};
  std::vector<Sphere<double>> spheres{};
  std::vector<Capsule<double>> capsules{};
  std::vector<Obb<double>> boxes{};
  double friction = 0.5;   ///< [1], coefficient
  double thickness = 0.01; ///< [m], radius of a particle, at which it touches
};
// [obstacles]

// [correct_contact]
/// Moves a particle out of an obstacle, and takes back how far it has slipped since it was `before`
/// [m], by no more than friction times that depth; R49.
inline void correct_contact(
    Vector3<double>& position, const Vector3<double>& before, const Manifold<double>& contact,
    double friction)
{
  position -= contact.depth * contact.normal; // from the particle to the obstacle
  const Vector3<double> moved = position - before;
  const Vector3<double> slip = moved - moved.dot(contact.normal) * contact.normal;
  const Direction<double> slipped = normalize<double>(slip);
  position -= std::min(slipped.length, friction * contact.depth) * slipped.unit;
}

/// The same of a particle with all obstacles of one shape; `find(particle, shape)` is chapter 3's.
template <class Shape, class Find>
void correct_contacts(
    Vector3<double>& position, const Vector3<double>& before, const std::vector<Shape>& shapes,
    const Obstacles& obstacles, const Find& find)
{
  for (const Shape& shape : shapes)
  {
    if (const auto contact = find({position, obstacles.thickness}, shape))
    {
      correct_contact(position, before, *contact, obstacles.friction);
    }
  }
}

/// The same of all particles, except pinned ones, with all obstacles.
inline void correct_contacts(
    Particles& particles, const std::vector<Vector3<double>>& before, const Obstacles& obstacles)
{
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    if (particles.inverse_masses[i] > 0)
    {
      Vector3<double>& x = particles.positions[i];
      correct_contacts(x, before[i], obstacles.planes, obstacles, plain_sphere_plane<double>);
      correct_contacts(x, before[i], obstacles.spheres, obstacles, plain_sphere_sphere<double>);
      correct_contacts(x, before[i], obstacles.capsules, obstacles, plain_sphere_capsule<double>);
      correct_contacts(x, before[i], obstacles.boxes, obstacles, plain_sphere_box<double>);
    }
  }
}
// [correct_contact]

} // namespace cookbook
