#pragma once

/// \file
/// \brief Ways to cast a ray, by name, and whether their answers are right.

#include "02_primitives/casts/casts.hpp"
#include "02_primitives/casts/trial/casts_pitfalls.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to cast at each shape, by name: t, or nothing.
struct CastMethod
{
  std::string name; ///< as on the page
  std::optional<float> (*sphere)(const Ray<float>&, const Sphere<float>&);
  std::optional<float> (*box)(const Ray<float>&, const Aabb<float>&);
  std::optional<float> (*triangle)(const Ray<float>&, const Triangle<float>&);
  bool nearest; ///< of many triangles, whether the nearest counts, or the first that is met
};

/// The t of a cast.
template <class Shape>
std::optional<float> cast_t(const Ray<float>& ray, const Shape& shape)
{
  const std::optional<Hit<float, 3>> hit = cast(ray, shape);
  return hit ? std::optional(hit->t) : std::nullopt;
}

/// The ways that compete, the recommended one last.
inline std::array<CastMethod, 3> cast_methods()
{
  return {
      {{"as published", sphere_as_published, box_as_published, triangle_as_published, false},
       {"as taught", sphere_quadratic, box_by_inverse,
        [](const Ray<float>& ray, const Triangle<float>& triangle)
        { return moller_trumbore(ray, triangle); },
        true},
       {"recommended", cast_t<Sphere<float>>, cast_t<Aabb<float>>, cast_t<Triangle<float>>, true}}};
}

/// A ray seen from an oriented box.
inline Ray<float> seen_from_box(const Ray<float>& ray, const Obb<float>& box)
{
  const Matrix3<float> back = box.axes.transpose();
  return {back * (ray.origin - box.center), back * ray.direction};
}

/// The first, or the nearest, of many triangles.
inline std::optional<float> cast_at_many(
    const CastMethod& method, const Ray<float>& ray, const std::vector<Triangle<float>>& triangles)
{
  std::optional<float> best;
  for (const Triangle<float>& triangle : triangles)
  {
    const std::optional<float> t = method.triangle(ray, triangle);
    best = t && (!best || *t < *best) ? t : best;
    if (best && !method.nearest)
    {
      return best;
    }
  }
  return best;
}

/// The t of an answer as a table shows it: to a tenth where it is large.
inline std::string t_text(const std::optional<float>& t)
{
  if (t && *t > 1000)
  {
    const long tenths = std::lround(10 * *t);
    return "t = " + std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
  }
  return t ? "t = " + number(*t) : "misses";
}

/// Right if the answer is as expected, to a part of a hundred thousand.
inline Verdict cast_verdict(const std::optional<float>& t, const std::optional<double>& expected)
{
  if (!t || !expected)
  {
    return {!t && !expected, t_text(t)};
  }
  const double tolerance = 1e-5 * *expected * (*expected > 1000 ? 0.01 : 1);
  return {std::abs(*t - *expected) <= tolerance, t_text(t)};
}

// [quad_diagonal]
/// Rays from above at the diagonal that two triangles share: right if none gets through.
inline Verdict quad_verdict(const CastMethod& method)
{
  const Vector3<float> corners[] = {
      {-3.1f, 0.2f, -2.7f}, {2.9f, 0.4f, -3.3f}, {3.3f, -0.1f, 2.8f}, {-2.6f, 0.3f, 3.2f}};
  const std::vector<Triangle<float>> quad{
      {corners[0], corners[2], corners[1]}, {corners[0], corners[3], corners[2]}};
  std::mt19937 random(1);
  const auto fraction = [&] { return static_cast<float>(random() % 65536) / 65536; };
  int through = 0;
  for (int i = 0; i < 1'000'000; ++i)
  {
    const Vector3<float> at = corners[0] + (0.1f + 0.8f * fraction()) * (corners[2] - corners[0]);
    const Vector3<float> origin(fraction() - 0.5f, 5 + fraction(), fraction() - 0.5f);
    through += cast_at_many(method, {origin, at - origin}, quad) ? 0 : 1;
  }
  return {through == 0, through == 0 ? "all are stopped" : "some get through"};
}
// [quad_diagonal]

} // namespace cookbook
