#pragma once

/// \file
/// \brief What the direct solver has found: velocities of bodies, and impulses of contacts.

#include "06_world/direct_solver/direct_system.hpp"
#include "06_world/islands/run_substeps.hpp"
#include "06_world/lanes/reserve_space.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cookbook
{

// [direct_answer]
/// The velocities of a body after a step, by an answer.
struct DirectVelocity
{
  Vector3<double> velocity;         ///< [m/s], world
  Vector3<double> angular_velocity; ///< [rad/s], world
  bool pushed;                      ///< whether any contact pushes it
};

/// Marks two bodies of an island as pushed; none where one is -1.
inline void mark_pushed(int a, int b, std::vector<DirectVelocity>& answer)
{
  for (const int body : {a, b})
  {
    if (body >= 0)
    {
      answer[index_of(body)].pushed = true;
    }
  }
}

/// Marks the two bodies of a contact that pushes at any point.
inline void mark_pushed(
    const DirectSystem& system, const DirectContact& contact, std::vector<DirectVelocity>& answer)
{
  const auto begin = system.points.begin() + static_cast<std::ptrdiff_t>(contact.first);
  const auto end = system.points.begin() + static_cast<std::ptrdiff_t>(contact.end);
  const auto pushes = [](const DirectPoint& point)
  { return point.impulse > 0 || !point.friction.isZero(0); };
  if (std::any_of(begin, end, pushes))
  {
    mark_pushed(contact.a, contact.b, answer);
  }
}

/// Writes down the velocities of an answer. What is left of the residual is applied to the bodies,
/// which keeps momentum to rounding.
inline void write_answer(
    const DirectSystem& system, const std::vector<Vector6>& residual, IslandView world,
    const Island& island, std::vector<DirectVelocity>& answer)
{
  answer.clear();
  reserve_space(answer, island.bodies.size());
  for (std::size_t i = 0; i < island.bodies.size(); ++i)
  {
    const RigidBody& body = world.bodies[index_of(island.bodies[i])];
    const Vector3<double> push = residual[i].head<3>(), turn = residual[i].tail<3>();
    answer.push_back(
        {system.velocities[i].head<3>() + body.inverse_mass * push,
         system.velocities[i].tail<3>() + body.inverse_inertia * turn, false});
  }
  for (const DirectContact& contact : system.contacts)
  {
    mark_pushed(system, contact, answer);
  }
  for (const DirectRow& row : system.rows)
  {
    mark_pushed(row.a, row.b, answer);
  }
}

/// Stores the impulses of an answer.
inline void
store(const DirectSystem& system, bool over_constrained, IslandView world, const Island& island)
{
  std::size_t point = 0;
  for (const int i : island.contacts)
  {
    for (WorldPoint& of : world.contacts[index_of(i)].points)
    {
      of.impulse = of.warm_start_impulse = system.points[point].impulse;
      of.friction = system.points[point].friction;
      of.solved = true;
      of.over_constrained = over_constrained;
      ++point;
    }
  }
  std::vector<double> impulses;
  for (auto row = system.rows.begin(); row != system.rows.end();)
  {
    const ConstraintPair& pair = *row->of;
    for (impulses.clear(); row != system.rows.end() && row->of == &pair; ++row)
    {
      impulses.push_back(row->impulse);
    }
    world.sets[pair.set]->store_rows(pair.number, impulses);
  }
}
// [direct_answer]

// [open_overlaps]
/// One step of an island by an answer, for run_substeps(). The bodies move on by the velocities
/// `first`, and keep those of `last`: the same, or those of a second answer without the speed that
/// opens overlaps, so that no body is shot out of one.
class DirectStep
{
public:
  static constexpr double rounding = DirectSettings{}.tolerance; ///< [1]

  DirectStep(
      IslandView world, const Island& island, const std::vector<DirectVelocity>& first,
      const std::vector<DirectVelocity>& last)
      : world_(world), island_(island), first_(first), last_(last)
  {
  }

  int prepare(double) { return 1; }

  /// What no contact pushes keeps the velocities that its external acceleration gave it.
  void solve(double)
  {
    for (std::size_t i = 0; i < first_.size(); ++i)
    {
      if (RigidBody& now = body(i); first_[i].pushed)
      {
        now.motion.velocity = first_[i].velocity;
        now.motion.angular_velocity = first_[i].angular_velocity;
      }
    }
    turns_.clear();
    for (std::size_t i = 0; &first_ != &last_ && i < first_.size(); ++i)
    {
      turns_.push_back(
          world_inertia(body(i).moments, body(i).axes) *
          (last_[i].angular_velocity - first_[i].angular_velocity));
    }
  }

  void relax(double)
  {
    for (std::size_t i = 0; i < turns_.size(); ++i)
    {
      if (first_[i].pushed)
      {
        Motion<double>& motion = body(i).motion;
        motion.velocity += last_[i].velocity - first_[i].velocity;
        motion.angular_velocity += body(i).inverse_inertia * turns_[i];
      }
    }
  }

  void store() {}

private:
  RigidBody& body(std::size_t i) { return world_.bodies[index_of(island_.bodies[i])]; }

  IslandView world_;
  const Island& island_;
  const std::vector<DirectVelocity>&first_, &last_;
  std::vector<Vector3<double>> turns_; // [N m s], what the last velocities add
};
// [open_overlaps]

} // namespace cookbook
