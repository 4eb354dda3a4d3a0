#pragma once

/// \file
/// \brief Points, segments, circles and rectangles in the plane: what overlaps, what is closest.

#include "02_primitives/in_the_plane/plane_casts.hpp"
#include "02_primitives/in_the_plane/plane_closest.hpp"
#include "02_primitives/in_the_plane/plane_forms.hpp"

#include <type_traits>

namespace cookbook
{

/// What `ask(form of a, form of b)` answers, in the view from a point, or else from the shape that
/// is farther left, or lower: so the order of the shapes changes no verdict.
template <class Real, class First, class Second, class Ask>
auto seen_together(const First& a, const Second& b, const Ask& ask)
{
  const Vector<Real, 2> of_a = place_of(a), of_b = place_of(b);
  const bool b_first = of_b.x() < of_a.x() || (of_b.x() == of_a.x() && of_b.y() < of_a.y());
  const bool from_b = b_first && !std::is_same_v<First, Vector<Real, 2>>;
  const PlaneView<Real> view(from_b ? of_b : of_a, std::max(largest(a), largest(b)));
  return ask(form_of(a, view), form_of(b, view), view);
}

/// Whether two shapes in the plane, or points, have a point in common; touching counts.
template <class Real, class First, class Second>
bool overlap_in_plane(const First& a, const Second& b)
{
  return seen_together<Real>(
      a, b,
      [](const auto& of_a, const auto& of_b, const auto&) { return forms_overlap(of_a, of_b); });
}

/// The closest points of two shapes in the plane, or points.
template <class Real, class First, class Second>
ClosestPoints<Real, 2> closest_in_plane(const First& a, const Second& b)
{
  return seen_together<Real>(
      a, b,
      [](const auto& of_a, const auto& of_b, const PlaneView<Real>& view)
      {
        const auto found = forms_closest(of_a, of_b);
        return ClosestPoints<Real, 2>{
            view.point(found.a), view.point(found.b), view.length(found.distance)};
      });
}

// [overlaps_in_plane]
/// Whether two points are the same.
template <class Real>
bool overlaps(const Vector<Real, 2>& a, const Vector<Real, 2>& b)
{
  return overlap_in_plane<Real>(a, b);
}

/// Whether a shape holds a point; its edge belongs to it.
template <class Real, template <class> class Shape>
requires ShapeInPlane<Shape<Real>, Real>
bool overlaps(const Vector<Real, 2>& point, const Shape<Real>& shape)
{
  return overlap_in_plane<Real>(point, shape);
}

/// Whether a shape holds a point; its edge belongs to it.
template <class Real, template <class> class Shape>
requires ShapeInPlane<Shape<Real>, Real>
bool overlaps(const Shape<Real>& shape, const Vector<Real, 2>& point)
{
  return overlap_in_plane<Real>(point, shape);
}

/// Whether two shapes in the plane have a point in common; touching counts.
template <class Real, template <class> class First, template <class> class Second>
requires ShapeInPlane<First<Real>, Real> && ShapeInPlane<Second<Real>, Real>
bool overlaps(const First<Real>& a, const Second<Real>& b)
{
  return overlap_in_plane<Real>(a, b);
}
// [overlaps_in_plane]

/// Two points are their own closest points.
template <class Real>
ClosestPoints<Real, 2> closest_points(const Vector<Real, 2>& a, const Vector<Real, 2>& b)
{
  return closest_in_plane<Real>(a, b);
}

/// The point of a shape closest to a point, which is its own closest point if the shape holds it.
template <class Real, template <class> class Shape>
requires ShapeInPlane<Shape<Real>, Real> ClosestPoints<Real, 2>
closest_points(const Vector<Real, 2>& point, const Shape<Real>& shape)
{
  return closest_in_plane<Real>(point, shape);
}

/// The same, the shape first.
template <class Real, template <class> class Shape>
requires ShapeInPlane<Shape<Real>, Real> ClosestPoints<Real, 2>
closest_points(const Shape<Real>& shape, const Vector<Real, 2>& point)
{
  const ClosestPoints<Real, 2> found = closest_in_plane<Real>(point, shape);
  return {found.b, found.a, found.distance};
}

/// The closest points of two shapes in the plane; where they overlap, a point of both, twice.
template <class Real, template <class> class First, template <class> class Second>
requires ShapeInPlane<First<Real>, Real> && ShapeInPlane<Second<Real>, Real> ClosestPoints<Real, 2>
closest_points(const First<Real>& a, const Second<Real>& b)
{
  return closest_in_plane<Real>(a, b);
}

/// Whether a shape in the plane holds a point; its edge belongs to it; P21.
template <class Real, template <class> class Shape>
requires ShapeInPlane<Shape<Real>, Real>
bool contains(const Shape<Real>& shape, const Vector<Real, 2>& point)
{
  return overlap_in_plane<Real>(point, shape);
}

// [minimum_translation]
/// Which way circle b leaves circle a the soonest, and how far.
template <class Real>
struct MinimumTranslation
{
  Vector<Real, 2> normal; ///< [1], unit, from a to b; +y for circles about one centre
  Real depth;             ///< [m], of the overlap; below zero where the circles are apart
};

/// The way on which circle b leaves circle a the soonest.
template <class Real>
MinimumTranslation<Real> minimum_translation(const Circle<Real>& a, const Circle<Real>& b)
{
  const PlaneView<Real> view(a.center, std::max(largest(a), largest(b)));
  const Vector<Wide<Real>, 2> to_b = view.seen(b.center);
  const auto out = normalize<Wide<Real>>(Vector3<Wide<Real>>(to_b.x(), to_b.y(), 0));
  const Wide<Real> radii = a.radius * view.factor + b.radius * view.factor;
  const Wide<Real> depth = depth_within<Wide<Real>>(to_b.squaredNorm(), out.length, radii);
  return {out.unit.template head<2>().template cast<Real>(), view.length(depth)};
}
// [minimum_translation]

} // namespace cookbook
