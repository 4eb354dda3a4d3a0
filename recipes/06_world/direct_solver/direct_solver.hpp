#pragma once

/// \file
/// \brief All contacts of an island at once: Newton's method with an exact factorisation.

#include "06_world/direct_solver/direct_answer.hpp"
#include "06_world/direct_solver/direct_bends.hpp"
#include "06_world/direct_solver/direct_residual.hpp"
#include "06_world/direct_solver/direct_taut.hpp"
#include "06_world/direct_solver/factored_points.hpp"
#include "06_world/direct_solver/line_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace cookbook
{

// [direct_bounds]
/// Guesses that every new point is active whose gap a speed [m/s] could close in the step, so that
/// a tower stands from the first iteration on and not box by box. Whether there are any: then the
/// residual was found without them, and the first change leads past the answer.
inline bool guess_active_set(DirectSystem& system, double speed)
{
  bool any = false;
  for (DirectPoint& point : system.points)
  {
    if (!point.solved && !point.active && point.bias <= speed)
    {
      point.active = true;
      point.friction_state = FrictionState::stick;
      any = true;
    }
  }
  return any;
}

/// Sets the bounds of friction by the normal impulses that were found. `largest` [N s] is the
/// largest impulse, `residual` [N s] what may be left of a residual. Whether any friction was off
/// its bound by more than the settings allow.
inline bool
update_bounds(DirectSystem& system, double largest, double residual, const DirectSettings& settings)
{
  bool off = false;
  for (const DirectContact& contact : system.contacts)
  {
    const double tolerance = friction_tolerance_at(contact, largest, residual, settings);
    bool changes = false;
    for (std::size_t i = contact.first; i < contact.end; ++i)
    {
      DirectPoint& point = system.points[i];
      const double bound = point.coefficient * point.impulse;
      if (!settings.bounds_move && bound_stays(point, bound, largest))
      {
        continue;
      }
      const double above = point.friction.norm() - bound;
      const auto off_by_more_than = [&](double most)
      { return above > most || (point.friction_state != FrictionState::stick && -above > most); };
      changes = changes || off_by_more_than(0) ||
                (point.friction_state != FrictionState::none) != (bound > 0);
      off = off || off_by_more_than(tolerance);
      point.bound = bound;
    }
    if (changes)
    {
      add_impulses(system, contact, -1);
      update_point(system, contact);
      add_impulses(system, contact, 1);
    }
  }
  return off;
}
// [direct_bounds]

// [direct_solver]
/// Finds the velocities of islands after a step. It keeps the layout of the last island's matrix,
/// and its factor while the active set stays the same; an answer by an old factor counts only if
/// its residual is small enough.
class DirectSolver
{
public:
  /// Finds the velocities of the bodies of an island after a step [s], and sets the impulses of its
  /// contacts. False if they were not found; then nothing has changed.
  bool
  solve(IslandView world, const Island& island, double step, const DirectSettings& settings = {})
  {
    gather(system_, world, island, step, settings);
    if (!lay_out(settings.products))
    {
      return false;
    }
    guess_motors(system_.rows);
    find_residual(system_);
    const bool was_guessed = guess_active_set(system_, 2 * step * world.gravity.norm());
    const bool stiff = settings.softening == 0;
    bool fresh = false; // whether the matrix was factored in this step
    bends_ = 0;
    for (int i = 0; i < settings.iterations; ++i)
    {
      // Factors the matrix, unless the factor at hand is of the same active set.
      const bool at_hand = (i > 0 ? fresh : stiff && system_.rows.empty()) &&
                           factored_.are_those_of(system_.points, system_.rows);
      if (!at_hand && !factor())
      {
        return false;
      }
      fresh = fresh || !at_hand;
      // Takes a step of Newton's method.
      change_ = system_.residual;
      matrix_.solve(change_);
      const LineSearch search = line_search(system_, change_);
      const bool was_unbounded = !search.stuck && bound_rows(system_);
      // Asks whether that is an answer.
      const double largest = largest_impulse(system_);
      tolerance_ =
          std::max({settings.tolerance * largest, rounding_of(system_), settings.residual});
      const bool exact = search.exact && fresh && !was_unbounded && (i > 0 || !was_guessed);
      const bool found = exact || residual_norm(system_) <= tolerance_;
      residual_ = system_.residual; // before the bounds move
      // Moves the bounds of friction, where the impulses are good enough to set them.
      const bool sets_bounds = found || search.stuck || (stiff && search.fraction >= 0.5);
      const bool moved = sets_bounds && update_bounds(system_, largest, tolerance_, settings);
      // With joints, solves once more: for where that answer leads, or implicitly, R64.
      if (found && !moved && bends_ == 0 && too_taut(step, settings))
      {
        stiffen(system_, step);
        fresh = false;
        find_residual(system_);
      }
      else if (found && !moved && bend_again(world, step))
      {
        find_residual(system_);
      }
      else if (found && !moved)
      {
        write_answer(system_, residual_, world, island, velocities_);
        store(system_, is_over_constrained(system_, largest), world, island);
        return true;
      }
    }
    return false;
  }

  /// Solves an island once more without the speed that opens overlaps, friction bounded by the
  /// impulses of the first answer; whether there is such an answer.
  bool solve_without_opening(
      IslandView world, const Island& island, double step, DirectSettings settings = {})
  {
    settings.correction = 0;
    settings.residual = tolerance_;
    settings.bounds_move = false;
    return solve(world, island, step, settings);
  }

  /// The answer, body by body.
  const std::vector<DirectVelocity>& velocities() const { return velocities_; }
  /// The largest ω h [1] with which joints swing a body, in the last answer; R63.
  double swing() const { return std::sqrt(squared_swing_); }
  /// Whether any overlap was to open, with an answer or without.
  bool opens() const { return any_opens(system_); }
  /// How fast [m/s] any overlap opens by that answer.
  double opening() const { return fastest_opening(system_); }

private:
  static constexpr double bent_twice = 0.02; // [rad], turn of a body in a step above which one
                                             // correction leaves enough to gain energy by

  /// Whether joints swing a body faster than a step [s] can follow, for the first time in it.
  bool too_taut(double step, const DirectSettings& settings)
  {
    if (!system_.taut.empty() || system_.rows.empty())
    {
      return false;
    }
    squared_swing_ = largest_squared_swing(system_, step);
    return squared_swing_ > settings.squared_swing;
  }

  /// Whether joints are told how far they will be off where the answer of a step [s] leads: once,
  /// and a second time where bodies turn fast, though no pull swings them by more than a radian in
  /// the step, and the first has left less than half.
  bool bend_again(IslandView world, double step)
  {
    const auto turns_fast = [&](const Vector6& velocities)
    { return step * velocities.tail<3>().norm() > bent_twice; };
    const std::vector<Vector6>& velocities = system_.velocities;
    if (system_.rows.empty() || bends_ == 2 ||
        (bends_ == 1 && (std::none_of(velocities.begin(), velocities.end(), turns_fast) ||
                         largest_squared_swing(system_, step) > 1)))
    {
      return false;
    }
    const double bend = find_bends(system_.rows, world, velocities, step);
    if (bends_ == 1 && !(bend < largest_bend_ / 2))
    {
      return false;
    }
    take_bends(system_.rows, step);
    largest_bend_ = bend;
    ++bends_;
    return true;
  }

  /// Factors the matrix of the system; false if it has none.
  bool factor()
  {
    assemble(system_, matrix_);
    factored_.clear();
    const bool found = matrix_.factor();
    if (found)
    {
      factored_.take(system_.points, system_.rows);
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
    for (const DirectRow& row : system_.rows)
    {
      if (row.a >= 0 && row.b >= 0)
      {
        coupled_.emplace_back(row.a, row.b);
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
  std::vector<Vector6> change_, residual_;
  std::vector<DirectVelocity> velocities_;
  std::vector<std::pair<int, int>> coupled_, laid_out_;
  double tolerance_ = 0; // [N s], that the last residual was held against
  double squared_swing_ = 0;
  double largest_bend_ = 0; // [m, rad], that joints were told last
  int bends_ = 0;           // how often they were told in this step
};
// [direct_solver]

} // namespace cookbook
