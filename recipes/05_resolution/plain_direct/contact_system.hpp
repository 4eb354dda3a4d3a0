#pragma once

/// \file
/// \brief The contact points of the small world as one system of linear equations.

#include "05_resolution/plain_direct/active_set.hpp"
#include "05_resolution/small_world/step_4.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cookbook::small_world::plain_direct
{

using Contact = step_4::Contact;

/// The bodies and the contact points of step 4; only what a step does is another.
struct World : step_4::World
{
};

/// Overlap [m] that is left, so that surfaces at rest are found to touch in the next step, too.
inline constexpr double slop = 1e-4;

// [jacobian]
/// Writes what a row takes from the velocities of one body.
inline void set_row(
    MatrixXd& jacobian, Index row, std::size_t body, const Vector3<double>& direction,
    const Vector3<double>& arm)
{
  const Index column = 6 * static_cast<Index>(body);
  jacobian.block<1, 3>(row, column) = direction.transpose();
  jacobian.block<1, 3>(row, column + 3) = arm.cross(direction).transpose();
}

/// The Jacobian J, rows by 6 bodies: it takes the velocities of all bodies to the speeds [m/s] of
/// all rows, three for each contact point, along n, u and w.
inline MatrixXd compute_jacobian(const World& world)
{
  const Index rows = 3 * static_cast<Index>(world.contacts.size());
  MatrixXd jacobian = MatrixXd::Zero(rows, 6 * static_cast<Index>(world.bodies.size()));
  Index row = 0;
  for (const Contact& contact : world.contacts)
  {
    for (const Vector3<double>& direction : {contact.normal, contact.surface.u, contact.surface.w})
    {
      set_row(jacobian, row, contact.a, -direction, contact.arms.a);
      set_row(jacobian, row, contact.b, direction, contact.arms.b);
      ++row;
    }
  }
  return jacobian;
}

/// M⁻¹ Jᵀ, 6 bodies by rows: what impulses change the velocities of all bodies by.
inline MatrixXd compute_response(const World& world, const MatrixXd& jacobian)
{
  MatrixXd response = jacobian.transpose();
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    const RigidBody& body = world.bodies[i];
    auto rows = response.middleRows<6>(6 * static_cast<Index>(i));
    rows.topRows<3>() *= body.inverse_mass;
    rows.bottomRows<3>() = (body.inverse_inertia * rows.bottomRows<3>()).eval();
  }
  return response;
}
// [jacobian]

// [axes]
/// Turns the axes of the surface so that u lies along the friction that the step before and the
/// sliding ask for. The speed [m/s] of the sliding that the cone leaves.
inline double align_axes(const World& world, Contact& contact)
{
  const Vector2<double> sliding = sliding_velocity<double>(
      world.bodies[contact.a], world.bodies[contact.b], contact.surface, contact.arms);
  const Vector3<double> asked =
      contact.surface.in_world(contact.friction - contact.sliding.smallest * sliding);
  const double length = asked.norm();
  if (length > 0)
  {
    contact.surface = {asked / length, contact.normal.cross(asked / length)};
  }
  return std::max(0.0, length - contact.coefficient * contact.impulse) / contact.sliding.smallest;
}
// [axes]

// [system]
/// The system of a step: A x + b are the speeds that the impulses x leave.
struct System
{
  std::vector<double> sliding; ///< [m/s], speed of each contact point along the surface
  MatrixXd jacobian;           ///< J
  MatrixXd response;           ///< M⁻¹ Jᵀ
  MatrixXd matrix;             ///< A = J M⁻¹ Jᵀ with compliance [1/kg]
  VectorXd velocities;         ///< of all bodies before the impulses, six for each
};

/// The velocities of all bodies, six numbers for each.
inline VectorXd velocities_of(const World& world)
{
  VectorXd velocities(6 * static_cast<Index>(world.bodies.size()));
  Index row = 0;
  for (const RigidBody& body : world.bodies)
  {
    velocities.segment<6>(row) << body.motion.velocity, body.motion.angular_velocity;
    row += 6;
  }
  return velocities;
}

/// The system of a step [s], with a compliance of a millionth of each row's own inverse mass.
inline System compute_system(World& world, double time)
{
  System system{};
  for (Contact& contact : world.contacts)
  {
    system.sliding.push_back(align_axes(world, contact));
  }
  step_4::apply_gravity(world, time);
  system.velocities = velocities_of(world);
  system.jacobian = compute_jacobian(world);
  system.response = compute_response(world, system.jacobian);
  system.matrix = system.jacobian * system.response;
  system.matrix.diagonal() *= 1 + 1e-6;
  return system;
}

/// A for the normal impulses so far: where a point slides at a speed c, Coulomb's friction is a
/// damper across it of a compliance c / (μ λ).
inline MatrixXd compute_matrix(const World& world, const System& system)
{
  MatrixXd matrix = system.matrix;
  for (std::size_t i = 0; i < world.contacts.size(); ++i)
  {
    const double max_friction = world.contacts[i].coefficient * world.contacts[i].impulse;
    const Index across = 3 * static_cast<Index>(i) + 2;
    matrix(across, across) += max_friction > 0 ? system.sliding[i] / max_friction : 0;
  }
  return matrix;
}

/// b: the speeds before the impulses, less those that the normals are to have. A gap may close
/// within the step [s]; an overlap opens by a fifth of it, and no faster than a speed [m/s].
inline VectorXd
compute_speeds(const World& world, const System& system, double time, double max_speed)
{
  VectorXd speeds = system.jacobian * system.velocities;
  for (std::size_t i = 0; i < world.contacts.size(); ++i)
  {
    const double gap = world.contacts[i].separation + slop;
    const double wanted = gap > 0 ? -gap / time : std::min(-0.2 * gap / time, max_speed);
    speeds[3 * static_cast<Index>(i)] -= wanted;
  }
  return speeds;
}

/// No normal impulse pulls; none of friction is beyond μ times the normal impulse so far; R6.
inline Bounds compute_bounds(const World& world)
{
  const Index rows = 3 * static_cast<Index>(world.contacts.size());
  Bounds bounds{VectorXd::Zero(rows), VectorXd::Zero(rows)};
  Index row = 0;
  for (const Contact& contact : world.contacts)
  {
    bounds.high[row] = std::numeric_limits<double>::infinity();
    bounds.high.segment<2>(row + 1).setConstant(contact.coefficient * contact.impulse);
    row += 3;
  }
  bounds.low = bounds.high.unaryExpr([](double high) { return std::isinf(high) ? 0 : -high; });
  return bounds;
}
// [system]

} // namespace cookbook::small_world::plain_direct
