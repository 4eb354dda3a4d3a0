#pragma once

/// \file
/// \brief What pushes at the contact points of an island at given velocities, and how stiffly.

#include "06_world/constraints/taut_pull.hpp"
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
  double correction = 0.2;          ///< [1], fraction of an overlap that a step takes away
  double row_correction = 1;        ///< [1], the same of the error of a joint
  double correction_speed = 0.5;    ///< [m/s], no overlap is taken away faster
  double tolerance = 1e-9;          ///< [1], of the largest impulse: what may be left of a residual
  double friction_tolerance = 1e-6; ///< [1], of the same: how far friction may be off its cone
  double friction_speed = 1e-4;     ///< [m/s], and no farther than changes two bodies by this
  int iterations = 8;               ///< of Newton's method, after which it gives up
  std::size_t products = 100'000;   ///< of blocks, above which factoring takes too long
  double softening = 0; ///< [1], 0: contacts are stiff; 1: soft, as SofteningSettings says
  double residual = 0;  ///< [N s], may be left, however small impulses are
  double squared_swing = most_squared_swing; ///< [1], above which joints swing bodies implicitly
  bool bounds_move = true; ///< whether bounds of friction follow the impulses found, bound_stays()
  bool opening_friction = true; ///< whether there is friction where an overlap opens
};

/// An overlap that opens no faster than this [m/s] is treated as none.
inline constexpr double slow_opening = 1e-3;
// [direct_settings]

// [direct_point]
/// What friction does at a contact point.
enum class FrictionState
{
  none,  ///< nothing: there is no push
  stick, ///< holds the surfaces together
  slip   ///< is as large as it can be
};

/// How stiff the points of a contact are: an impulse for a speed [kg].
struct DirectStiffness
{
  double push;     ///< along the normal
  double friction; ///< across it
};

/// Whether a point is active, and what its friction does: its part of the active set.
struct ContactState
{
  bool active;                  ///< whether the surfaces push
  FrictionState friction_state; ///< what friction does

  bool operator==(const ContactState&) const = default;
};

/// Whether a point pushes at all.
inline bool has_impulse(const ContactState& state)
{
  return state.active || state.friction_state != FrictionState::none;
}

/// A contact point as Newton's method sees it.
struct DirectPoint : ContactState
{
  Arms<double> arms;  ///< [m], world, from the centres of mass
  double coefficient; ///< [1], of friction
  double bias;  ///< [m/s], speed at which the gap may close; below zero, at which an overlap opens
  double bound; ///< [N s], the most that friction can do; infinite: not known yet
  bool bound_is_new;                  ///< whether the frame before has set none
  bool solved;                        ///< whether the frame before knew it
  Vector3<double> stored_friction;    ///< [N s], at no slip
  double impulse;                     ///< [N s], along the normal
  Vector3<double> friction;           ///< [N s], across it
  Vector3<double> unbounded_friction; ///< [N s], friction that would hold the surfaces
};

/// Sets impulse, friction and state of a point at a relative velocity [m/s] of its surfaces, each
/// as the impulse of a stiff spring.
inline void update_point(
    DirectPoint& point, const Vector3<double>& normal, const Vector3<double>& velocity,
    const DirectStiffness& stiffness)
{
  const double speed = velocity.dot(normal);
  const Vector3<double> slip = velocity - speed * normal;
  point.impulse = accumulated_impulse(0.0, -(speed + point.bias) * stiffness.push);
  point.active = point.impulse > 0;
  const bool known = point.bound < std::numeric_limits<double>::infinity();
  const bool has_friction = known ? point.bound > 0 : point.active;
  point.friction_state = has_friction ? FrictionState::stick : FrictionState::none;
  point.unbounded_friction.setZero();
  if (has_friction)
  {
    point.unbounded_friction = point.stored_friction - slip * stiffness.friction;
  }
  point.friction = point.unbounded_friction;
  if (!(point.unbounded_friction.squaredNorm() <= point.bound * point.bound))
  {
    point.friction = within_cone<double, 3>(point.unbounded_friction, point.bound);
    point.friction_state = FrictionState::slip;
  }
}

/// A bound of friction this many times the one that the impulse found now would set, and above it
/// by more than this fraction of the largest impulse, was set too early, by impulses that were
/// still far from an answer.
inline constexpr double early_bound = 2, early_fraction = 0.1;

/// Whether the bound of friction stays where bounds do not move: one of the frame before does. A
/// new one is set once, and again only if it was set too early: `now` [N s] is the bound by the
/// impulse found now, `largest` [N s] the largest impulse.
inline bool bound_stays(const DirectPoint& point, double now, double largest)
{
  const bool early =
      point.bound > early_bound * now && point.bound - now > early_fraction * largest;
  return !point.bound_is_new || (point.bound < std::numeric_limits<double>::infinity() && !early);
}

/// The stiffness [kg] of a point: how its impulse [N s] changes with its velocity [m/s].
inline Matrix3<double> stiffness_at(
    const DirectPoint& point, const Vector3<double>& normal, const DirectStiffness& stiffness)
{
  const Matrix3<double> along = normal * normal.transpose();
  const Matrix3<double> across = Matrix3<double>::Identity() - along;
  Matrix3<double> sum = Matrix3<double>::Zero();
  if (point.active)
  {
    sum += along * stiffness.push;
  }
  if (point.friction_state == FrictionState::stick)
  {
    sum += across * stiffness.friction;
  }
  if (point.friction_state == FrictionState::slip)
  {
    const double size = point.unbounded_friction.norm();
    const Vector3<double> along_slip = point.unbounded_friction / size;
    sum +=
        (across - along_slip * along_slip.transpose()) * (point.bound / size * stiffness.friction);
  }
  return sum;
}
// [direct_point]

} // namespace cookbook
