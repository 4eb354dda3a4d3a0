#pragma once

/// \file
/// \brief A linear system whose unknowns have bounds: an active set, and passes where it cycles.

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cookbook::small_world::plain_direct
{

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// [solve_free]
/// What an impulse may be [N s], row by row.
struct Bounds
{
  VectorXd low;
  VectorXd high;
};

/// Whether a row is an equation, with a free impulse, or its impulse is held at a bound.
enum class State
{
  free,
  low,
  high
};

/// Those rows that are equations.
inline std::vector<Index> free_rows(const std::vector<State>& states)
{
  std::vector<Index> rows;
  for (std::size_t i = 0; i < states.size(); ++i)
  {
    if (states[i] == State::free)
    {
      rows.push_back(static_cast<Index>(i));
    }
  }
  return rows;
}

/// The impulses x of which A x + b is zero in the free rows, by Cholesky's factorisation A = L Lᵀ.
inline VectorXd solve_free(
    const MatrixXd& A, const VectorXd& b, const Bounds& bounds, const std::vector<State>& states)
{
  VectorXd x = VectorXd::Zero(b.size());
  for (Index i = 0; i < b.size(); ++i)
  {
    const State state = states[static_cast<std::size_t>(i)];
    x[i] = state == State::low ? bounds.low[i] : state == State::high ? bounds.high[i] : 0;
  }
  const std::vector<Index> free = free_rows(states);
  const VectorXd residual = -(A * x + b)(free);
  const MatrixXd of_free = A(free, free);
  const VectorXd found = of_free.llt().solve(residual);
  x(free) = found;
  return x;
}
// [solve_free]

// [active_set]
/// The state that a row should have: an impulse beyond a bound is held there; one that is held is
/// freed where its speed A x + b is on the wrong side. Both but for rounding.
inline State
better_state(State state, double x, double speed, double low, double high, double tolerance)
{
  if (state == State::free)
  {
    return x < low - tolerance ? State::low : x > high + tolerance ? State::high : State::free;
  }
  const bool wrong = state == State::low ? speed < -1e-9 : speed > 1e-9;
  return wrong && low < high ? State::free : state;
}

/// The states that all rows should have after a solution.
inline std::vector<State> better_states(
    const MatrixXd& A, const VectorXd& b, const Bounds& bounds, const std::vector<State>& states,
    const VectorXd& x)
{
  const VectorXd speeds = A * x + b;
  const double tolerance = 1e-9 * x.cwiseAbs().maxCoeff();
  std::vector<State> better = states;
  for (Index i = 0; i < b.size(); ++i)
  {
    State& state = better[static_cast<std::size_t>(i)];
    state = better_state(state, x[i], speeds[i], bounds.low[i], bounds.high[i], tolerance);
  }
  return better;
}

/// Solves row by row, a hundred passes: no more than close, but nothing can go wrong; R7.
inline VectorXd solve_in_turn(const MatrixXd& A, const VectorXd& b, const Bounds& bounds)
{
  VectorXd x = VectorXd::Zero(b.size());
  for (int pass = 0; pass < 100; ++pass)
  {
    for (Index i = 0; i < b.size(); ++i)
    {
      const double change = -(A.row(i).dot(x) + b[i]) / A(i, i);
      x[i] = std::clamp(x[i] + change, bounds.low[i], bounds.high[i]);
    }
  }
  return x;
}

/// The impulses x within their bounds. A x + b is zero where x is between them, not negative where
/// x is at the low one, and not positive where x is at the high one; R10.
///
/// The states are those that it begins and ends with.
inline VectorXd
solve_within(const MatrixXd& A, const VectorXd& b, const Bounds& bounds, std::vector<State>& states)
{
  for (int round = 0; round < 100; ++round)
  {
    VectorXd x = solve_free(A, b, bounds, states);
    const std::vector<State> better = better_states(A, b, bounds, states, x);
    if (better == states)
    {
      return x;
    }
    if (round < 15)
    {
      states = better;
      continue;
    }
    std::size_t last = states.size() - 1; // one row at a time ends the cycles, slowly
    while (states[last] == better[last])
    {
      --last;
    }
    states[last] = better[last];
  }
  return solve_in_turn(A, b, bounds);
}
// [active_set]

} // namespace cookbook::small_world::plain_direct
