#pragma once

/// \file
/// \brief The rows of one joint, and how they are solved: what is rigid together, the rest in turn.

#include "05_resolution/position_correction/softness.hpp"
#include "06_world/constraints/constraint_row.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <span>

namespace cookbook
{

// [joint_rows]
/// The rows of a joint, the same number in each step and in the same order. Rigid ones come first,
/// at most six: they are solved together.
class JointRows
{
public:
  static constexpr std::size_t most = 12; ///< rows that a joint may have

  void add(const ConstraintRow& row) { rows_.at(size_++) = row; } ///< std::out_of_range beyond that
  void clear() { size_ = 0; }

  /// Leaves out by what errors bend, as where bodies have moved already.
  void stop_turning()
  {
    std::for_each(rows_.begin(), rows_.end(), [](ConstraintRow& row) { row.turning = 0; });
  }

  std::size_t size() const { return size_; }
  std::span<const ConstraintRow> all() const { return {rows_.data(), size_}; }
  const ConstraintRow& operator[](std::size_t i) const { return rows_[i]; }

  /// How many rigid ones there are at the front.
  std::size_t rigid() const
  {
    const auto end = rows_.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(size_, 6));
    return static_cast<std::size_t>(std::find_if_not(rows_.begin(), end, is_rigid) - rows_.begin());
  }

private:
  std::array<ConstraintRow, most> rows_;
  std::size_t size_ = 0;
};

/// Impulses [N s, N m s] of the rows of a joint.
using JointImpulses = std::array<double, JointRows::most>;

/// What a kind of joint is: two bodies, a name, and functions that refuse what makes no sense
/// (std::invalid_argument) and give the rows with the bodies as they are before a step [s].
template <class Kind>
concept JointKind = requires(const Kind& joint, const RigidBody& body, double step, JointRows& rows)
{
  {
    joint.a
    } -> std::convertible_to<int>;
  {
    joint.b
    } -> std::convertible_to<int>;
  {
    joint.collides
    } -> std::convertible_to<bool>;
  {
    Kind::name
    } -> std::convertible_to<const char*>;
  check_joint(joint);
  joint_rows(joint, body, body, step, rows);
};

/// As many numbers as there are rigid rows, and K of all of them.
using RigidVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;
using RigidMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

/// How much [1/kg, ...] rigid rows give way to pushes along each other: K = J M⁻¹ Jᵀ; R36.
inline RigidMatrix
rigid_inverse_mass(const JointRows& rows, const Body<double>& a, const Body<double>& b)
{
  const auto count = static_cast<Eigen::Index>(rows.rigid());
  RigidMatrix k(count, count);
  for (Eigen::Index j = 0; j < count; ++j)
  {
    const ConstraintRow& row = rows[static_cast<std::size_t>(j)];
    const Vector6 on_a = given_by(a, row.a), on_b = given_by(b, row.b);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      const ConstraintRow& other = rows[static_cast<std::size_t>(i)];
      k(i, j) = other.a.dot(on_a) + other.b.dot(on_b);
    }
  }
  return k;
}

/// 1/K of one row [kg]; 0 where nothing gives way.
inline double row_mass(const ConstraintRow& row, const Body<double>& a, const Body<double>& b)
{
  const double k = inverse_mass_of(a, row.a) + inverse_mass_of(b, row.b);
  return k > 0 ? 1 / k : 0;
}

/// Corrects the velocities of two bodies once along all rigid rows at once, by the factor of their
/// K, in a substep [s], and adds to their impulses so far.
inline void solve_rigid(
    const JointRows& rows, const Eigen::LDLT<RigidMatrix>& factor, Body<double>& a, Body<double>& b,
    const Softness<double>& softness, double substep, JointImpulses& impulses)
{
  const std::size_t count = rows.rigid();
  RigidVector speed(static_cast<Eigen::Index>(count));
  for (std::size_t i = 0; i < count; ++i)
  {
    speed[static_cast<Eigen::Index>(i)] = row_speed(rows[i], a.motion, b.motion) +
                                          softness.bias_rate * rows[i].error +
                                          substep / 2 * rows[i].turning - rows[i].speed;
  }
  const RigidVector rigid = factor.solve(speed);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double change = -softness.mass_scale * rigid[static_cast<Eigen::Index>(i)] -
                          softness.impulse_scale * impulses[i];
    impulses[i] += change;
    push_along(a, rows[i].a, change);
    push_along(b, rows[i].b, change);
  }
}
// [joint_rows]

} // namespace cookbook
