#pragma once

/// \file
/// \brief What pushes at the contact points of an island at given velocities, and how stiffly.

#include "06_world/islands/island_points.hpp"

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
  double friction_speed = 1e-4;     ///< [m/s], and no farther than changes two bodies by this
  int iterations = 8;               ///< of Newton's method, after which it gives up
  std::size_t products = 100'000;   ///< of blocks, above which factoring takes too long
  double give = 0;                  ///< [1], 0: contacts are stiff; 1: soft, as GiveSettings says
  double missing = 0;               ///< [N s], may be missing, however small impulses are
  bool bounds_move = true;   ///< whether bounds of friction follow the pushes found here, stays()
  bool opening_grips = true; ///< whether there is friction where an overlap opens
};

/// An overlap that opens no faster than this [m/s] does no harm, and is treated as none.
inline constexpr double slow_opening = 1e-3;
// [direct_settings]

// [direct_point]
/// What friction does at a contact point.
enum class Grip
{
  none,  ///< nothing: there is no push
  stick, ///< holds the surfaces together
  slip   ///< is as large as it can be
};

/// How stiff the points of a contact are: an impulse for a speed [kg].
struct DirectStiffness
{
  double push; ///< along the normal
  double grip; ///< across it
};

/// In which way a point pushes.
struct PushingWay
{
  bool pressed; ///< whether the surfaces push
  Grip grip;    ///< what friction does

  bool operator==(const PushingWay&) const = default;
};

/// Whether a point pushes at all.
inline bool pushes(const PushingWay& way)
{
  return way.pressed || way.grip != Grip::none;
}

/// A contact point as Newton's method sees it.
struct DirectPoint : PushingWay
{
  Arms<double> arms;        ///< [m], world, from the centres of mass
  double coefficient;       ///< [1], of friction
  double bias;              ///< [m/s], the speed at which the gap may close, or is to open
  double bound;             ///< [N s], the most that friction can do; infinite: not known yet
  bool bound_is_new;        ///< whether the frame before has left none
  bool solved;              ///< whether the frame before knew it
  Vector3<double> held;     ///< [N s], friction that there is without any slip
  double impulse;           ///< [N s], along the normal
  Vector3<double> friction; ///< [N s], across it
  Vector3<double> wanted;   ///< [N s], friction that would hold the surfaces
};

/// Sets what pushes at a point whose surfaces move past each other at a velocity [m/s].
///
/// Both the push and friction are springs.
inline void press(
    DirectPoint& point, const Vector3<double>& normal, const Vector3<double>& moving,
    const DirectStiffness& stiffness)
{
  const double speed = moving.dot(normal);
  const Vector3<double> slip = moving - speed * normal;
  point.impulse = accumulated_impulse(0.0, -(speed + point.bias) * stiffness.push);
  point.pressed = point.impulse > 0;
  const bool known = point.bound < std::numeric_limits<double>::infinity();
  const bool grips = known ? point.bound > 0 : point.pressed;
  point.grip = grips ? Grip::stick : Grip::none;
  point.wanted.setZero();
  if (grips)
  {
    point.wanted = point.held - slip * stiffness.grip;
  }
  point.friction = point.wanted;
  if (!(point.wanted.squaredNorm() <= point.bound * point.bound))
  {
    point.friction = within_cone<double, 3>(point.wanted, point.bound);
    point.grip = Grip::slip;
  }
}

/// A bound of friction so many times what the push at a point bears, and above it by more than this
/// share of the largest impulse, was set too early, by impulses that were still far from an answer.
inline constexpr double early_bound = 2, early_share = 0.1;

/// Whether the bound of friction stays where bounds do not move: what the frame before has left
/// does. Where it has left none, one is set, and again only if it was set too early: by what the
/// push there bears [N s] now, and by the largest impulse [N s].
inline bool stays(const DirectPoint& point, double bears, double largest)
{
  const bool early =
      point.bound > early_bound * bears && point.bound - bears > early_share * largest;
  return !point.bound_is_new || (point.bound < std::numeric_limits<double>::infinity() && !early);
}

/// How much impulse [N s] a velocity [m/s] at a point changes: its stiffness [kg].
inline Matrix3<double> stiffness_at(
    const DirectPoint& point, const Vector3<double>& normal, const DirectStiffness& stiffness)
{
  const Matrix3<double> along = normal * normal.transpose();
  const Matrix3<double> across = Matrix3<double>::Identity() - along;
  Matrix3<double> sum = Matrix3<double>::Zero();
  if (point.pressed)
  {
    sum += along * stiffness.push;
  }
  if (point.grip == Grip::stick)
  {
    sum += across * stiffness.grip;
  }
  if (point.grip == Grip::slip)
  {
    const double size = point.wanted.norm();
    const Vector3<double> way = point.wanted / size;
    sum += (across - way * way.transpose()) * (point.bound / size * stiffness.grip);
  }
  return sum;
}
// [direct_point]

} // namespace cookbook
