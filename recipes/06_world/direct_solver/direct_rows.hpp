#pragma once

/// \file
/// \brief The equations of joints in the direct solver: each a stiff spring.

#include "06_world/direct_solver/block_cholesky.hpp"
#include "06_world/direct_solver/direct_points.hpp"

#include <algorithm>
#include <vector>

namespace cookbook
{

// [direct_rows]
/// A row of a constraint beside contacts; its bodies as those of a contact.
struct DirectRow
{
  int a, b;                 ///< the two bodies
  Vector6 on_a, on_b;       ///< J
  double bias;              ///< [m/s], at which it closes its error; and how what is driven moves
  double stiffness;         ///< [kg]
  double impulse;           ///< [N s]
  const ConstraintPair* of; ///< where it comes from
};

/// The number in an island of a body of the world; −1 if it is none of its bodies.
inline int number_in(const Island& island, int body)
{
  const auto found = std::lower_bound(island.bodies.begin(), island.bodies.end(), body);
  const bool there = found != island.bodies.end() && *found == body;
  return there ? static_cast<int>(found - island.bodies.begin()) : -1;
}

/// The velocities of a body as six numbers [m/s, rad/s].
inline Vector6 velocities_of(const Motion<double>& motion)
{
  return (Vector6() << motion.velocity, motion.angular_velocity).finished();
}

/// How much [1/kg] a body gives way to a row.
inline double inverse_mass_of(const RigidBody& body, const Vector6& row)
{
  const Vector3<double> linear = row.head<3>(), angular = row.tail<3>();
  return body.inverse_mass * linear.squaredNorm() + angular.dot(body.inverse_inertia * angular);
}

/// Adds the rows of a constraint.
inline void gather(
    std::vector<DirectRow>& rows, IslandView world, const Island& island,
    const ConstraintPair& pair, double step, const DirectSettings& settings)
{
  const RigidBody& a = world.bodies[index_of(pair.a)];
  const RigidBody& b = world.bodies[index_of(pair.b)];
  const int in_a = number_in(island, pair.a), in_b = number_in(island, pair.b);
  world.sets[pair.set]->rows(
      world.bodies, pair.number, step,
      [&](const ConstraintRow& row)
      {
        const double felt = inverse_mass_of(a, row.a) + inverse_mass_of(b, row.b);
        const double driven = (in_a < 0 ? row.a.dot(velocities_of(a.motion)) : 0) +
                              (in_b < 0 ? row.b.dot(velocities_of(b.motion)) : 0);
        const double bias = settings.row_correction * row.error / step + driven;
        const double stiffness = 1 / (std::max(settings.compliance, row.compliance) * felt);
        rows.push_back({in_a, in_b, row.a, row.b, bias, stiffness, 0, &pair});
      });
}

/// Adds what rows resist to a matrix: Jᵀ k J.
inline void add_rows(const std::vector<DirectRow>& rows, BlockCholesky& matrix)
{
  for (const DirectRow& row : rows)
  {
    if (row.a >= 0)
    {
      matrix.diagonal(row.a) += row.stiffness * row.on_a * row.on_a.transpose();
    }
    if (row.b >= 0)
    {
      matrix.diagonal(row.b) += row.stiffness * row.on_b * row.on_b.transpose();
    }
    if (row.a >= 0 && row.b >= 0)
    {
      matrix.add_coupling(row.a, row.b, row.stiffness * row.on_a * row.on_b.transpose());
    }
  }
}

/// Has a row pull at the velocities as they are, and adds what it gives its bodies.
inline void
update_row(DirectRow& row, const std::vector<Vector6>& velocities, std::vector<Vector6>& residual)
{
  double speed = row.bias;
  speed += row.a >= 0 ? row.on_a.dot(velocities[index_of(row.a)]) : 0;
  speed += row.b >= 0 ? row.on_b.dot(velocities[index_of(row.b)]) : 0;
  row.impulse = -row.stiffness * speed;
  if (row.a >= 0)
  {
    residual[index_of(row.a)] += row.impulse * row.on_a;
  }
  if (row.b >= 0)
  {
    residual[index_of(row.b)] += row.impulse * row.on_b;
  }
}
// [direct_rows]

} // namespace cookbook
