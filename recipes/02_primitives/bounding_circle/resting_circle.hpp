#pragma once

/// \file
/// \brief The smallest circle around points in the plane, found from the points that it rests on.

#include "02_primitives/in_the_plane/plane_form.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

namespace cookbook
{

// [circle_through]
/// The centre of the circle through three points; nothing where they lie on a line.
template <class Real>
std::optional<Vector<Real, 2>>
center_through(const Vector<Real, 2>& a, const Vector<Real, 2>& b, const Vector<Real, 2>& c)
{
  const Vector<Real, 2> to_b = b - a, to_c = c - a;
  const Real twice_area = cross_in_plane<Real>(to_b, to_c);
  if (twice_area == Real(0))
  {
    return std::nullopt;
  }
  const Vector<Real, 2> across = to_b.squaredNorm() * to_c - to_c.squaredNorm() * to_b;
  return Vector<Real, 2>(a - quarter_turn<Real>(across) / (2 * twice_area));
}
// [circle_through]

// [resting_circle]
/// A circle, and the points that it rests on.
template <class Real>
struct RestingCircle
{
  Vector<Real, 2> center;                ///< [m]
  Real squared;                          ///< [m²], of the radius
  std::array<Vector<Real, 2>, 3> points; ///< [m], on it; the first `count` are used
  int count;                             ///< 1, 2 or 3
};

/// The smallest circle around up to four points: on two of them as a diameter, or through three.
template <class Real>
RestingCircle<Real> smallest_around(const std::array<Vector<Real, 2>, 4>& points, int count)
{
  RestingCircle<Real> best{
      points[0], std::numeric_limits<Real>::infinity(), {points[0], points[0], points[0]}, 1};
  const auto consider = [&](const RestingCircle<Real>& one)
  {
    Real squared = 0;
    for (int i = 0; i < count; ++i)
    {
      squared = std::max(squared, (points[std::size_t(i)] - one.center).squaredNorm());
    }
    best = squared < best.squared ? RestingCircle<Real>{one.center, squared, one.points, one.count}
                                  : best;
  };
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      const Vector<Real, 2>&a = points[std::size_t(i)], &b = points[std::size_t(j)];
      consider({(a + b) / 2, 0, {a, b, b}, 2});
      for (int k = 0; k < j; ++k)
      {
        const Vector<Real, 2>& c = points[std::size_t(k)];
        if (const auto center = center_through<Real>(a, b, c))
        {
          consider({*center, 0, {a, b, c}, 3});
        }
      }
    }
  }
  return best;
}
// [resting_circle]

// [growing_circle]
/// The smallest circle around the points at(0) to at(count - 1).
///
/// A point outside a circle that is the smallest around some points is one that the smallest
/// around all of them rests on: so we take in the farthest, and the circle grows until it holds
/// all. It cannot grow for ever, for there are only so many circles on two or three points.
template <class Real, class At>
RestingCircle<Real> growing_circle(std::size_t count, const At& at)
{
  RestingCircle<Real> circle{at(0), Real(0), {at(0), at(0), at(0)}, 1};
  while (true)
  {
    Vector<Real, 2> farthest = circle.center;
    Real squared = circle.squared;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Vector<Real, 2> point = at(i);
      const Real here = (point - circle.center).squaredNorm();
      farthest = here > squared ? point : farthest;
      squared = std::max(squared, here);
    }
    const auto& on = circle.points;
    const RestingCircle<Real> larger =
        smallest_around<Real>({farthest, on[0], on[1], on[2]}, circle.count + 1);
    if (!(squared > circle.squared) || !(larger.squared > circle.squared))
    {
      return circle;
    }
    circle = larger;
  }
}
// [growing_circle]

} // namespace cookbook
