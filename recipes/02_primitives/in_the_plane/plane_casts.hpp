#pragma once

/// \file
/// \brief Where a ray or a segment in the plane first meets a shape.

#include "02_primitives/in_the_plane/plane_closest.hpp"
#include "02_primitives/in_the_plane/plane_forms.hpp"
#include "02_primitives/shapes/answers.hpp"

#include <optional>

namespace cookbook
{

// [meet_circle]
/// Where the ray o + t d meets a circle that does not hold o.
///
/// The root is taken of an area, not of a difference of large squares; the point is found from the
/// centre, not from the origin, however far that is.
template <class Real>
std::optional<Hit<Real, 2>>
meet_circle(const Vector<Real, 2>& o, const Vector<Real, 2>& d, const PlaneForm<Real>& circle)
{
  const Vector<Real, 2> from = o - circle.center;
  const Real along = from.dot(d), squared = d.squaredNorm(), area = cross_in_plane<Real>(d, from);
  const Real under_root = circle.radius * circle.radius * squared - area * area;
  if (!(along < Real(0)) || under_root < Real(0))
  {
    return std::nullopt;
  }
  const Real root = std::sqrt(under_root);
  const Vector<Real, 2> out = (area * quarter_turn<Real>(d) - root * d) / squared;
  const Real t = (from.squaredNorm() - circle.radius * circle.radius) / (root - along);
  const Vector<Real, 2> normal = out.isZero(0) ? Vector<Real, 2>(-d) : out;
  return Hit<Real, 2>{t, circle.center + out, unit_in_plane<Real>(normal)};
}
// [meet_circle]

// [meet_segment]
/// Where the ray o + t d meets a segment that does not hold o.
///
/// It does where the ends are on different sides of the ray's line, or on it. A segment along the
/// ray is met at its nearer end, with the normal against the ray.
template <class Real>
std::optional<Hit<Real, 2>>
meet_segment(const Vector<Real, 2>& o, const Vector<Real, 2>& d, const PlaneForm<Real>& segment)
{
  const Vector<Real, 2> start = segment.corner[0] - o, end = segment.corner[1] - o;
  const Vector<Real, 2> edge = segment.corner[1] - segment.corner[0];
  const Real side = cross_in_plane<Real>(d, start), side_of_end = cross_in_plane<Real>(d, end);
  // Along the ray to rounding: the signs would tell nothing.
  const Real longest = std::max(largest(start), largest(end)) * largest(d);
  const Real rounding = 4 * std::numeric_limits<Real>::epsilon() * longest;
  if (std::abs(side) <= rounding && std::abs(side_of_end) <= rounding)
  {
    const bool start_first = start.dot(d) <= end.dot(d);
    const Real t = (start_first ? start : end).dot(d) / d.squaredNorm();
    return t > Real(0) ? std::optional(Hit<Real, 2>{
                             t, segment.corner[start_first ? 0 : 1], unit_in_plane<Real>(-d)})
                       : std::nullopt;
  }
  const Real sides = side_of_end - side, area = cross_in_plane<Real>(start, edge);
  const bool same_side =
      (side > Real(0)) == (side_of_end > Real(0)) && (side < Real(0)) == (side_of_end < Real(0));
  if (same_side || (area > Real(0)) != (sides > Real(0)) || area == Real(0))
  {
    return std::nullopt;
  }
  const Vector<Real, 2> direction = start - (side / sides) * edge;
  const Vector<Real, 2> left = quarter_turn<Real>(edge);
  const Vector<Real, 2> normal = area > Real(0) ? left : Vector<Real, 2>(-left);
  const Real t = std::max(Real(0), direction.dot(d) / d.squaredNorm());
  return Hit<Real, 2>{t, o + direction, unit_in_plane<Real>(normal)};
}
// [meet_segment]

// [meet_rectangle]
/// Where the ray o + t d meets a rectangle that does not hold o.
///
/// A rectangle is what two slabs share: the ray is in it from the last entry to the first exit.
template <class Real>
std::optional<Hit<Real, 2>>
meet_rectangle(const Vector<Real, 2>& o, const Vector<Real, 2>& d, const PlaneForm<Real>& box)
{
  const Vector<Real, 2> axes[] = {box.axis, quarter_turn<Real>(box.axis)}, from = o - box.center;
  const Vector<Real, 2> at(from.dot(axes[0]), from.dot(axes[1]));
  const Vector<Real, 2> direction(d.dot(axes[0]), d.dot(axes[1]));
  Real entry = -std::numeric_limits<Real>::infinity(), exit = -entry;
  int entered = 0;
  for (int i = 0; i < 2; ++i)
  {
    const Real near_side = direction[i] < Real(0) ? box.half[i] : -box.half[i];
    if (direction[i] == Real(0) && std::abs(at[i]) > box.half[i])
    {
      return std::nullopt; // along the slab, outside
    }
    if (direction[i] != Real(0))
    {
      const Real entry_here = (near_side - at[i]) / direction[i];
      exit = std::min(exit, (-near_side - at[i]) / direction[i]);
      entered = entry_here > entry ? i : entered;
      entry = std::max(entry, entry_here);
    }
  }
  if (entry < Real(0) || entry > exit)
  {
    return std::nullopt;
  }
  Vector<Real, 2> point = (at + entry * direction).cwiseMax(-box.half).cwiseMin(box.half);
  const Real sign = direction[entered] < Real(0) ? Real(1) : Real(-1);
  point[entered] = sign * box.half[entered];
  return Hit<Real, 2>{
      entry, box.center + point.x() * axes[0] + point.y() * axes[1], sign * axes[entered]};
}
// [meet_rectangle]

// [meet]
/// Where the ray o + t d first meets a form; where the form holds o, at once, against the ray.
template <class Real>
std::optional<Hit<Real, 2>>
meet(const Vector<Real, 2>& o, const Vector<Real, 2>& d, const PlaneForm<Real>& form)
{
  const Vector<Real, 2> zero(0, 0);
  if (foot_on(form, o).squared <= form.radius * form.radius)
  {
    return Hit<Real, 2>{Real(0), o, unit_in_plane<Real>(zero - d)};
  }
  if (d == zero)
  {
    return std::nullopt;
  }
  return form.corners == 1   ? meet_circle(o, d, form)
         : form.corners == 2 ? meet_segment(o, d, form)
                             : meet_rectangle(o, d, form);
}
// [meet]

/// A hit as it is, of one in a view; where t is 0, at the origin to the bit.
template <class Real>
Hit<Real, 2> hit_as_it_is(
    const Hit<Wide<Real>, 2>& hit, int exponent_of_t, const PlaneView<Real>& view,
    const Vector<Real, 2>& origin)
{
  const bool at_once = hit.t == Wide<Real>(0);
  return {
      static_cast<Real>(std::ldexp(hit.t, exponent_of_t)), at_once ? origin : view.point(hit.point),
      hit.normal.template cast<Real>()};
}

// [cast_in_plane]
/// Where a ray first meets a shape in the plane.
///
/// From inside, and from the edge, t is 0 and the normal is against the ray. A direction of zero
/// meets only what holds the origin, with the normal +y.
template <class Real, template <class> class Shape>
requires ShapeInPlane<Shape<Real>, Real> std::optional<Hit<Real, 2>>
cast(const Ray2<Real>& ray, const Shape<Real>& shape)
{
  const PlaneView<Real> view(place_of(shape), std::max(largest(ray.origin), largest(shape)));
  const Vector<Wide<Real>, 2> d = widen(ray.direction);
  const int exponent = exponent_to_ordinary<Wide<Real>>(largest(d));
  const auto hit = meet<Wide<Real>>(
      view.seen(ray.origin), d * std::ldexp(Wide<Real>(1), exponent), form_of(shape, view));
  return hit ? std::optional(hit_as_it_is(*hit, exponent - view.exponent, view, ray.origin))
             : std::nullopt;
}

/// Where a segment first meets a shape in the plane; t is 0 at its start, 1 at its end.
template <class Real, template <class> class Shape>
requires ShapeInPlane<Shape<Real>, Real> std::optional<Hit<Real, 2>>
cast(const Segment2<Real>& segment, const Shape<Real>& shape)
{
  const PlaneView<Real> view(place_of(shape), std::max(largest(segment), largest(shape)));
  const PlaneForm<Wide<Real>> form = form_of(shape, view);
  const Vector<Wide<Real>, 2> start = view.seen(segment.start), end = view.seen(segment.end);
  const Vector<Wide<Real>, 2> d = end - start;
  const int exponent = exponent_to_ordinary<Wide<Real>>(largest(d));
  auto hit = meet<Wide<Real>>(start, d * std::ldexp(Wide<Real>(1), exponent), form);
  const Wide<Real> last = std::ldexp(Wide<Real>(1), -exponent);
  if (hit && hit->t > last)
  {
    // Beyond the end; an end that touches is met, whatever rounding says.
    hit->t = last;
    hit = foot_on(form, end).squared <= form.radius * form.radius ? hit : std::nullopt;
  }
  return hit ? std::optional(hit_as_it_is(*hit, exponent, view, segment.start)) : std::nullopt;
}
// [cast_in_plane]

} // namespace cookbook
