#pragma once

/// \file
/// \brief All contacts of an island at once: Newton's method with an exact factorisation.

#include "06_world/direct_solver/direct_advance.hpp"
#include "06_world/direct_solver/direct_residual.hpp"
#include "06_world/direct_solver/factored_points.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace cookbook
{

// [direct_bounds]
/// Takes all new points for pressed whose gaps a speed [m/s] could close in a step: so a tower
/// stands from the first iteration on, not box upon box. Whether there are any: then the
/// first change, which takes what is missing without them, leads past the answer.
inline bool guess(DirectSystem& system, double speed)
{
  bool any = false;
  for (DirectPoint& point : system.points)
  {
    if (!point.solved && !point.pressed && point.bias <= speed)
    {
      point.pressed = true;
      point.grip = Grip::stick;
      any = true;
    }
  }
  return any;
}

/// Has friction follow the impulses along the normals, of which this is the largest [N s], and so
/// much may be missing [N s]; false where no friction was off by more than the settings allow.
inline bool
moved_bounds(DirectSystem& system, double largest, double missing, const DirectSettings& settings)
{
  bool off = false;
  for (const DirectContact& contact : system.contacts)
  {
    const double tolerance = friction_slack(contact, largest, missing, settings);
    bool any = false;
    for (std::size_t i = contact.first; i < contact.end; ++i)
    {
      DirectPoint& point = system.points[i];
      const double bound = point.coefficient * point.impulse;
      if (!settings.bounds_move && stays(point, bound, largest))
      {
        continue;
      }
      const double above = point.friction.norm() - bound;
      const auto off_by_more_than = [&](double most)
      { return above > most || (point.grip != Grip::stick && -above > most); };
      any = any || off_by_more_than(0) || (point.grip != Grip::none) != (bound > 0);
      off = off || off_by_more_than(tolerance);
      point.bound = bound;
    }
    if (any)
    {
      add_impulses(system, contact, -1);
      press(system, contact);
      add_impulses(system, contact, 1);
    }
  }
  return off;
}

/// Writes what was found into the world. Impulses that were missing are given, so that bodies have
/// just what contacts gave them, and momentum is kept to rounding.
inline void scatter(
    const DirectSystem& system, const std::vector<Vector6>& missing, bool strained,
    IslandView world, const Island& island)
{
  for (std::size_t i = 0; i < island.bodies.size(); ++i)
  {
    RigidBody& body = world.bodies[place_of(island.bodies[i])];
    const Vector3<double> push = missing[i].head<3>(), turn = missing[i].tail<3>();
    body.motion.velocity = system.velocities[i].head<3>() + body.inverse_mass * push;
    body.motion.angular_velocity = system.velocities[i].tail<3>() + body.inverse_inertia * turn;
  }
  std::size_t point = 0;
  for (const int i : island.contacts)
  {
    for (WorldPoint& of : world.contacts[place_of(i)].points)
    {
      of.impulse = of.carried = system.points[point].impulse;
      of.friction = system.points[point].friction;
      of.solved = true;
      of.strained = strained;
      ++point;
    }
  }
}
// [direct_bounds]

// [direct_solver]
/// Finds the velocities of islands after a step. It remembers how the last island was laid out, and
/// is quicker if the next one hangs together in the same way. So it is if the same points push as
/// in the step before, where they did: then the matrix need not be factored again. What is found
/// with it counts only if nothing is missing.
class DirectSolver
{
public:
  /// Sets the velocities of the bodies of an island, and the impulses of its contacts, to those
  /// after a step [s]. False if they were not found; then nothing has changed.
  bool
  solve(IslandView world, const Island& island, double step, const DirectSettings& settings = {})
  {
    gather(system_, world, island, step, settings);
    if (!lay_out(settings.products))
    {
      return false;
    }
    find_missing(system_);
    const bool guessed = guess(system_, 2 * step * world.gravity.norm());
    const bool stiff = settings.give == 0;
    bool fresh = false; // whether the matrix was factored in this step
    for (int i = 0; i < settings.iterations; ++i)
    {
      const bool at_hand = (i > 0 ? fresh : stiff) && factored_.are_those_of(system_.points);
      if (!at_hand && !factor())
      {
        return false;
      }
      fresh = fresh || !at_hand;
      change_ = system_.missing;
      matrix_.solve(change_);
      const Advance gone = advance(system_, change_);
      const double most = largest_impulse(system_);
      small_ = std::max({settings.tolerance * most, rounding_of(system_), settings.missing});
      const bool exact = gone.exact && fresh && (i > 0 || !guessed);
      const bool found = exact || size_of_missing(system_) <= small_;
      missing_ = system_.missing; // before the bounds move
      const bool follows = found || gone.stuck || (stiff && gone.part >= 0.5);
      const bool moved = follows && moved_bounds(system_, most, small_, settings);
      if (found && !moved)
      {
        scatter(system_, missing_, is_strained(system_, most), world, island);
        return true;
      }
    }
    return false;
  }

  /// Whether any overlap was to open, with an answer or without.
  bool opens() const { return any_opens(system_); }
  /// How much [N s] might be missing in the last answer.
  double small() const { return small_; }
  /// How fast [m/s] any overlap opens by that answer.
  double opening() const { return fastest_opening(system_); }

private:
  /// Factors the matrix of the system; false if it has none.
  bool factor()
  {
    assemble(system_, matrix_);
    factored_.clear();
    const bool found = matrix_.factor();
    if (found)
    {
      factored_.take(system_.points);
    }
    return found;
  }

  /// Lays the matrix out, if it is not; false if it takes too many products of blocks.
  bool lay_out(std::size_t products)
  {
    coupled_.clear();
    for (const DirectContact& contact : system_.contacts)
    {
      if (contact.a >= 0 && contact.b >= 0)
      {
        coupled_.emplace_back(contact.a, contact.b);
      }
    }
    if (coupled_ != laid_out_ || matrix_.size() != system_.bodies.size())
    {
      matrix_.lay_out(static_cast<int>(system_.bodies.size()), coupled_, products);
      laid_out_ = coupled_;
      factored_.clear();
    }
    return matrix_.products() <= products;
  }

  DirectSystem system_;
  BlockCholesky matrix_;
  FactoredPoints factored_;
  std::vector<Vector6> change_, missing_;
  std::vector<std::pair<int, int>> coupled_, laid_out_;
  double small_ = 0;
};
// [direct_solver]

} // namespace cookbook
