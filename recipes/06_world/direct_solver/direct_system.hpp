#pragma once

/// \file
/// \brief An island as a system of equations: its bodies, contacts and points, and its matrix.

#include "05_resolution/mass_properties/mass_properties.hpp"
#include "06_world/direct_solver/direct_blocks.hpp"
#include "06_world/direct_solver/direct_rows.hpp"
#include "06_world/direct_solver/direct_softening.hpp"
#include "06_world/lanes/reserve_space.hpp"
#include "06_world/soft_steps/stick_drift.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace cookbook
{

// [direct_system]
/// A body of an island.
struct DirectBody
{
  double mass;             ///< [kg]
  Matrix3<double> inertia; ///< [kg m²], world
  Vector6 free;            ///< [m/s, rad/s], after the step if nothing touched it
  Vector6 pulled;          ///< [m/s, rad/s], the part of it by external accelerations
};

/// A contact of an island; its bodies by their numbers in it, −1 for one that no impulse moves.
struct DirectContact
{
  int a, b;                  ///< the two bodies
  const WorldContact* of;    ///< where it comes from
  std::size_t first, end;    ///< its points
  DirectStiffness stiffness; ///< of each
  double mass;               ///< [kg], reduced mass of the two: 1 / (1/m_A + 1/m_B)
  Motion<double> driven;     ///< of the body that is not of the island, if there is one
};

/// All of an island.
struct DirectSystem
{
  std::vector<DirectBody> bodies;
  std::vector<DirectContact> contacts;
  std::vector<DirectPoint> points;
  std::vector<DirectRow> rows;
  std::vector<Matrix3<double>>
      taut; ///< [kg m²], what taut joints add to inertia, stiffen(); or none
  std::vector<Vector6> velocities; ///< [m/s, rad/s], as they are found
  std::vector<Vector6> residual;   ///< [N s, N m s], at these velocities

  std::vector<ContactState> states_before; ///< scratch: states of points before a change
  std::vector<int> rows_before;            ///< scratch: at which bounds rows were before it
  std::vector<Vector6> velocities_before;  ///< scratch: the velocities before it
};

/// Adds a contact and its points to a system.
inline void gather(
    DirectSystem& system, IslandView world, const Island& island, const WorldContact& contact,
    double step, const DirectSettings& settings)
{
  const RigidBody& a = world.bodies[index_of(contact.a)];
  const RigidBody& b = world.bodies[index_of(contact.b)];
  const std::size_t first = system.points.size();
  const double inverse_mass = a.inverse_mass + b.inverse_mass;
  const DirectStiffness stiffness = stiffness_of(contact, inverse_mass, settings);
  for (const WorldPoint& point : contact.points)
  {
    const double separation = separation_of(a, b, contact.normal, point) / step;
    const double opening = std::min(-settings.correction * separation, settings.correction_speed);
    DirectPoint& made = system.points.emplace_back();
    made.arms = arms_of(a, b, point);
    made.bias = separation > 0 ? separation : -opening;
    made.solved = point.solved;
    made.stored_friction =
        kept_friction(contact, point, opening * stiffness.push, settings.softening);
    made.stored_friction +=
        stiffness.friction * step / 2 * stick_drift(a, b, contact.normal, made.arms, step);
    made.coefficient = settings.opening_friction || opening <= slow_opening ? contact.friction : 0;
    made.bound_is_new = point.impulse == 0 && made.coefficient > 0;
    made.bound = made.bound_is_new ? std::numeric_limits<double>::infinity()
                                   : made.coefficient * point.impulse;
  }
  system.contacts.push_back(
      {number_in(island, contact.a), number_in(island, contact.b), &contact, first,
       system.points.size(), stiffness, 1 / inverse_mass, is_fixed(a) ? a.motion : b.motion});
}

/// Empties a system, with room for all of an island.
inline void clear(DirectSystem& system, IslandView world, const Island& island)
{
  std::size_t points = 0;
  for (const int i : island.contacts)
  {
    points += world.contacts[index_of(i)].points.size();
  }
  const auto empty = [](auto& list, std::size_t count)
  {
    list.clear();
    reserve_space(list, count);
  };
  empty(system.bodies, island.bodies.size());
  empty(system.velocities, island.bodies.size());
  empty(system.contacts, island.contacts.size());
  empty(system.points, points);
  system.rows.clear();
  system.taut.clear();
}

/// Makes a system of an island, at the velocities before the step [s].
inline void gather(
    DirectSystem& system, IslandView world, const Island& island, double step,
    const DirectSettings& settings)
{
  clear(system, world, island);
  for (const int i : island.bodies)
  {
    const RigidBody& body = world.bodies[index_of(i)];
    const Vector6 before = velocities_of(body.motion);
    const Vector6 free = velocities_of(accelerated(body.motion, acceleration_on(world, i), step));
    system.velocities.push_back(before);
    system.bodies.push_back(
        {1 / body.inverse_mass, world_inertia(body.moments, body.axes), free, free - before});
  }
  for (const int i : island.contacts)
  {
    gather(system, world, island, world.contacts[index_of(i)], step, settings);
  }
  for (const int i : island.constraints)
  {
    gather(system.rows, world, island, world.constraints[index_of(i)], step, settings);
  }
}

/// How a body of a contact moves, by its number in the island; another, −1, as it is driven.
inline Motion<double> motion_of(const DirectSystem& system, const DirectContact& contact, int body)
{
  if (body < 0)
  {
    return contact.driven;
  }
  const Vector6& velocity = system.velocities[index_of(body)];
  return {Vector3<double>::Zero(), velocity.head<3>(), velocity.tail<3>()};
}
// [direct_system]

// [direct_assemble]
/// Assembles the matrix, which takes a change of velocities to impulses: masses, and the stiffness
/// of all contacts and rows.
inline void assemble(const DirectSystem& system, BlockCholesky& matrix)
{
  matrix.clear();
  for (std::size_t i = 0; i < system.bodies.size(); ++i)
  {
    Matrix6& block = matrix.diagonal(static_cast<int>(i));
    block.topLeftCorner<3, 3>().diagonal().setConstant(system.bodies[i].mass);
    block.bottomRightCorner<3, 3>() = system.bodies[i].inertia;
  }
  for (const DirectContact& contact : system.contacts)
  {
    const std::span<const DirectPoint> points(system.points);
    const DirectBlocks blocks = blocks_of(
        points.subspan(contact.first, contact.end - contact.first), contact.of->normal,
        contact.stiffness);
    if (contact.a >= 0)
    {
      matrix.diagonal(contact.a) += blocks.aa;
    }
    if (contact.b >= 0)
    {
      matrix.diagonal(contact.b) += blocks.bb;
    }
    if (contact.a >= 0 && contact.b >= 0)
    {
      matrix.add_coupling(contact.a, contact.b, blocks.ab);
    }
  }
  for (std::size_t i = 0; i < system.taut.size(); ++i)
  {
    matrix.diagonal(static_cast<int>(i)).bottomRightCorner<3, 3>() += system.taut[i];
  }
  add_rows(system.rows, matrix);
}
// [direct_assemble]

} // namespace cookbook
