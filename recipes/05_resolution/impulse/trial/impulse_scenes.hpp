#pragma once

/// \file
/// \brief Two balls, and a cube that lands on a floor or on a pebble.

#include "03_sphere_manifolds/sphere_box/sphere_box.hpp"
#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"
#include "04_obb_manifolds/edge_clipping/edge_clipping.hpp"
#include "05_resolution/impulse/bounce.hpp"
#include "05_resolution/impulse/trial/conserved.hpp"
#include "common/math/rotation.hpp"

#include <string>
#include <vector>

namespace cookbook
{

/// Two balls that touch: A comes from the left at 2 m/s, B stands up to the right of it.
struct TwoBalls
{
  Sphere<double> shape_a;              ///< ball A
  Sphere<double> shape_b;              ///< ball B
  MassProperties<double> properties_a; ///< of 1 kg
  MassProperties<double> properties_b; ///< of the mass asked for
  BodyPair<double> bodies;             ///< before the bounce
  Manifold<double> manifold;           ///< where they touch
};

/// The two balls, with B's mass [kg]; the centres are a 3-4-5 triangle apart.
inline TwoBalls two_balls(double mass_b)
{
  const Vector3<double> zero = Vector3<double>::Zero();
  const Matrix3<double> upright = Matrix3<double>::Identity();
  const Sphere<double> a{zero, 0.3125};
  const Sphere<double> b{{0.375, 0.5, 0}, 0.3125};
  const MassProperties<double> of_a = solid_sphere(1.0, a.radius);
  const MassProperties<double> of_b = solid_sphere(mass_b, b.radius);
  return {
      a,
      b,
      of_a,
      of_b,
      {dynamic_body({a.center, {2, 0, 0}, zero}, of_a, upright),
       dynamic_body({b.center, zero, zero}, of_b, upright)},
      sphere_sphere(a, b).value()};
}

/// The sums of momentum, angular momentum and energy of the two balls as they move.
inline Conserved<double> conserved(const TwoBalls& balls, const BodyPair<double>& bodies)
{
  return conserved(
             bodies.a.motion, balls.properties_a.mass,
             Matrix3<double>(balls.properties_a.moments.asDiagonal())) +
         conserved(
             bodies.b.motion, balls.properties_b.mass,
             Matrix3<double>(balls.properties_b.moments.asDiagonal()));
}

/// A cube of 1 kg and 1 m, A, that comes down at 1 m/s onto something immovable, B.
struct Landing
{
  std::string name;              ///< on what it lands
  Obb<double> cube;              ///< shape A
  BodyPair<double> bodies;       ///< before the bounce
  Manifold<double, 48> manifold; ///< where they touch
};

/// The cube's resistance.
inline MassProperties<double> unit_cube()
{
  return solid_box<double>(1, {0.5, 0.5, 0.5});
}

/// A cube that comes down with its centre at a place.
inline Body<double> falling_cube(const Obb<double>& cube)
{
  const Vector3<double> zero = Vector3<double>::Zero();
  return dynamic_body({cube.center, {0, -1, 0}, zero}, unit_cube(), cube.axes);
}

/// A cube, turned so that its axes are the columns of a matrix, as it meets the floor y = 0.
///
/// It is let in by a nanometre, so that rounding cannot take it for apart.
inline Landing on_floor(const std::string& name, const Matrix3<double>& axes)
{
  const double height = axes.row(1).cwiseAbs().sum() / 2 - 1e-9;
  const Obb<double> cube{{0, height, 0}, axes, {0.5, 0.5, 0.5}};
  const Obb<double> floor{{0, -0.5, 0}, Matrix3<double>::Identity(), {5, 0.5, 5}};
  return {
      name,
      cube,
      {falling_cube(cube), static_body(floor.center)},
      edge_clipping(cube, floor).value()};
}

/// The manifold with room for as many points as a landing has.
inline Manifold<double, 48> roomy(const Manifold<double>& manifold)
{
  Manifold<double, 48> result{manifold.normal, manifold.depth, {}};
  for (const ContactPoint<double>& point : manifold.points)
  {
    result.points.push_back(point);
  }
  return result;
}

/// A level cube one of whose lower corners, (½, −½, ½) from its centre, meets a pebble.
inline Landing on_pebble()
{
  const Obb<double> cube{{0, 0.5, 0}, Matrix3<double>::Identity(), {0.5, 0.5, 0.5}};
  const Sphere<double> pebble{{0.5, -0.125, 0.5}, 0.125};
  return {
      "level, one corner on a pebble",
      cube,
      {falling_cube(cube), static_body(pebble.center)},
      roomy(swapped(sphere_box(pebble, cube)).value())};
}

/// Four ways for the cube to land.
inline std::vector<Landing> landings()
{
  return {
      on_floor("flat", Matrix3<double>::Identity()),
      on_floor("on an edge, turned by 36.87°", rational_rotation<double>(3, 0, 0, 1)),
      on_floor("on a corner, askew", rational_rotation<double>(3, 1, 0, 1)), on_pebble()};
}

} // namespace cookbook
