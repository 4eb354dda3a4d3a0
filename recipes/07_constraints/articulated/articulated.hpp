#pragma once

/// \file
/// \brief Steps of a tree of links through time: semi-implicit Euler, and the truth by RK4.

#include "07_constraints/articulated/link_bodies.hpp"

#include <stdexcept>

namespace cookbook
{

// [semi_implicit_step]
/// Moves a tree's positions by its velocities for a time [s]; balls turn by the exponential, M9.
inline void move_positions(const std::vector<Link>& links, TreeState& state, double step)
{
  double* position = state.positions.data();
  const double* velocity = state.velocities.data();
  for (const Link& link : links)
  {
    const auto [positions, velocities] = sizes_of(link.joint);
    if (positions >= 4)
    {
      const JointDisplacement now = joint_displacement(link, position);
      const Vector3<double> turn(step * velocity[0], step * velocity[1], step * velocity[2]);
      const Quaternion<double> turned = unit_quaternion(product(rotation_by(turn), now.turn));
      position[0] = turned.w();
      Vector3<double>::Map(position + 1) = turned.vec();
    }
    const int turns = positions >= 4 ? 4 : 0, rates = positions >= 4 ? 3 : 0;
    for (int k = 0; k < positions - turns; ++k)
    {
      position[turns + k] += step * velocity[rates + k];
    }
    position += positions;
    velocity += velocities;
  }
}

/// The state itself, or std::overflow_error where a number of it is no longer finite.
inline const TreeState& checked_finite(const TreeState& state)
{
  if (!state.positions.allFinite() || !state.velocities.allFinite())
  {
    throw std::overflow_error("a tree of links moves too fast for its numbers");
  }
  return state;
}

/// A game's step [s], semi-implicit Euler: velocities first, then positions by the new ones.
///
/// If it throws, InvalidShape for bad input or std::overflow_error, the state is as it was.
inline void semi_implicit_step(ArticulatedBody& tree, TreeState& state, double step)
{
  check_finite("step", step);
  TreeState& next = tree.memory.next;
  next.velocities = state.velocities + step * tree.accelerations(state);
  next.positions = state.positions;
  move_positions(tree.links(), next, step);
  state = checked_finite(next);
}
// [semi_implicit_step]

// [rk4_step]
/// How fast all positions change: a quaternion by half the product with its angular velocity.
inline void
position_rates(const std::vector<Link>& links, const TreeState& state, Eigen::VectorXd& rates)
{
  const double *position = state.positions.data(), *velocity = state.velocities.data();
  double* rate = rates.data();
  for (const Link& link : links)
  {
    const auto [positions, velocities] = sizes_of(link.joint);
    const int turns = positions >= 4 ? 4 : 0, spins = positions >= 4 ? 3 : 0;
    if (turns == 4)
    {
      const Quaternion<double> half(0, velocity[0] / 2, velocity[1] / 2, velocity[2] / 2);
      const Quaternion<double> turn(position[0], position[1], position[2], position[3]);
      const Quaternion<double> changes = product(half, turn);
      rate[0] = changes.w();
      Vector3<double>::Map(rate + 1) = changes.vec();
    }
    for (int k = turns; k < positions; ++k)
    {
      rate[k] = velocity[spins + k - turns];
    }
    position += positions;
    velocity += velocities;
    rate += positions;
  }
}

/// A step [s] of the classical Runge–Kutta method, R22: four evaluations, of fourth order.
///
/// If it throws, InvalidShape for bad input or std::overflow_error, the state is as it was.
inline void rk4_step(ArticulatedBody& tree, TreeState& state, double step)
{
  check_finite("step", step);
  TreeState &sum = tree.memory.next, &at = tree.memory.at;
  sum = at = checked(state, tree.links());
  for (const auto& [weight, ahead] : {std::pair(6, 2), {3, 2}, {3, 1}, {6, 0}})
  {
    Eigen::VectorXd& rates = tree.memory.rates;
    position_rates(tree.links(), at, rates);
    const Eigen::VectorXd& accelerations = tree.accelerations(at);
    sum.positions += step / weight * rates;
    sum.velocities += step / weight * accelerations;
    if (ahead > 0)
    {
      at.positions = state.positions + step / ahead * rates;
      at.velocities = state.velocities + step / ahead * accelerations;
      checked_finite(at);
    }
  }
  move_positions(tree.links(), sum, 0); // makes quaternions units
  state = checked_finite(sum);
}
// [rk4_step]

} // namespace cookbook
