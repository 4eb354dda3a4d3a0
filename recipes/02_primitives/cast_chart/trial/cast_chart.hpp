#pragma once

/// \file
/// \brief Rays that meet balls, boxes and triangles, where exactly they do, and ways to find out.

#include "02_primitives/casts/casts.hpp"
#include "02_primitives/casts/trial/casts_pitfalls.hpp"
#include "02_primitives/shapes/trial/number_draw.hpp"
#include "tools/exact/exact.hpp"
#include "tools/measure/statistics.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace cookbook
{

/// A ray, a shape that it meets, and where.
template <class Shape>
struct KnownCast
{
  Ray<float> ray;
  Shape shape;
  double t; ///< exact, rounded once
};

/// Draws rays and shapes.
class CastDraw : public FloatDraw
{
public:
  CastDraw() : FloatDraw(20260501) {}

  Vector3<float> unit() { return (in_cube(1) + Vector3<float>(2, 0, 0)).normalized(); }
  float distance() { return std::pow(10.0f, between(0.5f, 4)); } ///< from 3 m to 10 km
};

/// The exact t at which a ray meets a sphere, with 100 digits.
inline double exact_t(const Ray<float>& ray, const Sphere<float>& ball)
{
  const Vector3<Reference> f = exact<Reference>(ball.center) - exact<Reference>(ray.origin);
  const Vector3<Reference> d = exact<Reference>(ray.direction);
  const Reference a = d.dot(d), b = f.dot(d), r = ball.radius;
  return static_cast<double>((b - sqrt(Reference(b * b - a * (f.dot(f) - r * r)))) / a);
}

/// The exact t at which a ray enters a box, as a fraction.
inline double exact_t(const Ray<float>& ray, const Aabb<float>& box)
{
  Rational enter = -1;
  for (int i = 0; i < 3; ++i)
  {
    const Rational face = ray.direction[i] > 0 ? box.min()[i] : box.max()[i];
    const Rational in = (face - Rational(ray.origin[i])) / Rational(ray.direction[i]);
    enter = in > enter ? in : enter;
  }
  return static_cast<double>(enter);
}

/// The t at which a ray meets a triangle, as a fraction; nothing where it does not. P12.
inline std::optional<Rational>
cast_in_fractions(const Ray<float>& ray, const Triangle<float>& triangle)
{
  using V = Vector3<Rational>;
  const V a = exact<Rational>(triangle.a), e1 = exact<Rational>(triangle.b) - a;
  const V e2 = exact<Rational>(triangle.c) - a, d = exact<Rational>(ray.direction);
  const V s = exact<Rational>(ray.origin) - a, p = d.cross(e2), q = s.cross(e1);
  const Rational determinant = e1.dot(p);
  if (determinant == 0)
  {
    return std::nullopt;
  }
  const Rational u = s.dot(p) / determinant, v = d.dot(q) / determinant;
  const Rational t = e2.dot(q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 ? std::optional(t) : std::nullopt;
}

// [known_casts]
/// Balls of 1 m, passed at up to 0.95 m from the centre.
inline std::vector<KnownCast<Sphere<float>>> known_spheres(int count)
{
  CastDraw draw;
  std::vector<KnownCast<Sphere<float>>> all;
  for (int i = 0; i < count; ++i)
  {
    const Vector3<float> d = draw.unit(), origin = draw.in_cube(1);
    const Vector3<float> aside = d.cross(draw.in_cube(1)).normalized();
    const float off = draw.between(0, 0.95f);
    const Sphere<float> ball{origin + draw.distance() * d + off * aside, 1};
    all.push_back({{origin, d}, ball, exact_t({origin, d}, ball)});
  }
  return all;
}

/// Boxes of up to 2 m, aimed at some point within them.
inline std::vector<KnownCast<Aabb<float>>> known_boxes(int count)
{
  CastDraw draw;
  std::vector<KnownCast<Aabb<float>>> all;
  for (int i = 0; i < count; ++i)
  {
    const Vector3<float> d = draw.unit(), origin = draw.in_cube(1);
    const Vector3<float> half = draw.in_cube(0.4f) + Vector3<float>::Constant(0.6f);
    const float distance = draw.distance();
    const Vector3<float> center = origin + distance * d + 0.9f * draw.in_cube(0.2f);
    const Aabb<float> box(Vector3<float>(center - half), Vector3<float>(center + half));
    all.push_back({{origin, d}, box, exact_t({origin, d}, box)});
  }
  return all;
}

/// Triangles of some metres, aimed at some point well within them.
inline std::vector<KnownCast<Triangle<float>>> known_triangles(int count)
{
  CastDraw draw;
  std::vector<KnownCast<Triangle<float>>> all;
  while (static_cast<int>(all.size()) < count)
  {
    const Vector3<float> d = draw.unit(), origin = draw.in_cube(1);
    const Vector3<float> at = origin + draw.distance() * d;
    const Vector3<float> e = draw.in_cube(2), f = draw.in_cube(2);
    const float u = draw.between(0.1f, 0.5f), v = draw.between(0.1f, 0.4f);
    const Triangle<float> triangle{
        at - u * e - v * f, at + (1 - u) * e - v * f, at - u * e + (1 - v) * f};
    const std::optional<Rational> t = cast_in_fractions({origin, d}, triangle);
    if (t)
    {
      all.push_back({{origin, d}, triangle, static_cast<double>(*t)});
    }
  }
  return all;
}
// [known_casts]

// [cast_ways]
/// A way to cast at a shape, by its name on the chart.
template <class Shape>
struct CastColumn
{
  std::string name;
  std::function<std::optional<float>(const Ray<float>&, const Shape&)> t;
};

/// What the recommended way does, in float alone.
template <class Shape>
std::optional<float> cast_in_float(const Ray<float>& ray, const Shape& shape)
{
  const auto hit = first_hit_on(CastPath<float>{ray.origin, ray.direction, false}, shape);
  return hit ? std::optional(hit->t) : std::nullopt;
}

/// How wrong a way is, as a part of t: infinite where it misses.
template <class Shape, class Method>
measure::ErrorStatistics
cast_errors(const Method& method, const std::vector<KnownCast<Shape>>& casts)
{
  std::vector<double> errors;
  for (const KnownCast<Shape>& one : casts)
  {
    const std::optional<float> t = method(one.ray, one.shape);
    errors.push_back(t ? std::abs(*t - one.t) / one.t : std::numeric_limits<double>::infinity());
  }
  return measure::error_statistics(errors);
}
// [cast_ways]

} // namespace cookbook
