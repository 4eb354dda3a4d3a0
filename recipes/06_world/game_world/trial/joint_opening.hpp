#pragma once

/// \file
/// \brief How far the joints of a world are open, whatever their kinds.

#include "06_world/constraints/constraint_set.hpp"
#include "06_world/game_world/game_world.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace cookbook
{

/// How far joints are from where they hold: along directions, and about axes.
struct JointOpening
{
  double length = 0; ///< [m]
  double angle = 0;  ///< [rad]
};

/// That of the joints of a world, the largest of each: what its rigid rows are off together, or one
/// of its limits is beyond. Springs and motors hold nothing.
inline JointOpening joint_opening(GameWorld& world)
{
  JointOpening most;
  for (std::size_t place = 0; place < world.constraint_sets(); ++place)
  {
    const ConstraintSet& set = world.constraint_set(place);
    const auto look_at = [&](const ConstraintPair& pair)
    {
      double apart = 0, turned = 0; // squared
      const auto look = [&](const ConstraintRow& row)
      {
        const bool is_angle = row.a.head<3>().isZero(0) && row.b.head<3>().isZero(0);
        const double beyond = is_limit(row) && !is_open(row) ? std::abs(row.error) : 0;
        double& largest = is_angle ? most.angle : most.length;
        largest = std::max(largest, beyond);
        (is_angle ? turned : apart) += is_rigid(row) ? row.error * row.error : 0;
      };
      const std::vector<RigidBody>& bodies = world.bodies();
      set.rows(
          bodies[index_of(pair.a)], bodies[index_of(pair.b)], pair.number, world.scene().step,
          look);
      most.length = std::max(most.length, std::sqrt(apart));
      most.angle = std::max(most.angle, std::sqrt(turned));
    };
    set.each_pair(look_at);
  }
  return most;
}

} // namespace cookbook
