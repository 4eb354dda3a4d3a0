#pragma once

/// \file
/// \brief Points and triangles, pairs of segments, their exact distances, and ways to find them.

#include "02_primitives/closest_points/closest_points.hpp"
#include "02_primitives/closest_segments/closest_segments.hpp"
#include "02_primitives/meshes/triangle_closest.hpp"
#include "02_primitives/shapes/trial/number_draw.hpp"
#include "common/exact/exact.hpp"
#include "common/measure/statistics.hpp"

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
    const Reference squared = way_to_triangle(exactly, exact<Reference>(p)).squaredNorm();
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
    const Reference squared = closest_shares(exactly(a), exactly(b)).way.squaredNorm();
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
/// The point of a triangle closest to p, as textbooks have it: the region of a corner, of an edge,
/// or of the face in which p lies, told by six dot products.
inline Vector3<float> closest_by_regions(const Vector3<float>& p, const Triangle<float>& t)
{
  const Vector3<float> ab = t.b - t.a, ac = t.c - t.a;
  const Vector3<float> from_a = p - t.a, from_b = p - t.b, from_c = p - t.c;
  const float ab_a = ab.dot(from_a), ac_a = ac.dot(from_a);
  const float ab_b = ab.dot(from_b), ac_b = ac.dot(from_b);
  const float ab_c = ab.dot(from_c), ac_c = ac.dot(from_c);
  const float of_a = ab_b * ac_c - ab_c * ac_b;
  const float of_b = ab_c * ac_a - ab_a * ac_c;
  const float of_c = ab_a * ac_b - ab_b * ac_a;
  if (ab_a <= 0 && ac_a <= 0)
  {
    return t.a;
  }
  if (ab_b >= 0 && ac_b <= ab_b)
  {
    return t.b;
  }
  if (ac_c >= 0 && ab_c <= ac_c)
  {
    return t.c;
  }
  if (of_c <= 0 && ab_a >= 0 && ab_b <= 0)
  {
    return t.a + ab_a / (ab_a - ab_b) * ab;
  }
  if (of_b <= 0 && ac_a >= 0 && ac_c <= 0)
  {
    return t.a + ac_a / (ac_a - ac_c) * ac;
  }
  const float up = ac_b - ab_b, down = ab_c - ac_c;
  if (of_a <= 0 && up >= 0 && down >= 0)
  {
    return t.b + up / (up + down) * (t.c - t.b);
  }
  const float whole = of_a + of_b + of_c;
  return t.a + of_b / whole * ab + of_c / whole * ac;
}

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
[[gnu::flatten]] inline float float_shares(const Vector3<float>& p, const Triangle<float>& t)
{
  const Vector3<float> corners[] = {t.a - p, t.b - p, t.c - p};
  return nearest_on_triangle(corners, 0, 1, 2).point.norm();
}

/// How wrong a way's distances are [m].
template <class Known, class Way>
measure::ErrorStatistics distance_errors(const Way& way, const std::vector<Known>& all)
{
  std::vector<double> errors;
  for (const Known& one : all)
  {
    errors.push_back(std::abs(static_cast<double>(way(one.a, one.b)) - one.distance));
  }
  return measure::error_statistics(errors);
}

} // namespace cookbook
