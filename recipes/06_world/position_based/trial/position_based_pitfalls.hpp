#pragma once

/// \file
/// \brief Stiffness as a fraction of each correction, kept to be asserted to fail.

#include "06_world/position_based/trial/position_based_scenes.hpp"

namespace cookbook
{

// [stiffness_fraction]
/// One pass that takes a share [1] of each overlap away, as if that were the contact's stiffness:
/// the more passes, the stiffer.
template <class Real>
void correct_by_share(PositionColumn<Real>& column, const Real& fraction)
{
  for (std::size_t i = 0; i < column.masses.size(); ++i)
  {
    const Real inverse = Real(1) / column.masses[i];
    const Real below = i == 0 ? Real(0) : Real(Real(1) / column.masses[i - 1]);
    const Real overlap = column.sinks[i] - (i == 0 ? Real(0) : column.sinks[i - 1]);
    const Real push = fraction * std::max(Real(0), overlap) / (inverse + below);
    column.sinks[i] -= push * inverse;
    if (i > 0)
    {
      column.sinks[i - 1] += push * below;
    }
  }
}

/// How far [m] the top of a column sinks by such passes until it rests, in 4 small steps a frame.
inline double sink_by_share(PositionColumn<double> column, double fraction, int passes)
{
  for (int step = 0; step < 4000; ++step)
  {
    small_step(column, 9.81, 1.0 / 240, 0);
    for (int pass = 0; pass < passes; ++pass)
    {
      correct_by_share(column, fraction);
    }
  }
  return column.sinks.back();
}
// [stiffness_fraction]

} // namespace cookbook
