#pragma once

/// \file
/// \brief One equation between two bodies for AVBD: a spring that grows stiffer, and a push beside
/// it.

#include "06_world/constraints/constraint_row.hpp"
#include "06_world/islands/position_impulse.hpp"
#include "07_constraints/avbd/avbd_settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cookbook
{

// [avbd_row]
/// A row: its energy is k C²/2 − λ C, so it pushes along J by λ − k C, within its bounds.
struct AvbdRow
{
  Vector6 a, b;                                            ///< J
  double error = 0;                                        ///< [m, rad], C
  double lower = -std::numeric_limits<double>::infinity(); ///< [N], bounds of the push
  double upper = std::numeric_limits<double>::infinity();
  bool is_spring = false; ///< whether its stiffness is its own, and λ stays
  AvbdMemory memory;
  Vector6 curve_a = Vector6::Zero(), curve_b = Vector6::Zero(); ///< [m], by which J turns with each

  /// The push [N] where the bodies are, without bounds.
  double unbounded() const { return memory.push - memory.stiffness * error; }
  double push() const { return std::clamp(unbounded(), lower, upper); } ///< [N], within them
  /// Whether the push is the spring's, and not a bound.
  bool is_inside() const { return unbounded() > lower && unbounded() < upper; }
};

/// After a pass: the push takes over what the spring bears, which grows where that is not enough.
inline void update(AvbdRow& row, const AvbdSettings& settings)
{
  if (row.is_spring)
  {
    return;
  }
  const bool inside = row.is_inside();
  row.memory.push = row.push();
  if (inside)
  {
    row.memory.stiffness =
        std::min(settings.most, row.memory.stiffness + settings.growth * std::abs(row.error));
  }
}
// [avbd_row]

// [avbd_body]
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// The system of one body: how stiffly inertia and rows hold it, and what force is left.
struct AvbdBlock
{
  Matrix6d stiffness; ///< [N/m, N, N m]
  Vector6 force;      ///< [N, N m]
};

/// That of a body on its own: inertia draws it to where it would be by itself after a step [s].
inline AvbdBlock block_of(const RigidBody& body, const RigidBody& alone, double step)
{
  const Matrix3<double> inertia = world_inertia(body.moments, body.axes);
  AvbdBlock block{Matrix6d::Zero(), Vector6::Zero()};
  block.stiffness.topLeftCorner<3, 3>().diagonal().setConstant(1 / body.inverse_mass);
  block.stiffness.bottomRightCorner<3, 3>() = inertia;
  block.stiffness /= step * step;
  Vector6 away;
  away << body.motion.center - alone.motion.center,
      turn_between<double>(alone.orientation, body.orientation);
  block.force = -block.stiffness * away;
  return block;
}

/// Adds a row to the system of one of its bodies.
inline void add_row(AvbdBlock& block, const AvbdRow& row, const Vector6& j, const Vector6& curve)
{
  const double push = row.push();
  block.force += push * j;
  if (row.is_inside())
  {
    block.stiffness += row.memory.stiffness * j * j.transpose();
  }
  block.stiffness.diagonal() += std::abs(push) * curve;
}

/// Moves a body to where its system is at rest.
inline void move_to_rest(RigidBody& body, const AvbdBlock& block)
{
  const Vector6 change = block.stiffness.ldlt().solve(block.force);
  body.motion.center += change.head<3>();
  rotate(body, change.tail<3>());
}
// [avbd_body]

} // namespace cookbook
