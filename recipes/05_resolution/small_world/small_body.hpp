#pragma once

/// \file
/// \brief A body of the small world: a solid sphere or box, how it moves, and its manifold with
/// another.

// [head]
#include "01_math/turning/rotation_by.hpp"
#include "03_sphere_manifolds/plain_spheres/plain_sphere_box.hpp"
#include "04_obb_manifolds/plain_box_box/plain_box_box.hpp"
#include "05_resolution/impulse/body.hpp"

#include <limits>
#include <stdexcept>
#include <string>

namespace cookbook::small_world
{
// [head]

// [rigid_body]
/// A solid sphere or box. One without mass is fixed: it moves only with the velocity it is given.
struct RigidBody : Body<double>
{
  bool is_sphere;
  Vector3<double> half_extents;               ///< [m], of a box; a sphere's radius, three times
  Vector3<double> moments;                    ///< [kg m²], about its own axes
  Quaternion<double> orientation{1, 0, 0, 0}; ///< [1], body to world, length one
  double friction = 0.6;                      ///< [1], Coulomb's coefficient μ
  double restitution = 0;                     ///< [1], 0 to 1; from step 5 on
};

/// Turns a body, and its inertia with it; M12.
inline void set_orientation(RigidBody& body, const Quaternion<double>& orientation)
{
  body.orientation = orientation.normalized();
  const Matrix3<double> axes = body.orientation.toRotationMatrix();
  body.inverse_inertia = world_inverse_inertia<double>(body.moments, axes);
}

/// Moves a body on by a time [s] with the velocity it has; M9.
inline void integrate_position(RigidBody& body, double time)
{
  body.motion.center += time * body.motion.velocity;
  const Vector3<double> turn = time * body.motion.angular_velocity;
  set_orientation(body, rotation_by(turn) * body.orientation);
}
// [rigid_body]

// [make_body]
/// Refuses a number that is outside of what the small world is made for, or is none.
inline void check(const std::string& member, double value, double least, double most)
{
  if (!(value >= least && value <= most))
  {
    throw std::invalid_argument(
        member + " is " + std::to_string(value) + "; it must be from " + std::to_string(least) +
        " to " + std::to_string(most));
  }
}

/// A body at rest, not turned: its centre [m], half extents [m] and mass [kg], 0 for a fixed one.
inline RigidBody make_body(
    bool is_sphere, const Vector3<double>& center, const Vector3<double>& half_extents, double mass)
{
  check("mass", mass, mass == 0 ? 0 : 1e-6, 1e6);
  const double infinite = std::numeric_limits<double>::infinity();
  const MassProperties<double> properties =
      mass == 0   ? MassProperties<double>{infinite, Vector3<double>::Constant(infinite)}
      : is_sphere ? solid_sphere(mass, half_extents.x())
                  : solid_box(mass, half_extents);
  const Vector3<double> zero = Vector3<double>::Zero();
  const Motion<double> at_rest{center, zero, zero};
  const Body<double> body = dynamic_body<double>(at_rest, properties, Matrix3<double>::Identity());
  return {body, is_sphere, half_extents, properties.moments};
}

/// A box at rest, upright: its centre [m], half extents [m] and mass [kg], 0 for a fixed one.
inline RigidBody
box(const Vector3<double>& center, const Vector3<double>& half_extents, double mass)
{
  return make_body(false, center, half_extents, mass);
}

/// A sphere at rest: its centre [m], radius [m] and mass [kg], 0 for a fixed one.
inline RigidBody sphere(const Vector3<double>& center, double radius, double mass)
{
  return make_body(true, center, Vector3<double>::Constant(radius), mass);
}

/// Refuses a body that is not of a room: 1 mm to 1 km, 1 mg to 1,000 t, up to 10 km/s.
inline void check(const RigidBody& body)
{
  for (const double half_extent : body.half_extents)
  {
    check("half_extents", half_extent, 0.001, 1000);
  }
  check("inverse_mass", body.inverse_mass, 0, 1e6);
  check("orientation.norm()", body.orientation.norm(), 0.999, 1.001);
  check("center.norm()", body.motion.center.norm(), 0, 1e6);
  check("velocity.norm()", body.motion.velocity.norm(), 0, 1e4);
  check("angular_velocity.norm()", body.motion.angular_velocity.norm(), 0, 1e4);
  check("friction", body.friction, 0, 1e3);
  check("restitution", body.restitution, 0, 1);
}
// [make_body]

// [manifold_of]
/// The sphere that a body is.
inline Sphere<double> sphere_of(const RigidBody& body)
{
  return {body.motion.center, body.half_extents.x()};
}

/// The oriented box (OBB) that a body is.
inline Obb<double> box_of(const RigidBody& body)
{
  return {body.motion.center, body.orientation.toRotationMatrix(), body.half_extents};
}

/// The manifold of two bodies, from A to B; nothing where they are apart.
inline std::optional<Manifold<double>> manifold_of(const RigidBody& a, const RigidBody& b)
{
  if (a.is_sphere && b.is_sphere)
  {
    return plain_sphere_sphere(sphere_of(a), sphere_of(b));
  }
  if (a.is_sphere)
  {
    return plain_sphere_box(sphere_of(a), box_of(b));
  }
  if (b.is_sphere)
  {
    std::optional<Manifold<double>> manifold = plain_sphere_box(sphere_of(b), box_of(a));
    if (manifold)
    {
      manifold->normal = -manifold->normal;
    }
    return manifold;
  }
  return plain_box_box(box_of(a), box_of(b));
}
// [manifold_of]

} // namespace cookbook::small_world
