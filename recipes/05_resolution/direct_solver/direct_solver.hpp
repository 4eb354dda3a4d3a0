#pragma once

/// \file
/// \brief All contacts of an island at once: Newton's method with an exact factorisation.

#include "05_resolution/direct_solver/direct_residual.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace cookbook
{

/// Takes all new points for pressed that gravity, in one step, could bring to a speed [m/s]: so a
/// tower stands from the first iteration on, not box upon box.
inline void guess(DirectSystem& system, double speed)
{
  for (DirectPoint& point : system.points)
  {
    if (!point.solved && !point.pressed && point.bias <= speed)
    {
      point.pressed = true;
      point.grip = Grip::stick;
    }
  }
}

/// How fast the energy falls along a change of velocities.
inline double missing_along(const DirectSystem& system, const std::vector<Vector6>& change)
{
  double sum = 0;
  for (std::size_t i = 0; i < change.size(); ++i)
  {
    sum += system.missing[i].dot(change[i]);
  }
  return sum;
}

/// True if all points push in the way that they did before, and none slips.
inline bool
push_as_before(const std::vector<DirectPoint>& now, const std::vector<DirectPoint>& before)
{
  return std::equal(
      now.begin(), now.end(), before.begin(),
      [](const DirectPoint& one, const DirectPoint& then)
      { return one.pressed == then.pressed && one.grip == then.grip && one.grip != Grip::slip; });
}

// [direct_advance]
/// Goes along a change of velocities to where the energy stops falling; true if that is all of the
/// way and no point pushes in another way than before, so that the answer is exact.
inline bool advance(DirectSystem& system, const std::vector<Vector6>& change)
{
  system.points_before = system.points;
  system.velocities_before = system.velocities;
  const double steep = missing_along(system, change);
  double low = 0, high = 1, at_low = steep, at_high = 0, part = 1;
  for (int tries = 0; tries < 20; ++tries)
  {
    for (std::size_t i = 0; i < change.size(); ++i)
    {
      system.velocities[i] = system.velocities_before[i] + part * change[i];
    }
    find_missing(system);
    if (part == 1 && push_as_before(system.points, system.points_before))
    {
      return true;
    }
    const double now = missing_along(system, change);
    if (std::abs(now) <= 0.2 * std::abs(steep) || (part == 1 && now > 0))
    {
      break;
    }
    (now > 0 ? low : high) = part;
    (now > 0 ? at_low : at_high) = now;
    const double secant = at_low / (at_low - at_high);
    part = low + (high - low) * (tries % 3 == 2 ? 0.5 : std::clamp(secant, 0.01, 0.99));
  }
  return false;
}
// [direct_advance]

// [direct_bounds]
/// Has friction follow the impulses along the normals; false where none is off by more than a
/// tolerance [N s].
inline bool moved_bounds(DirectSystem& system, double tolerance)
{
  bool moved = false;
  for (const DirectContact& contact : system.contacts)
  {
    for (std::size_t i = contact.first; i < contact.end; ++i)
    {
      DirectPoint& point = system.points[i];
      const double size = point.friction.norm();
      point.bound = contact.of->friction * point.impulse;
      const double above = size - point.bound;
      moved = moved || above > tolerance || (point.grip == Grip::slip && -above > tolerance);
    }
  }
  if (moved)
  {
    find_missing(system);
  }
  return moved;
}
// [direct_bounds]

/// Writes what was found into the world.
inline void scatter(const DirectSystem& system, IslandView world, const Island& island)
{
  for (std::size_t i = 0; i < island.bodies.size(); ++i)
  {
    RigidBody& body = world.bodies[place_of(island.bodies[i])];
    body.velocity = system.velocities[i].head<3>();
    body.angular_velocity = system.velocities[i].tail<3>();
  }
  std::size_t point = 0;
  for (const int i : island.contacts)
  {
    for (WorldPoint& of : world.contacts[place_of(i)].points())
    {
      of.impulse = system.points[point].impulse;
      of.friction = system.points[point].friction;
      of.solved = true;
      ++point;
    }
  }
}

// [direct_solver]
/// Finds the velocities of islands after a step. It remembers how the last island was laid out, and
/// is quicker if the next one hangs together in the same way.
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
    guess(system_, 2 * step * world.gravity.norm());
    for (int i = 0; i < settings.iterations; ++i)
    {
      assemble(system_, matrix_);
      if (!matrix_.factor())
      {
        return false;
      }
      change_ = system_.missing;
      matrix_.solve(change_);
      const bool exact = advance(system_, change_);
      const double most = largest_impulse(system_);
      const double small = std::max(settings.tolerance * most, rounding_of(system_));
      if ((exact || size_of_missing(system_) <= small) &&
          !moved_bounds(system_, settings.friction_tolerance * most))
      {
        scatter(system_, world, island);
        return true;
      }
    }
    return false;
  }

private:
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
    }
    return matrix_.products() <= products;
  }

  DirectSystem system_;
  BlockCholesky matrix_;
  std::vector<Vector6> change_;
  std::vector<std::pair<int, int>> coupled_, laid_out_;
};
// [direct_solver]

} // namespace cookbook
