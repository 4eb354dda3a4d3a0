#pragma once

/// \file
/// \brief Projections: from a camera's coordinates to clip space.

#include "01_math/matrices/cofactors.hpp"
#include "common/math/trigonometry.hpp"
#include "common/math/vector.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace cookbook
{

/// Which depths clip space keeps, after the division by w.
enum class DepthRange
{
  minus_one_to_one, ///< as OpenGL does unless told otherwise
  zero_to_one       ///< as Vulkan, Direct3D and Metal do
};

/// A matrix of double as one of `Real`; nothing if a number of it does not fit, or its scale
/// vanished.
template <class Real>
std::optional<Matrix4<Real>> kept_projection(const Matrix4<double>& m)
{
  const Matrix4<Real>& kept = m.template cast<Real>();
  const bool fits = kept.allFinite() && kept(0, 0) > Real(0) && kept(1, 1) > Real(0);
  return fits ? std::optional<Matrix4<Real>>(kept) : std::nullopt;
}

// [lens]
/// A lens: what is seen at distance 1 reaches as far up as tan(angle / 2); w is the distance.
///
/// `angle` [rad] is that from the lower to the upper edge, `aspect` width over height. The third
/// row, depth, is still zero.
template <class Real>
Matrix4<double> lens(Real angle, Real aspect)
{
  const SineCosine<double> half = sine_cosine(static_cast<double>(angle) / 2);
  const double up = half.sine / half.cosine;
  Matrix4<double> m = Matrix4<double>::Zero();
  m(0, 0) = 1 / (up * static_cast<double>(aspect));
  m(1, 1) = 1 / up;
  m(3, 2) = -1;
  return m;
}

/// Whether angle and aspect make a lens: above zero, the angle below π, both finite.
template <class Real>
bool is_lens(Real angle, Real aspect)
{
  const bool opens = angle > Real(0) && static_cast<double>(angle) < std::numbers::pi;
  return opens && aspect > Real(0) && std::isfinite(aspect);
}
// [lens]

// [perspective]
/// The perspective of a lens that keeps what is from `near_plane` to `far_plane` [m] ahead; depths
/// −1…1.
///
/// Nothing unless 0 < near_plane < far_plane, all finite, and the angle is between 0 and π.
template <class Real>
std::optional<Matrix4<Real>> perspective(Real angle, Real aspect, Real near_plane, Real far_plane)
{
  if (!is_lens(angle, aspect) || !(near_plane > Real(0)) || !(far_plane > near_plane) ||
      !std::isfinite(far_plane))
  {
    return std::nullopt;
  }
  const double n = static_cast<double>(near_plane), f = static_cast<double>(far_plane);
  Matrix4<double> m = lens(angle, aspect);
  m(2, 2) = (f + n) / (n - f);
  m(2, 3) = 2 * n * (f / (n - f));
  return kept_projection<Real>(m);
}
// [perspective]

/// The same with depths 0…1, as Vulkan, Direct3D and Metal keep them.
template <class Real>
std::optional<Matrix4<Real>>
perspective_zero_to_one(Real angle, Real aspect, Real near_plane, Real far_plane)
{
  std::optional<Matrix4<Real>> m = perspective(angle, aspect, near_plane, far_plane);
  if (m)
  {
    const double n = static_cast<double>(near_plane), f = static_cast<double>(far_plane);
    (*m)(2, 2) = static_cast<Real>(f / (n - f));
    (*m)(2, 3) = static_cast<Real>(n * (f / (n - f)));
  }
  return m;
}

/// The perspective that is best in floats: depth is near_plane / distance, from 1 at `near_plane`
/// [m] to 0 at infinity; depths 0…1.
///
/// Nothing unless near_plane > 0 is finite and the angle is between 0 and π.
template <class Real>
std::optional<Matrix4<Real>> perspective_reversed(Real angle, Real aspect, Real near_plane)
{
  if (!is_lens(angle, aspect) || !(near_plane > Real(0)) || !std::isfinite(near_plane))
  {
    return std::nullopt;
  }
  Matrix4<double> m = lens(angle, aspect);
  m(2, 3) = static_cast<double>(near_plane);
  return kept_projection<Real>(m);
}

// [orthographic]
/// A projection without perspective: a block `width` by `height` [m], from `near_plane` to
/// `far_plane` [m] ahead, either of which may be behind; depths −1…1.
///
/// Nothing unless width and height are above zero, near_plane < far_plane, all finite.
template <class Real>
std::optional<Matrix4<Real>> orthographic(Real width, Real height, Real near_plane, Real far_plane)
{
  const bool sized = width > Real(0) && height > Real(0);
  if (!sized || !(near_plane < far_plane) || !std::isfinite(near_plane) ||
      !std::isfinite(far_plane))
  {
    return std::nullopt;
  }
  const double n = static_cast<double>(near_plane), f = static_cast<double>(far_plane);
  Matrix4<double> m = Matrix4<double>::Identity();
  m(0, 0) = 2 / static_cast<double>(width);
  m(1, 1) = 2 / static_cast<double>(height);
  m(2, 2) = -2 / (f - n);
  m(2, 3) = -(f + n) / (f - n);
  return kept_projection<Real>(m);
}
// [orthographic]

} // namespace cookbook
