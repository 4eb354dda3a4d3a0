#pragma once

/// \file
/// \brief What the rows of joints do not predict: anchors go round, and leave their tangents.

#include "06_world/contacts/integrate_body.hpp"
#include "06_world/direct_solver/direct_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace cookbook
{

// [direct_bends]
/// How a body is once it has moved with these velocities for a step [s].
inline RigidBody moved_by(RigidBody body, const Vector6& velocities, double step)
{
  body.motion.velocity = velocities.head<3>();
  body.motion.angular_velocity = velocities.tail<3>();
  integrate_position(body, step);
  return body;
}

/// Asks all rows how far they will be off where an answer leads in a step [s] by what J did not
/// predict: an anchor that goes round leaves its tangent. Returns the largest [m, rad] that their
/// offsets do not take yet.
inline double find_bends(
    std::vector<DirectRow>& rows, IslandView world, const std::vector<Vector6>& velocities,
    double step)
{
  double largest = 0;
  for (std::size_t first = 0; first < rows.size();)
  {
    const ConstraintPair& pair = *rows[first].of;
    const auto velocities_in = [&](int in_island, int body)
    {
      return in_island < 0 ? velocities_of(world.bodies[index_of(body)].motion)
                           : velocities[index_of(in_island)];
    };
    const Vector6 of_a = velocities_in(rows[first].a, pair.a);
    const Vector6 of_b = velocities_in(rows[first].b, pair.b);
    std::size_t i = first;
    world.sets[pair.set]->rows(
        moved_by(world.bodies[index_of(pair.a)], of_a, step),
        moved_by(world.bodies[index_of(pair.b)], of_b, step), pair.number, step,
        [&](const ConstraintRow& after)
        {
          DirectRow& row = rows[i++];
          const double predicted = row.error + step * (row.on_a.dot(of_a) + row.on_b.dot(of_b));
          row.bend = row.bends ? after.error - predicted - row.bent : 0;
          largest = std::max(largest, std::abs(row.bend));
        });
    first = i;
  }
  return largest;
}

/// Has the offsets of all rows take that, in a step [s].
inline void take_bends(std::vector<DirectRow>& rows, double step)
{
  for (DirectRow& row : rows)
  {
    row.bent += row.bend;
    row.offset += row.stiffness / step * row.bend;
  }
}
// [direct_bends]

} // namespace cookbook
