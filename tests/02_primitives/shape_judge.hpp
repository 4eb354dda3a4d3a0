/// \file
/// Random shapes of every kind, and a judge of closest points that shares no code with the book's:
/// it knows what lies in a shape and how far the shape reaches, in long double.
#pragma once

#include "02_primitives/shapes/answers.hpp"
#include "02_primitives/shapes/shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace cookbook
{

using Long = long double;
using Long3 = Vector3<Long>;

/// How the numbers of a pair are drawn.
enum class Draws
{
  any,     ///< from −1 to 1
  lattice, ///< whole numbers from −2 to 2: they touch, are parallel, flat, without length
  thin,    ///< corners a hair from a line or a plane, or on it
  tiny,    ///< any, times 1e-30
  huge,    ///< any, times 1e30
  far,     ///< any, 10,000 away from the origin
  unlike,  ///< sizes from 1e-6 to 1
};

/// A way to draw shapes; the same numbers run after run.
template <class Real>
class ShapeDraw
{
public:
  explicit ShapeDraw(unsigned seed) : random_(seed) {}

  void use(Draws draws)
  {
    draws_ = draws;
    scale_ = draws == Draws::tiny ? 1e-30 : draws == Draws::huge ? 1e30 : 1;
    away_ = draws == Draws::far ? 1e4 : 0;
  }

  /// Before each shape: its size and its place.
  void next()
  {
    size_ = draws_ == Draws::unlike ? std::pow(10, number(-6, 0)) : 1;
    const bool on_lattice = draws_ == Draws::lattice;
    const double reach = draws_ == Draws::unlike ? 0.5 : 1.5;
    for (double& place : place_)
    {
      place = on_lattice ? whole(-2, 2) : number(-reach, reach) + away_;
    }
  }

  Vector3<Real> point()
  {
    Vector3<Real> p;
    for (int i = 0; i < 3; ++i)
    {
      const double x = draws_ == Draws::lattice ? whole(-2, 2) : number(-1, 1);
      p[i] = Real((place_[std::size_t(i)] + size_ * x) * scale_);
    }
    return p;
  }

  /// A point near the mixture of others, where thin shapes are drawn; any point otherwise.
  Vector3<Real> another(const Vector3<Real>& a, const Vector3<Real>& b, const Vector3<Real>& c)
  {
    const Vector3<Real> any = point();
    if (draws_ != Draws::thin)
    {
      return any;
    }
    const double s = number(-1, 2), t = number(-1, 2);
    const double hair = whole(0, 3) == 0 ? 0 : std::pow(10, -number(0, 18));
    const Eigen::Vector3d along = a.template cast<double>() + s * (b - a).template cast<double>() +
                                  t * (c - a).template cast<double>();
    return (along + hair * any.template cast<double>()).template cast<Real>();
  }

  Real length()
  {
    const double x = draws_ == Draws::lattice ? whole(1, 2)
                     : draws_ == Draws::thin  ? std::pow(10, -number(0, 12))
                                              : number(0.01, 1);
    return Real(x * size_ * scale_);
  }

  Matrix3<Real> turn()
  {
    if (draws_ == Draws::lattice && whole(0, 1) == 0)
    {
      return Matrix3<Real>::Identity();
    }
    const Eigen::Quaterniond q(number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1));
    return q.normalized().toRotationMatrix().template cast<Real>();
  }

  int whole(int least, int most)
  {
    return std::uniform_int_distribution<int>(least, most)(random_);
  }
  double number(double least, double most)
  {
    return least + (most - least) * (double(random_() >> 11) * 0x1p-53);
  }

private:
  std::mt19937_64 random_;
  Draws draws_ = Draws::any;
  double scale_ = 1, size_ = 1, away_ = 0;
  std::array<double, 3> place_{};
};

