#pragma once

/// \file
/// \brief What joints and other constraints are to a world: pairs of bodies, pushes, and rows.

#include "05_resolution/position_correction/softness.hpp"
#include "06_world/constraints/constraint_row.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <utility>

namespace cookbook
{

// [constraint_set]
/// Two bodies of a constraint, by their places in the world.
struct ConstraintPair
{
  int a, b;
  bool collides;        ///< whether the two may touch
  std::size_t set = 0;  ///< which of the world's sets it is of
  int number = 0;       ///< its number there
  bool changed = false; ///< whether the game has changed it since the last step: both wake
};

/// The two bodies of a constraint.
inline std::pair<int, int> pair_of(const ConstraintPair& pair)
{
  return {pair.a, pair.b};
}

/// Constraints of one kind, such as ball joints, each by its number. What it remembers, such as
/// impulses from step to step, it keeps itself.
///
/// Small steps call prepare(), and in each of them warm_start(), solve() and, once bodies have
/// moved, relax(); sequential impulses call solve() pass by pass, and no relax().
class ConstraintSet
{
public:
  using Bodies = std::span<RigidBody>;

  virtual ~ConstraintSet() = default;

  /// What the kind is called, for messages.
  virtual const char* name() const = 0;
  /// A copy that goes on as the original does: a world is copied with its sets.
  virtual std::unique_ptr<ConstraintSet> clone() const = 0;
  /// Calls `call(pair)` for all constraints; their `set` is not read.
  virtual void each_pair(const std::function<void(const ConstraintPair&)>& call) const = 0;
  /// Drops the constraints of a body that leaves the world.
  virtual void remove_body(int body) = 0;

  /// Begins a step of so many substeps.
  virtual void prepare(int number, int substeps) = 0;
  /// Takes the bodies as they are before a substep [s], and pushes them as the one before has
  /// ended.
  virtual void warm_start(Bodies bodies, int number, double substep) = 0;
  /// Corrects velocities once, so that the error at the substep's end is taken away by a spring.
  virtual void solve(Bodies bodies, int number, const Softness<double>& softness) = 0;
  /// Takes the bodies as they have moved, and corrects velocities once without regard to the error.
  virtual void relax(Bodies bodies, int number) = 0;
  /// Ends a step of so many substeps: writes down with what the next one begins.
  virtual void store(int number, int substeps) = 0;

  /// Calls `emit(row)` for each equation with its two bodies as they are before a step [s].
  virtual void rows(
      const RigidBody& a, const RigidBody& b, int number, double step,
      const std::function<void(const ConstraintRow&)>& emit) const = 0;
  /// Writes down the impulses [N s] of these rows in that step, in their order.
  virtual void store_rows(int number, std::span<const double> impulses) = 0;

  /// Moves the bodies, which their velocities have led on for a substep [s], so that an error is
  /// taken away, for solvers of positions; what is no error but a push, only in the first of
  /// several passes. False where the kind cannot.
  virtual bool correct(Bodies, int, double, bool) { return false; }

  /// Hears where all bodies are when a step of the world [s] has ended, to count turns or to break.
  virtual void finish(std::span<const RigidBody>, double) {}
};

/// A set that is copied with what has it.
class ClonedSet
{
public:
  explicit ClonedSet(const ConstraintSet& of) : set_(of.clone()) {}
  ClonedSet(const ClonedSet& other) : set_(other.set_->clone()) {}
  ClonedSet(ClonedSet&&) noexcept = default;
  ClonedSet& operator=(ClonedSet other) noexcept
  {
    set_ = std::move(other.set_);
    return *this;
  }
  ~ClonedSet() = default;

  ConstraintSet& operator*() const { return *set_; }
  ConstraintSet* operator->() const { return set_.get(); }

private:
  std::unique_ptr<ConstraintSet> set_;
};
// [constraint_set]

} // namespace cookbook
