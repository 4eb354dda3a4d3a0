#pragma once

/// \file
/// \brief The one point of three planes.

#include "02_primitives/shapes/shapes.hpp"
#include "common/math/wide.hpp"

#include <optional>

namespace cookbook
{

// [three_planes]
/// The point of three planes, or nothing where they have none, or more than one; P15.
///
/// Nothing, too, where rounding may have made up the volume of the normals.
template <class Real>
std::optional<Vector3<Real>>
point_of_planes(const Plane<Real>& a, const Plane<Real>& b, const Plane<Real>& c)
{
  using W = Wide<Real>;
  const Vector3<W> n_a = widen(a.normal), n_b = widen(b.normal), n_c = widen(c.normal);
  const Vector3<W> b_c = n_b.cross(n_c);
  const W volume = n_a.dot(b_c);
  const W most = n_a.norm() * n_b.norm() * n_c.norm();
  const W rounding = W(8) * Eigen::NumTraits<W>::epsilon() * most;
  if (!(volume > rounding) && !(volume < -rounding))
  {
    return std::nullopt;
  }
  const Vector3<W> sum =
      W(a.distance) * b_c + W(b.distance) * n_c.cross(n_a) + W(c.distance) * n_a.cross(n_b);
  return Vector3<Real>((sum / volume).template cast<Real>());
}
// [three_planes]

} // namespace cookbook