template <class Real>
void draw(ShapeDraw<Real>& from, Vector3<Real>& p)
{
  p = from.point();
}
template <class Real>
void draw(ShapeDraw<Real>& from, Segment<Real>& s)
{
  s.start = from.point();
  s.end = from.whole(0, 20) == 0 ? s.start : from.another(s.start, s.start, s.start);
}
template <class Real>
void draw(ShapeDraw<Real>& from, Plane<Real>& plane)
{
  plane.normal = from.turn().col(0);
  plane.distance = from.point().x() / Real(2);
}
template <class Real>
void draw(ShapeDraw<Real>& from, Sphere<Real>& sphere)
{
  sphere = {from.point(), from.whole(0, 20) == 0 ? Real(0) : from.length()};
}
template <class Real>
void draw(ShapeDraw<Real>& from, Capsule<Real>& capsule)
{
  draw(from, capsule.segment);
  capsule.radius = from.whole(0, 20) == 0 ? Real(0) : from.length();
}
template <class Real>
void draw(ShapeDraw<Real>& from, Aabb<Real>& box)
{
  const Vector3<Real> p = from.point();
  box = Aabb<Real>(p, p);
  box.max() += Vector3<Real>(from.length(), from.length(), from.length());
}
template <class Real>
void draw(ShapeDraw<Real>& from, Obb<Real>& box)
{
  box = {from.point(), from.turn(), {from.length(), from.length(), from.length()}};
}
template <class Real>
void draw(ShapeDraw<Real>& from, Triangle<Real>& t)
{
  t.a = from.point();
  t.b = from.point();
  t.c = from.another(t.a, t.b, t.a);
}
template <class Real>
void draw(ShapeDraw<Real>& from, Tetrahedron<Real>& t)
{
  t.a = from.point();
  t.b = from.point();
  t.c = from.point();
  t.d = from.another(t.a, t.b, t.c);
}

/// What the judge knows of a shape.
struct Judged
{
  std::vector<Long3> corners;             ///< of its core
  Long radius = 0;                        ///< around the core
  std::vector<std::array<Long, 4>> sides; ///< unit outward normals and offsets of a box's faces
  bool is_plane = false;                  ///< one side only, without corners
};

template <class Real>
Long3 exactly(const Vector3<Real>& v)
{
  return v.template cast<Long>();
}

template <class Real>
Judged judged(const Vector3<Real>& p)
{
  return {{exactly(p)}, 0, {}};
}
template <class Real>
Judged judged(const Segment<Real>& s)
{
  return {{exactly(s.start), exactly(s.end)}, 0, {}};
}
template <class Real>
Judged judged(const Plane<Real>& plane)
{
  const Long3 n = exactly(plane.normal);
  const Long length = n.norm();
  return {
      {},
      0,
      {{n.x() / length, n.y() / length, n.z() / length, Long(plane.distance) / length}},
      true};
}
template <class Real>
Judged judged(const Sphere<Real>& s)
{
  return {{exactly(s.center)}, Long(s.radius), {}};
}
template <class Real>
Judged judged(const Capsule<Real>& c)
{
  return {{exactly(c.segment.start), exactly(c.segment.end)}, Long(c.radius), {}};
}
template <class Real>
Judged judged(const Obb<Real>& box)
{
  Judged shape;
  for (int i = 0; i < 8; ++i)
  {
    Long3 corner = exactly(box.center);
    for (int k = 0; k < 3; ++k)
    {
      const Long3 axis = box.axes.col(k).template cast<Long>();
      corner += (i >> k & 1 ? Long(1) : Long(-1)) * Long(box.half_extents[k]) * axis;
    }
    shape.corners.push_back(corner);
  }
  for (int k = 0; k < 6; ++k)
  {
    const Long side = k < 3 ? 1 : -1;
    const Long3 n = side * box.axes.col(k % 3).template cast<Long>();
    const Long offset = n.dot(exactly(box.center)) + Long(box.half_extents[k % 3]);
    shape.sides.push_back({n.x(), n.y(), n.z(), offset});
  }
  return shape;
}
template <class Real>
Judged judged(const Aabb<Real>& box)
{
  Judged shape;
  for (int i = 0; i < 8; ++i)
  {
    const auto of = [&](int k) { return Long((i >> k & 1 ? box.max() : box.min())[k]); };
    shape.corners.push_back({of(0), of(1), of(2)});
  }
  for (int k = 0; k < 3; ++k)
  {
    std::array<Long, 4> up{}, down{};
    up[std::size_t(k)] = 1;
    up[3] = Long(box.max()[k]);
    down[std::size_t(k)] = -1;
    down[3] = -Long(box.min()[k]);
    shape.sides.push_back(up);
    shape.sides.push_back(down);
  }
  return shape;
}
template <class Real>
Judged judged(const Triangle<Real>& t)
{
  return {{exactly(t.a), exactly(t.b), exactly(t.c)}, 0, {}};
}
template <class Real>
Judged judged(const Tetrahedron<Real>& t)
{
  return {{exactly(t.a), exactly(t.b), exactly(t.c), exactly(t.d)}, 0, {}};
}

