#pragma once

/// \file
/// \brief Contacts as a system of equations: small enough to be solved in fractions.

#include "common/math/vector.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cookbook
{

// [push_problem]
/// How impulses at contacts change the speeds at which the surfaces part there.
template <class Real>
struct PushProblem
{
  Eigen::MatrixX<Real> response; ///< [1/kg], n by n: what an impulse at j does to the speed at i
  Eigen::VectorX<Real> speeds;   ///< [m/s], n, without any impulse

  /// The speeds [m/s] with impulses [N s].
  Real speed(const Eigen::VectorX<Real>& impulses, Eigen::Index i) const
  {
    return speeds(i) + response.row(i).dot(impulses);
  }
};

/// One pass: each impulse in turn is corrected, its sum never below zero; R7.
template <class Real>
void correct_in_turn(const PushProblem<Real>& problem, Eigen::VectorX<Real>& impulses)
{
  for (Eigen::Index i = 0; i < impulses.size(); ++i)
  {
    const Real change = -problem.speed(impulses, i) / problem.response(i, i);
    impulses(i) = std::max(Real(0), Real(impulses(i) + change));
  }
}

/// How far [m/s] impulses are from an answer; R10.
template <class Real>
Real residual(const PushProblem<Real>& problem, const Eigen::VectorX<Real>& impulses)
{
  using std::abs;
  Real most(0);
  for (Eigen::Index i = 0; i < impulses.size(); ++i)
  {
    const Real pressed = problem.response(i, i) * impulses(i);
    most = std::max(most, Real(abs(std::min(pressed, problem.speed(impulses, i)))));
  }
  return most;
}
// [push_problem]

/// Bodies one on top of the other on the ground, that gravity has just given a speed [m/s]; contact
/// i is below body i.
template <class Real>
PushProblem<Real> column(const std::vector<Real>& masses, const Real& fallen)
{
  const auto n = static_cast<Eigen::Index>(masses.size());
  PushProblem<Real> problem{
      Eigen::MatrixX<Real>::Zero(n, n), Eigen::VectorX<Real>::Constant(n, Real(0))};
  problem.speeds(0) = -fallen;
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const Real inverse = Real(1) / masses[static_cast<std::size_t>(i)];
    problem.response(i, i) += inverse;
    if (i + 1 < n)
    {
      problem.response(i + 1, i + 1) += inverse;
      problem.response(i, i + 1) = problem.response(i + 1, i) = -inverse;
    }
  }
  return problem;
}

/// The impulses [N s] that carry a column: at each contact the weight of all that is above; R9.
template <class Real>
Eigen::VectorX<Real> carrying_impulses(const std::vector<Real>& masses, const Real& fallen)
{
  Eigen::VectorX<Real> impulses(static_cast<Eigen::Index>(masses.size()));
  Real above(0);
  for (Eigen::Index i = impulses.size() - 1; i >= 0; --i)
  {
    above += masses[static_cast<std::size_t>(i)];
    impulses(i) = fallen * above;
  }
  return impulses;
}

/// The largest error of impulses, as a share of what each ought to be.
template <class Real>
Real impulse_error(const Eigen::VectorX<Real>& impulses, const Eigen::VectorX<Real>& right)
{
  return (impulses - right).cwiseQuotient(right).cwiseAbs().maxCoeff();
}

/// How many passes a cold column needs until its impulses are right to a share; R8.
inline int passes_needed(const std::vector<double>& masses, double share)
{
  const PushProblem<double> problem = column(masses, 1.0);
  const Eigen::VectorXd right = carrying_impulses(masses, 1.0);
  Eigen::VectorXd impulses = Eigen::VectorXd::Zero(right.size());
  int passes = 0;
  for (; impulse_error(impulses, right) > share; ++passes)
  {
    correct_in_turn(problem, impulses);
  }
  return passes;
}

/// The factor by which the last of some passes makes the error of a column smaller, or the last one
/// before it is smaller than a billionth; R8.
inline double error_factor(const std::vector<double>& masses, int passes)
{
  const PushProblem<double> problem = column(masses, 1.0);
  const Eigen::VectorXd right = carrying_impulses(masses, 1.0);
  Eigen::VectorXd impulses = Eigen::VectorXd::Zero(right.size());
  double before = 1, factor = 0;
  for (int pass = 0; pass < passes && before > 1e-9; ++pass)
  {
    correct_in_turn(problem, impulses);
    const double error = impulse_error(impulses, right);
    factor = error / before;
    before = error;
  }
  return factor;
}

/// A column from frame to frame: its speeds and impulses at the end of one.
template <class Real>
struct ColumnFrame
{
  Eigen::VectorX<Real> speeds;   ///< [m/s], at which the contacts part
  Eigen::VectorX<Real> impulses; ///< [N s], of the frame
};

/// The next frame of a column that gravity pulls on: some passes, cold or warm.
template <class Real>
ColumnFrame<Real> next_column_frame(
    const PushProblem<Real>& column, const ColumnFrame<Real>& before, int passes, bool warm)
{
  PushProblem<Real> now = column;
  now.speeds += before.speeds;
  ColumnFrame<Real> frame{before.speeds, before.impulses};
  if (!warm)
  {
    frame.impulses.setZero();
  }
  for (int pass = 0; pass < passes; ++pass)
  {
    correct_in_turn(now, frame.impulses);
  }
  frame.speeds = now.speeds + now.response * frame.impulses;
  return frame;
}

} // namespace cookbook
