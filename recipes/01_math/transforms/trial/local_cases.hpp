#pragma once

/// \file
/// \brief Ways to see a point of the world in a body's frame, and transforms that break them.

#include "01_math/transforms/trial/transforms_cases.hpp"

#include <array>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to see a point of the world in a body's frame, by name.
struct LocalMethod
{
  std::string name;                                                              ///< as on the page
  Vector3<float> (*local)(const Affine3<float>& t, const Vector3<float>& point); ///< the way
};

/// A transform whose matrix is taken for a rotation, whatever it is.
inline Isometry3<float> taken_for_isometry(const Affine3<float>& t)
{
  return pose<float>(t.linear(), t.translation());
}

/// The ways that compete, the recommended one last.
inline std::array<LocalMethod, 4> local_methods()
{
  using T = Affine3<float>;
  using V = Vector3<float>;
  return {
      {{"Isometry3::inverse()",
        [](const T& t, const V& p) -> V { return taken_for_isometry(t).inverse() * p; }},
       {"Affine3::inverse()", [](const T& t, const V& p) -> V { return t.inverse() * p; }},
       {"Rᵀ(p − t)",
        [](const T& t, const V& p) -> V { return to_local<float>(taken_for_isometry(t), p); }},
       {"M⁻¹(p − t)",
        [](const T& t, const V& p) -> V { return to_local<float>(t, p).value_or(V::Zero()); }}}};
}

/// A body's transform; the point is the one nearest to (1, 2, 3) of the body.
struct LocalCase
{
  std::string what; ///< the transform, in a few words
  Affine3<float> t; ///< the transform
};

/// The transforms to try on the point.
inline std::vector<LocalCase> local_cases()
{
  const Vector3<float> close(5, -1, 2), distant(1e6f, -2e6f, 3e6f);
  const Matrix3<float> drifted = turned_345() * 1.01f, tiny = turned_345() * 1e-15f;
  Matrix3<float> sheared = turned_345();
  sheared(0, 1) += 0.01f;
  return {
      {"a pose near the origin", affine(turned_345(), close)},
      {"a pose 4,000 km away", affine(turned_345(), distant)},
      {"a turn that has grown by 1 %", affine(drifted, close)},
      {"a turn that has sheared by 1 %", affine(sheared, close)},
      {"a turn and Scale(1e-15)", affine(tiny, Vector3<float>(0, 0, 0))},
      {"grown by 1 %, 4,000 km away", affine(drifted, distant)}};
}

/// Local points are of the size 1: right within a tenth of a millimetre of a metre.
inline constexpr double allowed_local = 1e-4;

} // namespace cookbook