/// The way [m] to a point from the closest point of a segment.
inline Long3 way_from_segment(const Long3& p, const Long3& a, const Long3& b)
{
  const Long3 ab = b - a;
  const Long t = ab.isZero(0) ? Long(0) : std::clamp<Long>((p - a).dot(ab) / ab.dot(ab), 0, 1);
  return p - a - t * ab;
}

/// The distance [m] of a point from a triangle: from its nearest edge or, if it is above, from its
/// plane, measured from that edge, for the normal of a thin triangle is uncertain.
inline Long from_triangle(const Long3& p, const Long3& a, const Long3& b, const Long3& c)
{
  Long3 way = way_from_segment(p, a, b);
  for (const Long3& other : {way_from_segment(p, b, c), way_from_segment(p, c, a)})
  {
    way = other.norm() < way.norm() ? other : way;
  }
  const Long3 n = (b - a).cross(c - a);
  const Long length = n.norm();
  const bool above = length > 0 && n.dot((b - a).cross(p - a)) >= 0 &&
                     n.dot((c - b).cross(p - b)) >= 0 && n.dot((a - c).cross(p - c)) >= 0;
  return above ? std::abs(n.dot(way)) / length : way.norm();
}

/// How far [m] a point lies outside of a shape; 0 inside.
inline Long outside(const Judged& shape, const Long3& p)
{
  const std::vector<Long3>& c = shape.corners;
  Long far = 0;
  if (!shape.sides.empty())
  {
    for (const auto& [x, y, z, offset] : shape.sides)
    {
      far = std::max(far, p.dot(Long3(x, y, z)) - offset);
    }
    return far;
  }
  switch (c.size())
  {
  case 1:
    far = (p - c[0]).norm();
    break;
  case 2:
    far = way_from_segment(p, c[0], c[1]).norm();
    break;
  case 3:
    far = from_triangle(p, c[0], c[1], c[2]);
    break;
  default:
    bool inside = true;
    far = from_triangle(p, c[1], c[2], c[3]);
    for (std::size_t i = 0; i < 4; ++i)
    {
      const Long3 &q = c[(i + 1) % 4], &r = c[(i + 2) % 4], &s = c[(i + 3) % 4];
      far = std::min(far, from_triangle(p, q, r, s));
      const Long3 n = (r - q).cross(s - q);
      inside = inside && n.dot(p - q) * n.dot(c[i] - q) > 0;
    }
    far = inside ? Long(0) : far;
  }
  return std::max(Long(0), far - shape.radius);
}

/// The least of n·x over a shape, for a unit vector n.
inline Long reach_against(const Judged& shape, const Long3& n)
{
  if (shape.is_plane)
  {
    const auto& [x, y, z, offset] = shape.sides[0];
    const bool against = (n + Long3(x, y, z)).norm() < Long(1e-6);
    return against ? -offset : -std::numeric_limits<Long>::infinity();
  }
  Long least = shape.corners[0].dot(n);
  for (const Long3& corner : shape.corners)
  {
    least = std::min(least, corner.dot(n));
  }
  return least - shape.radius;
}

/// The size [m] of the numbers that a pair is made of, for what rounding may do.
inline Long size_of_numbers(const Judged& a, const Judged& b)
{
  Long size = std::max(a.radius, b.radius);
  for (const Judged* shape : {&a, &b})
  {
    for (const Long3& corner : shape->corners)
    {
      size = std::max(size, corner.cwiseAbs().maxCoeff());
    }
    size = shape->is_plane ? std::max(size, std::abs(shape->sides[0][3])) : size;
  }
  return size > 0 ? size : Long(1);
}

