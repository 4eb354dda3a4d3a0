#pragma once

/// \file
/// \brief Ways to turn a camera towards its target, and cameras that break them.

#include "02_primitives/camera/look_at.hpp"
#include "common/math/rotation.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cookbook
{

// [look_at_pitfalls]
/// As it is mostly written: two cross products, divided by their lengths.
inline Matrix3<float>
look_at_unguarded(const Vector3<float>& eye, const Vector3<float>& target, const Vector3<float>& up)
{
  Matrix3<float> axes;
  const Vector3<float> away = eye - target, back = away / away.norm();
  const Vector3<float> aside = up.cross(back), right = aside / aside.norm();
  axes << right, back.cross(right), back;
  return axes;
}

/// The same, with another up where the length of the first cross product is under a thousandth.
inline Matrix3<float>
look_at_threshold(const Vector3<float>& eye, const Vector3<float>& target, const Vector3<float>& up)
{
  const Vector3<float> back = (eye - target).normalized();
  const bool parallel = up.cross(back).norm() < 1e-3f;
  return look_at_unguarded(eye, target, parallel ? Vector3<float>(0, 0, 1) : up);
}
// [look_at_pitfalls]

/// A way to turn a camera, by name.
struct LookMethod
{
  std::string name; ///< as on the page
  Matrix3<float> (*axes)(
      const Vector3<float>& eye, const Vector3<float>& target,
      const Vector3<float>& up); ///< right, up and back
};

/// The ways that compete, the recommended one last.
inline std::array<LookMethod, 3> look_methods()
{
  using V = Vector3<float>;
  return {
      {{"unguarded", look_at_unguarded},
       {"threshold", look_at_threshold},
       {"recommended", [](const V& eye, const V& target, const V& up) -> Matrix3<float> {
          return look_at<float>(eye, target, up).linear();
        }}}};
}

/// Where a camera stands and looks, and what is truly to its right; zero: any direction will do.
struct LookCase
{
  std::string what;             ///< in a few words
  Vector3<float> eye, target;   ///< [m]
  Vector3<float> up;            ///< any length
  Vector3<double> right, ahead; ///< [1]
};

/// Cameras to turn.
inline std::vector<LookCase> look_cases()
{
  const Vector3<float> y(0, 1, 0), zero(0, 0, 0);
  using V = Vector3<double>;
  const V any(0, 0, 0), x(1, 0, 0), down(0, -1, 0);
  const double root = std::sqrt(0.5);
  return {
      {"level, ahead", {0, 0, 5}, zero, y, x, {0, 0, -1}},
      {"eye at the target", {1, 2, 3}, {1, 2, 3}, y, x, {0, 0, -1}},
      {"straight down", {0, 5, 0}, zero, y, any, down},
      {"nearly straight down", {0, 5, 1e-3f}, zero, y, x, {0, -1, -2e-4}},
      {"nearly parallel, on a slant",
       {1, 3, 5 + 0x1p-10f},
       zero,
       {1, 3, 5},
       V(3, -1, 0) / std::sqrt(10.0),
       V(-1, -3, -5 - 0x1p-10)},
      {"up is zero", {0, 0, 5}, zero, zero, x, {0, 0, -1}},
      {"1e-25 m from the target",
       {1e-25f, 0, 1e-25f},
       zero,
       y,
       {root, 0, -root},
       {-root, 0, -root}},
      {"1e25 m from the target", {1e25f, 0, 1e25f}, zero, y, {root, 0, -root}, {-root, 0, -root}}};
}

/// How far the axes are from a rotation that looks ahead with that on its right.
inline double look_error(const Matrix3<float>& axes, const LookCase& one)
{
  if (!axes.allFinite())
  {
    return std::numeric_limits<double>::infinity();
  }
  const Matrix3<double> m = axes.cast<double>();
  const double off = (m.col(2) + one.ahead.normalized()).cwiseAbs().maxCoeff();
  const double aside = one.right.isZero(0) ? 0 : (m.col(0) - one.right).cwiseAbs().maxCoeff();
  return std::max<double>({rotation_error(m), off, aside});
}

/// The verdicts on all ways to turn a camera: right within 1e-6.
inline std::vector<VerdictRow> look_verdicts()
{
  std::vector<VerdictRow> all;
  for (const LookCase& one : look_cases())
  {
    all.push_back({"", one.what, {}});
    for (const LookMethod& method : look_methods())
    {
      const double error = look_error(method.axes(one.eye, one.target, one.up), one);
      const std::string off = std::isinf(error) ? "not a number" : rounded(error) + " off";
      all.back().verdicts.push_back({error <= 1e-6, error <= 1e-6 ? "right" : off});
    }
  }
  return all;
}

} // namespace cookbook
