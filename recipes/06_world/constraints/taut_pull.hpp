#pragma once

/// \file
/// \brief How fast a taut joint has a body swing, and what a step adds to its inertia against that.

#include "06_world/constraints/constraint_row.hpp"
#include "common/math/vector.hpp"

#include <algorithm>
#include <cmath>

namespace cookbook
{

// [taut_pull]
/// What the rows of one joint do to one of its bodies: how it is pulled, and how far from its
/// centre.
struct TautPull
{
  Vector3<double> impulse = Vector3<double>::Zero(); ///< [N s], world
  double squared_arm = 0;                            ///< [m²], of three linear rows

  /// Adds a row of the body and its impulse [N s]; angular rows do not pull.
  void add(const Vector6& row, double pushed)
  {
    if (!row.head<3>().isZero(0))
    {
      impulse += pushed * row.head<3>();
      squared_arm += row.tail<3>().squaredNorm() / 2; // |r × x|² + |r × y|² + |r × z|² = 2 |r|²
    }
  }
};

/// By how much [kg m²] a pull stiffens its body in a step [s], h² K: K = T L (1 − u uᵀ), R64. L is
/// the whole arm, as for a pull along it; zero where nothing pulls.
inline Matrix3<double> taut_stiffness(const TautPull& pull, double step)
{
  const double size = pull.impulse.norm(); // h T
  if (!(size > 0))
  {
    return Matrix3<double>::Zero();
  }
  const Vector3<double> along = pull.impulse / size;
  return step * size * std::sqrt(pull.squared_arm) *
         (Matrix3<double>::Identity() - along * along.transpose());
}

/// The square of ω h [1], of the swing about the centre of a body to which this much stiffness
/// [kg m²] belongs: a bound, the larger one of the two about axes across the pull.
inline double
squared_swing(const Matrix3<double>& stiffness, const Matrix3<double>& inverse_inertia)
{
  const Matrix3<double> of = inverse_inertia * stiffness;
  const double sum = of.trace(); // of two eigenvalues, and a zero
  const double product = (sum * sum - of.cwiseProduct(of.transpose()).sum()) / 2;
  return sum / 2 + std::sqrt(std::max(0.0, sum * sum / 4 - product));
}

/// A swing of a squared ω h above this is taken by implicit steps: 4 is where explicit ones
/// diverge; R63, R64.
inline constexpr double most_squared_swing = 3;
// [taut_pull]

} // namespace cookbook
