#pragma once

/// \file
/// \brief Boxes and balls on the floor y = 0, and the places where they may touch: always the same.

#include "05_resolution/friction/friction.hpp"

#include <vector>

namespace cookbook
{

/// A box, or a ball whose half extents are zero, as it moves.
struct Solid
{
  Body<double> body;                     ///< mass and motion
  MassProperties<double> mass;           ///< as it was weighed
  Vector3<double> half_extents;          ///< [m], of a box
  double radius = 0;                     ///< [m], of a ball
  Quaternion<double> turned{1, 0, 0, 0}; ///< body to world
};

/// A box of a mass [kg] that stands on the floor, its centre over the origin.
inline Solid box_on_floor(double mass, const Vector3<double>& half_extents)
{
  const Vector3<double> zero = Vector3<double>::Zero();
  const MassProperties<double> weighed = solid_box(mass, half_extents);
  const Motion<double> rest{{0, half_extents.y(), 0}, zero, zero};
  return {dynamic_body<double>(rest, weighed, Matrix3<double>::Identity()), weighed, half_extents};
}

/// A ball of a mass [kg] and a radius [m] at a place.
inline Solid ball_at(const Vector3<double>& center, double mass, double radius)
{
  const Vector3<double> zero = Vector3<double>::Zero();
  const MassProperties<double> weighed = solid_sphere(mass, radius);
  const Motion<double> rest{center, zero, zero};
  return {dynamic_body<double>(rest, weighed, Matrix3<double>::Identity()), weighed, zero, radius};
}

/// A place where two solids may touch, and what it has given in this step.
struct Touch
{
  std::size_t a;                                    ///< the lower solid
  std::size_t b;                                    ///< the upper one
  Vector3<double> corner;                           ///< [m], in b's own axes, from its centre
  double friction;                                  ///< [1]
  double weight;                                    ///< [N], what it bears if all share b's weight
  Vector3<double> point = Vector3<double>::Zero();  ///< [m], world
  double mass = 0;                                  ///< [kg], that a push along the normal feels
  SlidingMass<double> sliding{};                    ///< [kg], what one along the surface feels
  double gap = 0;                                   ///< [m], negative: a depth
  double pushed = 0;                                ///< [N s], along the normal
  Vector2<double> rubbed = Vector2<double>::Zero(); ///< [N s], along the surface
};

/// Solids and the places where they may touch; the first is the floor.
struct OneContactScene
{
  std::vector<Solid> solids;                       ///< the floor, then what moves
  std::vector<Touch> touches;                      ///< in order of visit
  Vector3<double> gravity{0, -9.81, 0};            ///< [m/s²]
  Vector3<double> force = Vector3<double>::Zero(); ///< [N], on the first that moves
  double step = 1.0 / 240;                         ///< [s]
  int passes = 20;                                 ///< over all touches, a step
};

/// A scene of solids on a floor of a friction: a box touches it with its corners, a ball touches
/// the first solid, or the floor if it is the first itself.
inline OneContactScene on_floor(const std::vector<Solid>& solids, double friction)
{
  OneContactScene scene;
  const Vector3<double> zero = Vector3<double>::Zero();
  scene.solids.push_back({static_body(zero), {1, zero}, zero});
  scene.solids.insert(scene.solids.end(), solids.begin(), solids.end());
  for (std::size_t i = 1; i < scene.solids.size(); ++i)
  {
    const Solid& solid = scene.solids[i];
    const double weight = 9.81 * solid.mass.mass;
    if (solid.radius > 0)
    {
      scene.touches.push_back({i == 1 ? 0u : 1u, i, zero, friction, weight});
      continue;
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vector3<double> sign(corner & 2 ? 1 : -1, corner & 4 ? 1 : -1, corner & 1 ? 1 : -1);
      scene.touches.push_back({0, i, sign.cwiseProduct(solid.half_extents), friction, weight / 4});
    }
  }
  return scene;
}

/// Places a touch where its solids are now: a corner, or a ball's lowest point, over a's top.
inline void locate(const OneContactScene& scene, Touch& touch)
{
  const Solid& a = scene.solids[touch.a];
  const Solid& b = scene.solids[touch.b];
  const Vector3<double> corner = b.turned * touch.corner;
  touch.point = b.body.motion.center + corner - Vector3<double>(0, b.radius, 0);
  touch.gap = touch.point.y() - a.body.motion.center.y() - a.half_extents.y();
}

/// Adds the step's gravity, and the force on the first solid, to the velocities.
inline void pull(OneContactScene& scene)
{
  for (std::size_t i = 1; i < scene.solids.size(); ++i)
  {
    scene.solids[i].body.motion.velocity += scene.step * scene.gravity;
  }
  Body<double>& first = scene.solids[1].body;
  first.motion.velocity += scene.step * first.inverse_mass * scene.force;
}

/// Moves and turns the solids for a step; what cannot be turned stays so.
inline void move(OneContactScene& scene)
{
  for (std::size_t i = 1; i < scene.solids.size(); ++i)
  {
    Solid& solid = scene.solids[i];
    solid.body.motion.center += scene.step * solid.body.motion.velocity;
    if (solid.body.inverse_inertia.isZero(0))
    {
      continue;
    }
    const Vector3<double> half = scene.step / 2 * solid.body.motion.angular_velocity;
    solid.turned =
        (Quaternion<double>(1, half.x(), half.y(), half.z()) * solid.turned).normalized();
    solid.body.inverse_inertia =
        world_inverse_inertia(solid.mass.moments, solid.turned.toRotationMatrix());
  }
}

} // namespace cookbook
