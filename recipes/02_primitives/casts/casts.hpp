#pragma once

/// \file
/// \brief Where a ray or a segment first meets a shape.

#include "02_primitives/casts/cast_box.hpp"
#include "02_primitives/casts/cast_plane.hpp"
#include "02_primitives/casts/cast_sphere.hpp"
#include "02_primitives/casts/cast_tetrahedron.hpp"
#include "02_primitives/casts/cast_triangle.hpp"

#include <algorithm>

namespace cookbook
{

// [with_lengths]
/// A shape with `of` applied to everything in it that is a length [m]; the rest is widened.
template <class Real, class Of>
Plane<Wide<Real>> with_lengths(const Plane<Real>& s, const Of& of)
{
  return {widen(s.normal), of(s.distance)};
}
template <class Real, class Of>
Sphere<Wide<Real>> with_lengths(const Sphere<Real>& s, const Of& of)
{
  return {of(s.center), of(s.radius)};
}
template <class Real, class Of>
Capsule<Wide<Real>> with_lengths(const Capsule<Real>& s, const Of& of)
{
  return {{of(s.segment.start), of(s.segment.end)}, of(s.radius)};
}
template <class Real, class Of>
Aabb<Wide<Real>> with_lengths(const Aabb<Real>& s, const Of& of)
{
  return {of(s.min()), of(s.max())};
}
template <class Real, class Of>
Obb<Wide<Real>> with_lengths(const Obb<Real>& s, const Of& of)
{
  return {of(s.center), widen(s.axes), of(s.half_extents)};
}
template <class Real, class Of>
Triangle<Wide<Real>> with_lengths(const Triangle<Real>& s, const Of& of)
{
  return {of(s.a), of(s.b), of(s.c)};
}
template <class Real, class Of>
Tetrahedron<Wide<Real>> with_lengths(const Tetrahedron<Real>& s, const Of& of)
{
  return {of(s.a), of(s.b), of(s.c), of(s.d)};
}
// [with_lengths]

// [length_maps]
/// Widens a length or a point, and divides it by 2^`exponent`.
template <class Real>
struct Shrink
{
  int exponent = 0; ///< of the power of two

  /// A length.
  Wide<Real> operator()(const Real& x) const
  {
    return exponent == 0 ? Wide<Real>(x) : std::ldexp(Wide<Real>(x), -exponent);
  }
  /// A point.
  Vector3<Wide<Real>> operator()(const Vector3<Real>& p) const
  {
    return {(*this)(p.x()), (*this)(p.y()), (*this)(p.z())};
  }
};

/// Keeps the largest of all lengths and coordinates, without sign.
template <class Real>
struct Largest
{
  Real& most; ///< of all so far

  /// A length.
  Wide<Real> operator()(const Real& x) const
  {
    most = std::max(most, std::abs(x));
    return x;
  }
  /// A point.
  Vector3<Wide<Real>> operator()(const Vector3<Real>& p) const
  {
    most = std::max(most, p.cwiseAbs().maxCoeff());
    return widen(p);
  }
};

/// The exponent of a number so large or small that products of six such would leave the range of
/// its type; 0 of all other numbers.
template <class Real>
int far_exponent(const Real& x)
{
  const int sixth = std::numeric_limits<Real>::max_exponent / 6;
  const bool plain = x >= std::ldexp(Real(1), -sixth) && x <= std::ldexp(Real(1), sixth);
  return plain || !(x > Real(0)) || !std::isfinite(x) ? 0 : std::ilogb(x);
}

/// The power of two to take out of a shape and two points; 0 of floats, which are widened.
template <class Real, class Shape>
int exponent_of_all(const Shape& shape, const Vector3<Real>& p, const Vector3<Real>& q)
{
  if constexpr (std::is_same_v<Real, Wide<Real>>)
  {
    Real most(0);
    const Largest<Real> largest{most};
    largest(p), largest(q), with_lengths(shape, largest);
    return far_exponent(most);
  }
  return 0;
}
// [length_maps]

// [cast]
/// What a ray or a segment can be cast against: all shapes that have a size.
template <class Real, class Shape>
concept CastTarget = requires(const Shape& shape)
{
  with_lengths(shape, Shrink<Real>{});
};

/// Casts a path against a shape of its size, and gives the hit in the caller's numbers.
template <class Real, class Shape>
std::optional<Hit<Real, 3>> cast_along(CastPath<Wide<Real>> path, const Shape& shape)
{
  const bool may_be_far = std::is_same_v<Real, Wide<Real>>;
  const int speed = may_be_far ? far_exponent<Wide<Real>>(path.direction.cwiseAbs().maxCoeff()) : 0;
  if (speed != 0)
  {
    path.direction = Shrink<Wide<Real>>{speed}(path.direction);
    path.time -= speed;
  }
  const std::optional<Hit<Wide<Real>, 3>> hit = first_hit_on(path, shape);
  if (!hit)
  {
    return std::nullopt;
  }
  const Wide<Real> t = Shrink<Wide<Real>>{-path.time}(hit->t);
  const Vector3<Wide<Real>> point = Shrink<Wide<Real>>{-path.size}(hit->point);
  return Hit<Real, 3>{
      static_cast<Real>(t), point.template cast<Real>(), hit->normal.template cast<Real>()};
}

/// Where a ray first meets a shape; nothing where it does not. Touching counts.
///
/// Shapes are solid: from inside and from the surface, also where the ray leaves it, t is 0, and
/// the normal is against the direction. To leave a surface, start a little outside of it. A
/// triangle is met from both sides. A zero direction meets only what holds the origin, with the
/// normal +y. Costs 3 to 4 times as much as ray_sphere(), 2 to 7 times as much as ray_triangle().
template <class Real, class Shape>
requires CastTarget<Real, Shape>
[[gnu::flatten]] std::optional<Hit<Real, 3>> cast(const Ray<Real>& ray, const Shape& shape)
{
  const int size = exponent_of_all<Real>(shape, ray.origin, ray.origin);
  const Shrink<Real> shrink{size};
  return cast_along<Real>(
      {shrink(ray.origin), widen(ray.direction), false, size, size}, with_lengths(shape, shrink));
}

/// Where a segment first meets a shape, on its way from start to end; t is from 0 to 1.
template <class Real, class Shape>
requires CastTarget<Real, Shape>
[[gnu::flatten]] std::optional<Hit<Real, 3>> cast(const Segment<Real>& segment, const Shape& shape)
{
  const int size = exponent_of_all<Real>(shape, segment.start, segment.end);
  const Shrink<Real> shrink{size};
  const Vector3<Wide<Real>> start = shrink(segment.start), direction = shrink(segment.end) - start;
  return cast_along<Real>({start, direction, true, size, 0}, with_lengths(shape, shrink));
}
// [cast]

} // namespace cookbook
