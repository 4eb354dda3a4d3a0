#pragma once

/// \file
/// \brief Solids put together, and what each way to add up their inertia makes of them.

#include "05_resolution/mass_properties/trial/mass_properties_pitfalls.hpp"
#include "05_resolution/mass_properties/trial/mass_properties_scenes.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// Solids that hold together, and their inertia about the common centre of mass by hand.
template <class Real>
struct InertiaCase
{
  std::string what;
  std::vector<PlacedSolid<Real>> solids;
  Matrix3<Real> right; ///< [kg m²], along the common axes
};

/// The matrix with these entries on its diagonal, and one more in the plane of x and y.
template <class Real>
Matrix3<Real> symmetric(const Vector3<Real>& diagonal, const Real& xy)
{
  Matrix3<Real> matrix = diagonal.asDiagonal();
  matrix(0, 1) = matrix(1, 0) = xy;
  return matrix;
}

/// All cases.
///
/// Three cubes: the centre is at (1/3, 1/3, 0); squared distances from it sum to 2/3 along x and
/// along y, products to -1/3; each cube adds its own 1/6. The rod: 0.02 along it and 1.01 across,
/// mixed by the squares of 3/5 and 4/5.
template <class Real>
std::vector<InertiaCase<Real>> inertia_cases()
{
  const auto fraction = [](int a, int b) { return Real(Real(a) / Real(b)); };
  const Real cube = fraction(16, 3);
  return {
      {"one cube",
       {upright<Real>(one_cube<Real>(), {0, 0, 0})},
       symmetric<Real>(Vector3<Real>::Constant(fraction(1, 6)), 0)},
      {"eight cubes that make one", eight_cubes<Real>(),
       symmetric<Real>(Vector3<Real>::Constant(cube), 0)},
      {"two balls on a stick", dumbbell<Real>(),
       symmetric<Real>({fraction(1, 5), fraction(41, 5), fraction(41, 5)}, 0)},
      {"three cubes that make an L", three_cubes<Real>(),
       symmetric<Real>({fraction(7, 6), fraction(7, 6), fraction(11, 6)}, fraction(1, 3))},
      {"a rod that leans", leaning_rod<Real>(),
       symmetric<Real>(
           {fraction(6536, 10000), fraction(3764, 10000), fraction(101, 100)},
           fraction(-4752, 10000))}};
}

/// What the moments and axes of the combined solid amount to, along the common axes.
template <class Real>
Matrix3<Real> combined_inertia(const std::vector<PlacedSolid<Real>>& solids)
{
  const PlacedSolid<Real> one = combined(solids);
  return world_inertia(one.properties.moments, one.axes);
}

/// The verdicts: an inertia holds if no entry is off by more than 1e-12 of the largest.
inline std::vector<VerdictRow> inertia_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const InertiaCase<double>& one : inertia_cases<double>())
  {
    const auto verdict = [&](const Matrix3<double>& inertia) -> Verdict
    {
      const double off = (inertia - one.right).cwiseAbs().maxCoeff();
      const double share = off / one.right.cwiseAbs().maxCoeff();
      const bool holds = share <= 1e-12;
      return {holds, holds ? "right" : "off by " + number(std::round(1000 * share) / 10) + " %"};
    };
    rows.push_back(
        {"",
         one.what,
         {verdict(moments_added(one.solids)), verdict(diagonal_only(one.solids)),
          verdict(combined_inertia(one.solids))}});
  }
  return rows;
}

} // namespace cookbook
