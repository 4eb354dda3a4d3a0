#pragma once

/// \file
/// \brief Where a path first meets the solid below a plane.

#include "02_primitives/casts/cast_path.hpp"

namespace cookbook
{

// [cast_plane]
/// Where a path first meets a half-space; P8. A normal that is not of length one does as well.
template <class Real>
std::optional<Hit<Real, 3>> first_hit_on(const CastPath<Real>& path, const Plane<Real>& plane)
{
  const Real height = plane.normal.dot(path.origin) - plane.distance;
  if (height <= Real(0))
  {
    return hit_from_inside(path);
  }
  const Real approach = -plane.normal.dot(path.direction);
  return approach > Real(0) ? hit_at<Real>(path, height / approach, plane.normal) : std::nullopt;
}
// [cast_plane]

} // namespace cookbook
