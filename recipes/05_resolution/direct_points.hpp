#pragma once

/// \file
/// \brief What pushes at the contact points of an island at given velocities, and how stiffly.

#include "05_resolution/block_cholesky.hpp"
#include "05_resolution/island.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace cookbook
{

// [direct_settings]
/// How the direct solver is run.
struct DirectSettings
{
  double compliance = 1e-7;         ///< [1], of the inverse masses that meet at a contact
  double correction = 0.2;          ///< [1], share of an overlap that a step takes away
  double correction_speed = 1;      ///< [m/s], no overlap is taken away faster
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

// [direct_blocks]
/// What the velocities of two bodies change in the impulses and turns of both, through a contact.
struct DirectBlocks
{
  Matrix6 aa = Matrix6::Zero(); ///< of A in A; only its lower half is right
  Matrix6 ab = Matrix6::Zero(); ///< of B in A
  Matrix6 bb = Matrix6::Zero(); ///< of B in B; only its lower half is right
};

/// The matrix S with S x = r × x.
inline Matrix3<double> cross_matrix(const Vector3<double>& r)
{
  Matrix3<double> s;
  s.col(0) = Vector3<double>(0, r.z(), -r.y());
  s.col(1) = Vector3<double>(-r.z(), 0, r.x());
  s.col(2) = Vector3<double>(r.y(), -r.x(), 0);
  return s;
}

/// Adds a point with a stiffness W [kg]: Jᵀ W J, where J = (1, −S) takes the velocities of a body
/// to that of its point.
inline void
add_point(DirectBlocks& blocks, const DirectPoint& point, const Matrix3<double>& stiffness)
{
  const Matrix3<double> a = cross_matrix(point.arm_a), b = cross_matrix(point.arm_b);
  const Matrix3<double> a_by = a * stiffness, b_by = b * stiffness;
  blocks.aa.topLeftCorner<3, 3>() += stiffness;
  blocks.aa.bottomLeftCorner<3, 3>() += a_by;
  blocks.aa.bottomRightCorner<3, 3>() -= a_by * a;
  blocks.ab.topLeftCorner<3, 3>() -= stiffness;
  blocks.ab.topRightCorner<3, 3>() -= b_by.transpose();
  blocks.ab.bottomLeftCorner<3, 3>() -= a_by;
  blocks.ab.bottomRightCorner<3, 3>() += a_by * b;
  blocks.bb.topLeftCorner<3, 3>() += stiffness;
  blocks.bb.bottomLeftCorner<3, 3>() += b_by;
  blocks.bb.bottomRightCorner<3, 3>() -= b_by * b;
}

/// The sums over points that resist alike in all directions: all of such a contact in a few
/// numbers.
struct EvenPoints
{
  double count = 0;
  Vector3<double> a = Vector3<double>::Zero(), b = Vector3<double>::Zero();
  Matrix3<double> aa = Matrix3<double>::Zero(), ab = aa, bb = aa; ///< sums of r rᵀ

  /// Adds a point by its arms.
  void add(const Vector3<double>& arm_a, const Vector3<double>& arm_b)
  {
    count += 1;
    a += arm_a;
    b += arm_b;
    aa += arm_a * arm_a.transpose();
    ab += arm_b * arm_a.transpose();
    bb += arm_b * arm_b.transpose();
  }

  /// The same as add_point() for each of them, with a stiffness w [kg] times the identity, since
  /// S(r) S(q) = q rᵀ − (r·q) 1.
  DirectBlocks blocks(double w) const
  {
    const auto squares = [&](const Matrix3<double>& sum) -> Matrix3<double>
    { return w * (sum.trace() * Matrix3<double>::Identity() - sum); };
    const Matrix3<double> one = w * count * Matrix3<double>::Identity();
    const Matrix3<double> s_a = w * cross_matrix(a), s_b = w * cross_matrix(b);
    DirectBlocks made;
    made.aa << one, -s_a, s_a, squares(aa);
    made.ab << -one, s_b, -s_a, -squares(ab);
    made.bb << one, -s_b, s_b, squares(bb);
    return made;
  }
};

/// What a contact with these points and a softness [1/kg] adds.
inline DirectBlocks
blocks_of(std::span<const DirectPoint> points, const Vector3<double>& normal, double softness)
{
  EvenPoints even;
  for (const DirectPoint& point : points)
  {
    if (point.pressed && point.grip == Grip::stick)
    {
      even.add(point.arm_a, point.arm_b);
    }
  }
  DirectBlocks blocks = even.blocks(1 / softness);
  for (const DirectPoint& point : points)
  {
    const bool counted = point.pressed && point.grip == Grip::stick;
    if (!counted && (point.pressed || point.grip != Grip::none))
    {
      add_point(blocks, point, stiffness(point, normal, softness));
    }
  }
  return blocks;
}
// [direct_blocks]

} // namespace cookbook
