#pragma once

/// \file
/// \brief Closest points of a triangle and of two segments: the formulas as they stand, for a room.

#include "02_primitives/plain_points/plain_points.hpp"
#include "02_primitives/shapes/answers.hpp"

#include <array>

namespace cookbook
{

// [barycentric]
/// The barycentric coordinates of the foot of a point in the plane of a triangle; P11.
template <class Real>
Vector3<Real> barycentric(const Triangle<Real>& triangle, const Vector3<Real>& p)
{
  const Vector3<Real> a = triangle.a - p, b = triangle.b - p, c = triangle.c - p;
  const Vector3<Real> n = (b - a).cross(c - a);
  return Vector3<Real>(n.dot(b.cross(c)), n.dot(c.cross(a)), n.dot(a.cross(b))) / n.squaredNorm();
}
// [barycentric]

// [closest_on_triangle]
/// The point of a triangle that is closest to a point, both [m], world; P13.
template <class Real>
Vector3<Real> closest_on_triangle(const Triangle<Real>& triangle, const Vector3<Real>& p)
{
  const auto& [a, b, c] = triangle;
  const Vector3<Real> weights = barycentric(triangle, p);
  if (weights.minCoeff() > Real(0))
  {
    return weights.x() * a + weights.y() * b + weights.z() * c;
  }
  const std::array<Segment<Real>, 3> edges{{{a, b}, {b, c}, {c, a}}};
  Vector3<Real> closest = a;
  for (const Segment<Real>& edge : edges)
  {
    const Vector3<Real> x = closest_point(edge, p);
    closest = (x - p).squaredNorm() < (closest - p).squaredNorm() ? x : closest;
  }
  return closest;
}
// [closest_on_triangle]

// [closest_on_segments]
/// A point of each of two segments, none closer to each other, and their distance [m]; P14.
template <class Real>
ClosestPoints<Real, 3> closest_on_segments(const Segment<Real>& a, const Segment<Real>& b)
{
  const Vector3<Real> along_a = a.end - a.start, along_b = b.end - b.start;
  const Vector3<Real> r = b.start - a.start, n = along_a.cross(along_b);
  const Real n_n = n.squaredNorm();
  const Real s = n_n > Real(0) ? Real(r.cross(along_b).dot(n) / n_n) : Real(0); // 0: parallel
  const Vector3<Real> start = a.start + std::clamp(s, Real(0), Real(1)) * along_a;
  const Vector3<Real> on_b = closest_point(b, start);
  const Vector3<Real> on_a = closest_point(a, on_b);
  return {on_a, on_b, (on_b - on_a).norm()};
}
// [closest_on_segments]

} // namespace cookbook
