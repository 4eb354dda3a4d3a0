#pragma once

/// \file
/// \brief Ways to cast a ray as they are published and taught, in our own words.

#include "02_primitives/shapes/more_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace cookbook
{

// [sphere_as_published]
/// Our model of published code, X29 and X30: the square of the distance from the line is a small
/// difference of large squares, and whether the ball is ahead is not asked.
inline std::optional<float> sphere_as_published(const Ray<float>& ray, const Sphere<float>& ball)
{
  const Vector3<float> e = ball.center - ray.origin;
  const float e_squared = e.squaredNorm(), a = e.dot(ray.direction);
  const float r_squared = ball.radius * ball.radius;
  const float chord = r_squared - (e_squared - a * a);
  if (chord < 0)
  {
    return std::nullopt;
  }
  return e_squared < r_squared ? a + std::sqrt(chord) : a - std::sqrt(chord);
}
// [sphere_as_published]

/// The quadratic equation as it is taught, in float: the smaller root that is not negative.
inline std::optional<float> sphere_quadratic(const Ray<float>& ray, const Sphere<float>& ball)
{
  const Vector3<float> e = ray.origin - ball.center;
  const float a = ray.direction.squaredNorm(), b = e.dot(ray.direction);
  const float c = e.squaredNorm() - ball.radius * ball.radius, d = b * b - a * c;
  if (d < 0 || a == 0)
  {
    return std::nullopt;
  }
  const float first = (-b - std::sqrt(d)) / a, last = (-b + std::sqrt(d)) / a;
  return last < 0 ? std::nullopt : std::optional(first < 0 ? last : first);
}

// [box_as_published]
/// Our model of published code, X31: a component that is zero is taken for 1e-5.
inline std::optional<float> box_as_published(const Ray<float>& ray, const Aabb<float>& box)
{
  float enter = -std::numeric_limits<float>::max(), leave = -enter;
  for (int i = 0; i < 3; ++i)
  {
    const float direction = ray.direction[i] == 0 ? 1e-5f : ray.direction[i];
    const float p = (box.min()[i] - ray.origin[i]) / direction,
                q = (box.max()[i] - ray.origin[i]) / direction;
    enter = std::max(enter, std::min(p, q));
    leave = std::min(leave, std::max(p, q));
  }
  if (leave < 0 || enter > leave)
  {
    return std::nullopt;
  }
  return enter < 0 ? leave : enter;
}
// [box_as_published]

/// Slabs by the inverse of the direction: 1/0 is infinite, which is right, but 0 times that is not.
inline std::optional<float> box_by_inverse(const Ray<float>& ray, const Aabb<float>& box)
{
  const Vector3<float> inverse = ray.direction.cwiseInverse();
  float enter = -std::numeric_limits<float>::infinity(), leave = -enter;
  for (int i = 0; i < 3; ++i)
  {
    const float p = (box.min()[i] - ray.origin[i]) * inverse[i];
    const float q = (box.max()[i] - ray.origin[i]) * inverse[i];
    enter = std::max(enter, std::min(p, q));
    leave = std::min(leave, std::max(p, q));
  }
  return leave < std::max(enter, 0.0f) ? std::nullopt : std::optional(enter < 0 ? leave : enter);
}

/// Our model of published code: the plane, if it faces the ray, and then barycentric coordinates of
/// the point that was found.
inline std::optional<float>
triangle_as_published(const Ray<float>& ray, const Triangle<float>& triangle)
{
  const Vector3<float> ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
  const Vector3<float> n = ab.cross(ac).normalized();
  const float approach = -n.dot(ray.direction), height = n.dot(ray.origin - triangle.a);
  if (!(approach > 0) || height < 0)
  {
    return std::nullopt;
  }
  const float t = height / approach;
  const Vector3<float> ap = ray.origin + t * ray.direction - triangle.a;
  const float bb = ab.dot(ab), bc = ab.dot(ac), cc = ac.dot(ac), pb = ap.dot(ab), pc = ap.dot(ac);
  const float all = bb * cc - bc * bc;
  const float v = (cc * pb - bc * pc) / all, w = (bb * pc - bc * pb) / all;
  return v >= 0 && w >= 0 && v + w <= 1 ? std::optional(t) : std::nullopt;
}

// [moller_trumbore]
/// Möller and Trumbore's way with the threshold of the paper: three unknowns t, u, w by Cramer's
/// rule; P12.
template <class Real>
std::optional<Real>
moller_trumbore(const Ray<Real>& ray, const Triangle<Real>& triangle, Real threshold = Real(1e-6))
{
  const Vector3<Real> e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
  const Vector3<Real> m = ray.direction.cross(e2);
  const Real determinant = e1.dot(m);
  if (std::abs(determinant) < threshold)
  {
    return std::nullopt;
  }
  const Vector3<Real> s = ray.origin - triangle.a, k = s.cross(e1);
  const Real u = s.dot(m) / determinant, w = ray.direction.dot(k) / determinant;
  const Real t = e2.dot(k) / determinant;
  const bool inside = u >= Real(0) && w >= Real(0) && u + w <= Real(1) && t >= Real(0);
  return inside ? std::optional(t) : std::nullopt;
}
// [moller_trumbore]

} // namespace cookbook
