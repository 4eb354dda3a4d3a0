/// \file
/// Random shapes of every kind.
#pragma once

#include "02_primitives/shapes/more_shapes.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <random>

namespace cookbook
{

/// How the numbers of a pair are drawn.
enum class Draws
{
  any,     ///< from −1 to 1
  lattice, ///< whole numbers from −2 to 2: they touch, are parallel, flat, without length
  thin,    ///< corners next to a line or a plane, or on it
  tiny,    ///< any, times 1e-30
  huge,    ///< any, times 1e30
  distant, ///< any, 10,000 away from the origin
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
    away_ = draws == Draws::distant ? 1e4 : 0;
  }

  /// Before each shape: its size and its place.
  void next()
  {
    size_ = draws_ == Draws::unlike ? std::pow(10, number(-6, 0)) : 1;
    const bool on_lattice = draws_ == Draws::lattice;
    const double limit = draws_ == Draws::unlike ? 0.5 : 1.5;
    for (double& place : place_)
    {
      place = on_lattice ? whole(-2, 2) : number(-limit, limit) + away_;
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
    const double angle = whole(0, 3) == 0 ? 0 : std::pow(10, -number(0, 18));
    const Eigen::Vector3d along = a.template cast<double>() + s * (b - a).template cast<double>() +
                                  t * (c - a).template cast<double>();
    return (along + angle * any.template cast<double>()).template cast<Real>();
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