/// What is wrong with closest points, as a share of the size of the numbers: no answer is closer if
/// both points are in their shapes and the shapes lie on either side of the gap between two planes
/// through the points; an overlap is one if a point is in both.
inline Long fault(const Judged& a, const Judged& b, const ClosestPoints<Long, 3>& points)
{
  if (!points.a.allFinite() || !points.b.allFinite() || !std::isfinite(points.distance))
  {
    return std::numeric_limits<Long>::infinity();
  }
  // Planes that are nearly parallel meet far away.
  const Long far = a.is_plane && b.is_plane ? points.a.norm() : Long(0);
  const Long size = std::max(size_of_numbers(a, b), far);
  Long wrong = std::max(outside(a, points.a), outside(b, points.b));
  wrong = std::max(wrong, std::abs((points.a - points.b).norm() - points.distance));
  if (points.distance == Long(0))
  {
    return (points.a != points.b ? size : wrong) / size;
  }
  const Long3 way = points.a - points.b;
  const Long gap = way.norm();
  Long3 n = way / gap;
  // A plane's own normal is more certain than a way between points that are rounded.
  if (a.is_plane || b.is_plane)
  {
    const std::array<Long, 4>& side = a.is_plane ? a.sides[0] : b.sides[0];
    n = (a.is_plane ? Long(-1) : Long(1)) * Long3(side[0], side[1], side[2]);
  }
  // Points that are rounded tilt a short way: the shorter it is, the less it can tell.
  const Long tilt = std::max(Long(1), size / gap * Long(0.1));
  const Long cut =
      std::max(n.dot(points.a) - reach_against(a, n), -n.dot(points.b) - reach_against(b, -n));
  return std::max(wrong, cut / tilt) / size;
}

/// An answer in long double.
template <class Real>
ClosestPoints<Long, 3> exactly(const ClosestPoints<Real, 3>& points)
{
  return {exactly(points.a), exactly(points.b), Long(points.distance)};
}

/// A shape, moved.
template <class Real>
Vector3<Real> moved(const Vector3<Real>& p, const Vector3<Real>& by)
{
  return p + by;
}
template <class Real>
Segment<Real> moved(const Segment<Real>& s, const Vector3<Real>& by)
{
  return {s.start + by, s.end + by};
}
template <class Real>
Plane<Real> moved(const Plane<Real>& plane, const Vector3<Real>& by)
{
  return {plane.normal, plane.distance + plane.normal.dot(by)};
}
template <class Real>
Sphere<Real> moved(const Sphere<Real>& s, const Vector3<Real>& by)
{
  return {s.center + by, s.radius};
}
template <class Real>
Capsule<Real> moved(const Capsule<Real>& c, const Vector3<Real>& by)
{
  return {moved(c.segment, by), c.radius};
}
template <class Real>
Aabb<Real> moved(const Aabb<Real>& box, const Vector3<Real>& by)
{
  return Aabb<Real>(box.min() + by, box.max() + by);
}
template <class Real>
Obb<Real> moved(const Obb<Real>& box, const Vector3<Real>& by)
{
  return {box.center + by, box.axes, box.half_extents};
}
template <class Real>
Triangle<Real> moved(const Triangle<Real>& t, const Vector3<Real>& by)
{
  return {t.a + by, t.b + by, t.c + by};
}
template <class Real>
Tetrahedron<Real> moved(const Tetrahedron<Real>& t, const Vector3<Real>& by)
{
  return {t.a + by, t.b + by, t.c + by, t.d + by};
}

/// All kinds of shapes, in the order of the book's table.
template <class Real, class Visit>
void for_each_kind(const Visit& visit)
{
  visit(Vector3<Real>(), "point");
  visit(Segment<Real>(), "segment");
  visit(Plane<Real>(), "plane");
  visit(Sphere<Real>(), "sphere");
  visit(Capsule<Real>(), "capsule");
  visit(Aabb<Real>(), "aabb");
  visit(Obb<Real>(), "obb");
  visit(Triangle<Real>(), "triangle");
  visit(Tetrahedron<Real>(), "tetrahedron");
}

/// A shape drawn.
template <class Shape, class Real>
Shape drawn(ShapeDraw<Real>& from)
{
  Shape shape;
  from.next();
  draw(from, shape);
  return shape;
}

} // namespace cookbook
