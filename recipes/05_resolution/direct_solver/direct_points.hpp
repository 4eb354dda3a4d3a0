#pragma once

/// \file
/// \brief What pushes at the contact points of an island at given velocities, and how stiffly.

#include "05_resolution/islands/island.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cookbook
{

// [direct_settings]
/// How the direct solver is run.
struct DirectSettings
{
  double compliance = 1e-7;         ///< [1], of the inverse masses that meet at a contact
  double correction = 0.2;          ///< [1], share of an overlap that a step takes away
  double correction_speed = 0.5;    ///< [m/s], no overlap is taken away faster
  double tolerance = 1e-9;          ///< [1], of the largest impulse: what may be missing
  double friction_tolerance = 1e-6; ///< [1], of the same: how far friction may be off its cone
  int iterations = 8;               ///< of Newton's method, after which it gives up
  std::size_t products = 100'000;   ///< of blocks, above which factoring takes too long
};
// [direct_settings]

// [direct_point]
/// What friction does at a contact point.
enum class Grip
{
  none,  ///< nothing: there is no push
  stick, ///< holds the surfaces together
  slip   ///< is as large as it can be
};

/// A contact point as Newton's method sees it.
struct DirectPoint
{
  Vector3<double> arm_a, arm_b; ///< [m], world, from the centres of mass
  double bias;                  ///< [m/s], the speed at which the gap may close, or is to open
  double bound;                 ///< [N s], the most that friction can do; infinite: not known yet
  bool solved;                  ///< whether the frame before knew it
  bool pressed;                 ///< whether the surfaces push
  Grip grip;                    ///< what friction does
  double impulse;               ///< [N s], along the normal
  Vector3<double> friction;     ///< [N s], across it
  Vector3<double> slip;         ///< [m/s], across it
};

/// Sets what pushes at a point whose surfaces move past each other at a velocity [m/s].
///
/// Both the push and friction are stiff springs, of a softness [1/kg]: an impulse for a speed.
inline void press(
    DirectPoint& point, const Vector3<double>& normal, const Vector3<double>& moving,
    double softness)
{
  const double speed = moving.dot(normal);
  point.slip = moving - speed * normal;
  point.impulse = std::max(0.0, -(speed + point.bias) / softness);
  point.pressed = point.impulse > 0;
  const bool known = point.bound < std::numeric_limits<double>::infinity();
  const bool grips = known ? point.bound > 0 : point.pressed;
  point.grip = grips ? Grip::stick : Grip::none;
  point.friction = point.slip * (grips ? -1 / softness : 0);
  const double size = point.friction.norm();
  if (size > point.bound)
  {
    point.friction *= point.bound / size;
    point.grip = Grip::slip;
  }
}

/// How much impulse [N s] a velocity [m/s] at a pressed point changes: its stiffness [kg].
inline Matrix3<double>
stiffness(const DirectPoint& point, const Vector3<double>& normal, double softness)
{
  const Matrix3<double> along = normal * normal.transpose();
  const Matrix3<double> across = Matrix3<double>::Identity() - along;
  Matrix3<double> sum = Matrix3<double>::Zero();
  if (point.pressed)
  {
    sum += along / softness;
  }
  if (point.grip == Grip::stick)
  {
    sum += across / softness;
  }
  if (point.grip == Grip::slip)
  {
    const double speed = point.slip.norm();
    const Vector3<double> way = point.slip / speed;
    sum += (across - way * way.transpose()) * (point.bound / speed);
  }
  return sum;
}
// [direct_point]

} // namespace cookbook
