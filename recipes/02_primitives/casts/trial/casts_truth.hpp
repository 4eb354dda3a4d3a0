#pragma once

/// \file
/// \brief Whether a path of whole numbers meets a shape of whole numbers, decided exactly.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace cookbook::whole
{

using Int = std::int64_t;

/// A vector of whole numbers.
struct V
{
  Int x, y, z;
};
inline V operator-(const V& a, const V& b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline V operator+(const V& a, const V& b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Int dot(const V& a, const V& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline V cross(const V& a, const V& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A ray, or a segment that ends at origin + direction.
struct Path
{
  V origin, direction;
  bool ends;
};

/// How two things lie: apart, just touching, or with more in common than that.
enum class Relation
{
  separate = -1,
  touching = 0,
  overlapping = 1
};

/// The same from a sign.
inline Relation relation_of(Int sign)
{
  return sign < 0 ? Relation::separate : sign > 0 ? Relation::overlapping : Relation::touching;
}

/// From the square of the least distance: compared with the radius.
inline Relation sphere(const Path& path, const V& center, Int radius)
{
  const V f = center - path.origin;
  const Int along = dot(f, path.direction), squared = dot(path.direction, path.direction);
  const Int start = radius * radius - dot(f, f);
  if (along <= 0 || start >= 0)
  {
    return relation_of(start);
  }
  if (path.ends && along >= squared)
  {
    const V g = f - path.direction;
    return relation_of(radius * radius - dot(g, g));
  }
  return relation_of(along * along + start * squared);
}

/// The least distance of two pieces of lines is between their ends, an end and a piece, or the feet
/// of the common perpendicular.
inline Relation capsule(const Path& path, const V& start, const V& end, Int radius)
{
  const V axis = end - start, m = cross(path.direction, axis), f = start - path.origin;
  const Path core{start, axis, true};
  Relation best = std::max(
      {sphere(core, path.origin, radius), sphere(path, start, radius), sphere(path, end, radius)});
  if (path.ends)
  {
    best = std::max(best, sphere(core, path.origin + path.direction, radius));
  }
  const Int mm = dot(m, m), t = dot(cross(f, axis), m), s = dot(cross(f, path.direction), m);
  if (mm > 0 && t >= 0 && s >= 0 && s <= mm && (!path.ends || t <= mm))
  {
    best = std::max(best, relation_of(radius * radius * mm - dot(f, m) * dot(f, m)));
  }
  return best;
}

/// From s(p) = n·p − d at the ends.
inline Relation plane(const Path& path, const V& n, Int d)
{
  const Int start = d - dot(n, path.origin), approach = -dot(n, path.direction);
  if (path.ends)
  {
    return relation_of(std::max(start, start + approach));
  }
  return approach > 0 ? Relation::overlapping : relation_of(start);
}

/// How far the projections of a path and of corners overlap on an axis: as a sign.
inline Int projection_overlap(const Path& path, const std::vector<V>& corners, const V& axis)
{
  constexpr Int endless = std::numeric_limits<Int>::max() / 4;
  const Int start = dot(axis, path.origin), step = dot(axis, path.direction);
  const Int end = path.ends ? start + step : step > 0 ? endless : step < 0 ? -endless : start;
  Int least = endless, most = -endless;
  for (const V& corner : corners)
  {
    least = std::min(least, dot(axis, corner));
    most = std::max(most, dot(axis, corner));
  }
  return std::min(most - std::min(start, end), std::max(start, end) - least);
}

/// By separating axes: whatever can separate a path from corners, flat or not, is among them.
inline Relation corners(const Path& path, const std::vector<V>& all)
{
  const V& d = path.direction;
  std::vector<V> edges;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      edges.push_back(all[i] - all[j]);
    }
  }
  Int least = std::numeric_limits<Int>::max();
  const auto ask = [&](const V& axis)
  {
    if (dot(axis, axis) != 0)
    {
      least = std::min(least, projection_overlap(path, all, axis));
    }
  };
  const V f = all[0] - path.origin;
  ask(f), ask(d), ask(cross(cross(d, f), d));
  for (const V& e : edges)
  {
    const V m = cross(d, e), g = cross(f, e);
    ask(e), ask(m), ask(cross(m, d)), ask(cross(m, e)), ask(cross(g, e));
    for (const V& other : edges)
    {
      const V n = cross(e, other);
      ask(n), ask(cross(n, e)), ask(cross(n, d));
    }
  }
  return relation_of(least);
}

/// The same of a box along the axes: its three, and those perpendicular to one of them and the
/// path.
inline Relation box(const Path& path, const V& min, const V& max)
{
  std::vector<V> all;
  for (int i = 0; i < 8; ++i)
  {
    all.push_back({i & 1 ? min.x : max.x, i & 2 ? min.y : max.y, i & 4 ? min.z : max.z});
  }
  Int least = std::numeric_limits<Int>::max();
  for (const V& e : {V{1, 0, 0}, V{0, 1, 0}, V{0, 0, 1}})
  {
    const V m = cross(path.direction, e);
    least = std::min(least, projection_overlap(path, all, e));
    least = dot(m, m) == 0 ? least : std::min(least, projection_overlap(path, all, m));
  }
  return relation_of(least);
}

} // namespace cookbook::whole
