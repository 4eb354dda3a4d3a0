#pragma once

/// \file
/// \brief What all methods for two boxes share: which of two nearly equal answers is taken, and
/// where lines meet.

#include "common/math/vector.hpp"

#include <algorithm>

namespace cookbook
{

// [preferences]
/// Faces of two boxes are nearly parallel if the cosine of their angle is more than one degree's.
inline constexpr float parallel_cosine = 0.99985f;

/// The contact margin [m] of two boxes, from the sums of their half extents.
template <class Real>
Real contact_margin(const Real& sum_a, const Real& sum_b)
{
  using std::min;
  return min(sum_a, sum_b) * Real(0.01f);
}

/// How much less [m] than nearly parallel faces an edge axis must overlap to be taken; O19.
template <class Real>
Real face_preference(const Real& face_depth, const Real& margin)
{
  using std::max;
  return max(face_depth * Real(0.05f), margin * Real(0.5f));
}

/// The separation [m] up to which a corner over a face is kept as a contact point; O20.
template <class Real>
Real kept_separation(const Real& depth, const Real& margin, const Real& tolerance)
{
  using std::max, std::min;
  return min(margin, max(depth, tolerance));
}
// [preferences]

// [lines]
/// Where a segment meets a plane that its ends are at signed distances g_0 and g_1 from; O11.
template <class Real>
Vector3<Real> point_at_plane(const Vector3<Real>& x_0, const Vector3<Real>& x_1, Real g_0, Real g_1)
{
  return x_0 + (x_1 - x_0) * (g_0 / (g_0 - g_1));
}

/// How far [m] along e_A a line is closest to one along e_B that starts at q from its start; O13.
template <class Real>
Real closest_on_line(const Vector3<Real>& q, const Vector3<Real>& e_a, const Vector3<Real>& e_b)
{
  const Vector3<Real> across = e_a.cross(e_b);
  return q.cross(e_b).dot(across) / across.squaredNorm();
}
// [lines]

} // namespace cookbook
