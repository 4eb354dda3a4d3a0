#pragma once

/// \file
/// \brief Points and triangles, pairs of segments, their exact distances, and ways to find them.

#include "02_primitives/closest_points/closest_points.hpp"
#include "02_primitives/closest_segments/closest_segments.hpp"
#include "02_primitives/meshes/triangle_closest.hpp"
#include "02_primitives/shapes/trial/number_draw.hpp"
#include "tools/exact/exact.hpp"
#include "tools/measure/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cookbook
{

// [known_distances]
/// Two shapes, and how far apart they are.
template <class A, class B>
struct KnownDistance
{
  A a;
  B b;
  double distance; ///< [m], with a hundred digits, rounded once
};

using PointTriangle = KnownDistance<Vector3<float>, Triangle<float>>;
template <class Real>
using TwoSegments = KnownDistance<Segment<Real>, Segment<Real>>;

/// Points and triangles; every eighth triangle is thinner than a ten-thousandth of its length.
inline std::vector<PointTriangle> known_triangles_and_points(int count)
{
  FloatDraw draw(20261122);
  std::vector<PointTriangle> all;
  for (int i = 0; i < count; ++i)
  {
    const Vector3<float> p = draw.in_cube(1), a = draw.in_cube(1), b = draw.in_cube(1),
                         c = draw.in_cube(1);
    const Triangle<float> t{a, b, i % 8 == 0 ? Vector3<float>((a + b) / 2 + 1e-4f * c) : c};
    const Triangle<Reference> exactly{
        exact<Reference>(t.a), exact<Reference>(t.b), exact<Reference>(t.c)};
    const Reference squared = vector_to_triangle(exactly, exact<Reference>(p)).squaredNorm();
    all.push_back({p, t, static_cast<double>(Reference(sqrt(squared)))});
  }
  return all;
}

/// Pairs of segments; every eighth are parallel but for a ten-thousandth.
inline std::vector<TwoSegments<float>> known_segments(int count)
{
  FloatDraw draw(20261122);
  std::vector<TwoSegments<float>> all;
  for (int i = 0; i < count; ++i)
  {
    const Segment<float> a{draw.in_cube(1), draw.in_cube(1)};
    const Vector3<float> start = draw.in_cube(1), end = draw.in_cube(1);
    const Vector3<float> along = a.end - a.start + 1e-4f * end;
    const Segment<float> b{start, i % 8 == 0 ? Vector3<float>(start + along) : end};
    const auto exactly = [](const Segment<float>& s) {
      return Segment<Reference>{exact<Reference>(s.start), exact<Reference>(s.end)};
    };
    const Reference squared = closest_fractions(exactly(a), exactly(b)).difference.squaredNorm();
    all.push_back({a, b, static_cast<double>(Reference(sqrt(squared)))});
  }
  return all;
}

/// The same pairs of segments in double.
inline std::vector<TwoSegments<double>> in_double(const std::vector<TwoSegments<float>>& all)
{
  const auto wide = [](const Segment<float>& s) {
    return Segment<double>{widen(s.start), widen(s.end)};
  };
  std::vector<TwoSegments<double>> same;
  for (const TwoSegments<float>& pair : all)
  {
    same.push_back({wide(pair.a), wide(pair.b), pair.distance});
  }
  return same;
}
// [known_distances]

// [taught_ways]
/// How far two segments are apart, as textbooks have it: five dot products, then the clamps.
inline float distance_by_dot_products(const Segment<float>& one, const Segment<float>& other)
{
  const Vector3<float> along = one.end - one.start, across = other.end - other.start;
  const Vector3<float> r = one.start - other.start;
  const float a = along.squaredNorm(), e = across.squaredNorm(), b = along.dot(across);
  const float c = along.dot(r), f = across.dot(r), denominator = a * e - b * b;
  float s = denominator > 0 ? std::clamp((b * f - c * e) / denominator, 0.0f, 1.0f) : 0.0f;
  const float t = std::clamp((b * s + f) / e, 0.0f, 1.0f);
  s = std::clamp((b * t - c) / a, 0.0f, 1.0f);
  return (r + s * along - t * across).norm();
}
// [taught_ways]

/// How far a point is from a triangle by P13, in float alone.
[[gnu::flatten]] inline float distance_in_float(const Vector3<float>& p, const Triangle<float>& t)
{
  return nearest_by_region<float>(t.a - p, t.b - p, t.c - p).point.norm();
}

/// How wrong a way's distances are [m].
template <class Known, class Method>
measure::ErrorStatistics distance_errors(const Method& method, const std::vector<Known>& all)
{
  std::vector<double> errors;
  for (const Known& one : all)
  {
    errors.push_back(std::abs(static_cast<double>(method(one.a, one.b)) - one.distance));
  }
  return measure::error_statistics(errors);
}

} // namespace cookbook
