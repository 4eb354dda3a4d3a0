#pragma once

/// \file
/// \brief Pairs of vectors of every angle, and how wrong a way to find it is.

#include "01_math/angles/trial/angles_cases.hpp"
#include "tools/exact/exact.hpp"
#include "tools/measure/statistics.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace cookbook
{

/// Two vectors.
template <class Real>
using VectorPair = std::pair<Vector3<Real>, Vector3<Real>>;

// [angle_workload]
/// Pairs from hardly apart to hardly less than opposite: half of all angles are below a tenth.
template <class Real>
std::vector<VectorPair<Real>> angle_workload(int count)
{
  std::mt19937 random(1);
  const auto vector = [&random]
  {
    const auto component = [&]
    { return static_cast<Real>(random() % 4001) / Real(1000) - Real(2); };
    const Real x = component(), y = component();
    return Vector3<Real>(x, y, component());
  };
  std::vector<VectorPair<Real>> pairs;
  while (static_cast<int>(pairs.size()) < count)
  {
    const Vector3<Real> a = vector(), other = vector();
    const int power = static_cast<int>(random() % (sizeof(Real) > 4 ? 9 : 6));
    const Vector3<Real> b = a + other * static_cast<Real>(std::pow(10.0, -power));
    const bool parallel =
        a.template cast<double>().normalized() == b.template cast<double>().normalized();
    if (!parallel && !a.isZero(0) && !b.isZero(0))
    {
      pairs.push_back({a, random() % 4 == 0 ? Vector3<Real>(-b) : b});
    }
  }
  return pairs;
}
// [angle_workload]

/// The angle of two vectors, from exact products [rad].
template <class Real>
long double true_angle(const VectorPair<Real>& pair)
{
  const Vector3<Reference> a = exact<Reference>(pair.first), b = exact<Reference>(pair.second);
  const Vector3<Reference> cross = a.cross(b);
  return std::atan2(cross.template cast<long double>().norm(), static_cast<long double>(a.dot(b)));
}

/// How wrong a way is on a workload, as a part of the angle.
template <class Real>
measure::ErrorStatistics
angle_errors(const AngleMethod<Real>& method, const std::vector<VectorPair<Real>>& pairs)
{
  std::vector<double> errors;
  for (const VectorPair<Real>& pair : pairs)
  {
    const long double truth = true_angle(pair);
    const long double found = method.angle(pair.first, pair.second);
    errors.push_back(static_cast<double>(std::abs(found - truth) / truth));
  }
  return measure::error_statistics(errors);
}

} // namespace cookbook
