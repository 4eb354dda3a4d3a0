#pragma once

/// \file
/// \brief Ways from a matrix to a quaternion, workloads for them, and how wrong they are.

#include "01_math/rotations/quaternion_of.hpp"
#include "01_math/rotations/trial/rotations_pitfalls.hpp"
#include "common/math/rotation.hpp"
#include "tools/exact/exact.hpp"
#include "tools/measure/statistics.hpp"

#ifdef COOKBOOK_HAS_GLM
#include <glm/gtc/quaternion.hpp>
#endif

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace cookbook
{

// [four_roots]
/// Each part by a root of its own, its sign by the difference that belongs to it: no branch, and
/// half of the digits gone where a part is near zero.
inline Quaternion<float> quaternion_by_roots(const Matrix3<float>& r)
{
  const float x = r(0, 0), y = r(1, 1), z = r(2, 2);
  const auto root = [](float square) { return std::sqrt(std::max(0.0f, square)) / 2; };
  return {
      root(1 + x + y + z), std::copysign(root(1 + x - y - z), r(2, 1) - r(1, 2)),
      std::copysign(root(1 - x + y - z), r(0, 2) - r(2, 0)),
      std::copysign(root(1 - x - y + z), r(1, 0) - r(0, 1))};
}
// [four_roots]

// [quaternion_workload]
/// A matrix as the nearest floats, and the whole-number quaternion that it was made of.
struct KnownRotation
{
  Eigen::Vector4i whole; ///< w, x, y, z
  Matrix3<float> r;      ///< its rotation
};

/// Rotations of quaternions with whole parts up to 60 in size, w up to `most` only.
inline std::vector<KnownRotation> known_rotations(int most)
{
  std::mt19937 random(1);
  const auto drawn = [&](int limit)
  { return static_cast<int>(random() % static_cast<unsigned>(2 * limit + 1)) - limit; };
  std::vector<KnownRotation> all;
  while (all.size() < 2000)
  {
    const int w = drawn(most), x = drawn(60), y = drawn(60), z = drawn(60);
    if (x != 0 || y != 0 || z != 0)
    {
      all.push_back({{w, x, y, z}, rational_rotation<double>(w, x, y, z).cast<float>()});
    }
  }
  return all;
}
// [quaternion_workload]

/// The largest difference of a part from the truth, in ulps of one, whichever the sign of q;
/// infinite where q is no number or its length is off by 1/1000.
inline double quaternion_error(const Quaternion<float>& q, const Eigen::Vector4i& whole)
{
  if (!q.coeffs().allFinite() || std::abs(q.norm() - 1) > 1e-3f)
  {
    return std::numeric_limits<double>::infinity();
  }
  const Reference length = sqrt(Reference(whole.squaredNorm()));
  const float parts[] = {q.w(), q.x(), q.y(), q.z()};
  Reference plus = 0, minus = 0;
  for (int i = 0; i < 4; ++i)
  {
    const Reference right = whole[i] / length;
    plus = std::max<Reference>(plus, abs(Reference(parts[i]) - right));
    minus = std::max<Reference>(minus, abs(Reference(parts[i]) + right));
  }
  return static_cast<double>(std::min<Reference>(plus, minus)) * 0x1p23;
}

/// How wrong a way is on a workload.
template <class Way>
measure::ErrorStatistics
quaternion_errors(const Way& way, const std::vector<KnownRotation>& rotations)
{
  std::vector<double> errors;
  for (const KnownRotation& one : rotations)
  {
    errors.push_back(quaternion_error(way(one.r), one.whole));
  }
  return measure::error_statistics(errors);
}

#ifdef COOKBOOK_HAS_GLM
/// GLM's way, for its own matrices.
inline Quaternion<float> glm_quaternion(const Matrix3<float>& r)
{
  glm::mat3 columns;
  for (int i = 0; i < 3; ++i)
  {
    columns[i] = glm::vec3(r(0, i), r(1, i), r(2, i));
  }
  const glm::quat q = glm::quat_cast(columns);
  return {q.w, q.x, q.y, q.z};
}
#endif

} // namespace cookbook
