#pragma once

/// \file
/// \brief A column of bodies whose overlaps are corrected by moving them, in one dimension.

#include "06_world/position_based/position_based.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace cookbook
{

/// Bodies one above the other, at rest on the ground or on each other.
template <class Real>
struct PositionColumn
{
  std::vector<Real> masses;  ///< [kg], from below
  std::vector<Real> sinks;   ///< [m], of each body below where it began
  Real compliance = Real(0); ///< [m/N], of every contact
};

/// A column as it begins.
template <class Real>
PositionColumn<Real> position_column(const std::vector<Real>& masses, const Real& compliance)
{
  return {masses, std::vector<Real>(masses.size(), Real(0)), compliance};
}

/// One pass of corrections, from below, with what each contact has got so far; R15.
template <class Real>
void correct_column(
    PositionColumn<Real>& column, std::vector<Real>& normal_lambda, const Real& substep)
{
  const Real compliance = column.compliance / (substep * substep);
  for (std::size_t i = 0; i < column.masses.size(); ++i)
  {
    const bool ground = i == 0;
    const Real inverse = Real(1) / column.masses[i];
    const Real below = ground ? Real(0) : Real(Real(1) / column.masses[i - 1]);
    const Real error = (ground ? Real(0) : column.sinks[i - 1]) - column.sinks[i];
    const Real change = std::max(
        Real(-normal_lambda[i]),
        xpbd_change<Real>(error, Real(inverse + below), compliance, normal_lambda[i]));
    normal_lambda[i] += change;
    column.sinks[i] -= change * inverse;
    if (!ground)
    {
      column.sinks[i - 1] += change * below;
    }
  }
}

/// A small step [s] of a column that gravity [m/s²] pulls on, and that keeps no velocity.
///
/// What comes to rest does so where this does not move it any more.
template <class Real>
void small_step(PositionColumn<Real>& column, const Real& gravity, const Real& substep, int passes)
{
  for (Real& sink : column.sinks)
  {
    sink += gravity * substep * substep;
  }
  std::vector<Real> normal_lambda(column.masses.size(), Real(0));
  for (int pass = 0; pass < passes; ++pass)
  {
    correct_column(column, normal_lambda, substep);
  }
}

/// How far [m] the top of a column sinks until it rests, in frames of 1/60 s.
inline double resting_sink(PositionColumn<double> column, int substeps, int passes)
{
  const double substep = 1.0 / 60 / substeps;
  double before = -1;
  while (std::abs(column.sinks.back() - before) > 1e-13 * column.sinks.back())
  {
    before = column.sinks.back();
    small_step(column, 9.81, substep, passes);
  }
  return column.sinks.back();
}

} // namespace cookbook
