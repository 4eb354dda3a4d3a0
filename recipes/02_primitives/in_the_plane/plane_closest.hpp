#pragma once

/// \file
/// \brief The closest points of two forms in the plane.

#include "02_primitives/in_the_plane/plane_projections.hpp"
#include "02_primitives/shapes/answers.hpp"

#include <optional>

namespace cookbook
{

/// A point of a form, and the square of its distance from the point that was asked for.
template <class Real>
struct Foot
{
  Vector<Real, 2> point; ///< [m]
  Real squared;          ///< [m²]
};

// [foot_on_segment]
/// The point of a segment closest to p; P2.
///
/// Ends are given as they are. Between them the distance is that from the line, an area over a
/// length. A segment so short that its square leaves the range is its start.
template <class Real>
Foot<Real>
foot_on_segment(const Vector<Real, 2>& start, const Vector<Real, 2>& end, const Vector<Real, 2>& p)
{
  const Vector<Real, 2> edge = end - start, from_start = p - start;
  const Real along = from_start.dot(edge), squared = edge.squaredNorm();
  if (!(along > Real(0)) || squared < SafeSquares<Real>::least)
  {
    return {start, from_start.squaredNorm()};
  }
  if (along >= squared)
  {
    return {end, (p - end).squaredNorm()};
  }
  const Real area = cross_in_plane<Real>(edge, from_start);
  return {start + (along / squared) * edge, area * area / squared};
}
// [foot_on_segment]

// [foot_on]
/// The point of a form, without its radius, closest to p.
template <class Real>
Foot<Real> foot_on(const PlaneForm<Real>& form, const Vector<Real, 2>& p)
{
  if (form.corners == 2)
  {
    return foot_on_segment<Real>(form.corner[0], form.corner[1], p);
  }
  const Vector<Real, 2> x = form.axis, y = quarter_turn<Real>(x), from = p - form.center;
  const Vector<Real, 2> local(from.dot(x), from.dot(y));
  const Vector<Real, 2> nearest = local.cwiseMax(-form.half).cwiseMin(form.half);
  if (nearest == local)
  {
    return {p, Real(0)};
  }
  return {form.center + nearest.x() * x + nearest.y() * y, (local - nearest).squaredNorm()};
}
// [foot_on]

/// A point of each of two forms, without their radii, and the square of their distance.
template <class Real>
struct FootPair
{
  Vector<Real, 2> a; ///< [m], of the first
  Vector<Real, 2> b; ///< [m], of the second
  Real squared;      ///< [m²]
};

// [nearest_corner]
/// The corner of one form and the point of the other that are closest.
///
/// Two forms that are apart are closest at a corner of one of them. Two corners nearly as close
/// may win by rounding: so each point is moved to where it is closest to the other.
template <class Real>
FootPair<Real> nearest_corner(const PlaneForm<Real>& a, const PlaneForm<Real>& b)
{
  FootPair<Real> best{a.center, b.center, std::numeric_limits<Real>::infinity()};
  for (const Vector<Real, 2>& corner : a.polygon())
  {
    const Foot<Real> foot = foot_on(b, corner);
    best = foot.squared < best.squared ? FootPair<Real>{corner, foot.point, foot.squared} : best;
  }
  for (const Vector<Real, 2>& corner : b.polygon())
  {
    const Foot<Real> foot = foot_on(a, corner);
    best = foot.squared < best.squared ? FootPair<Real>{foot.point, corner, foot.squared} : best;
  }
  best.b = foot_on(b, best.a).point;
  best.a = foot_on(a, best.b).point;
  return best;
}
// [nearest_corner]

// [common_point]
/// Where two segments cross, unless they are parallel.
template <class Real>
std::optional<Vector<Real, 2>> crossing(
    const Vector<Real, 2>& a, const Vector<Real, 2>& end_a, const Vector<Real, 2>& b,
    const Vector<Real, 2>& end_b)
{
  const Vector<Real, 2> along_a = end_a - a, along_b = end_b - b, between = b - a;
  const Real area = cross_in_plane<Real>(along_a, along_b);
  if (area == Real(0))
  {
    return std::nullopt;
  }
  const Real t = cross_in_plane<Real>(between, along_b) / area;
  const Real u = cross_in_plane<Real>(between, along_a) / area;
  const bool within = t >= Real(0) && t <= Real(1) && u >= Real(0) && u <= Real(1);
  return within ? std::optional<Vector<Real, 2>>(a + t * along_a) : std::nullopt;
}

/// A point of both forms, which overlap: a corner of one within the other, or where edges cross.
///
/// Of several, the one that is closest to both: edges that are parallel to rounding cross anywhere.
template <class Real>
Vector<Real, 2> common_point(const PlaneForm<Real>& a, const PlaneForm<Real>& b)
{
  const FootPair<Real> nearest = nearest_corner(a, b);
  Foot<Real> best{nearest.a, nearest.squared};
  for (int i = 0; best.squared > Real(0) && i < a.corners; ++i)
  {
    for (int j = 0; j < b.corners; ++j)
    {
      const auto point = crossing<Real>(
          a.corner[std::size_t(i)], a.corner[std::size_t((i + 1) % a.corners)],
          b.corner[std::size_t(j)], b.corner[std::size_t((j + 1) % b.corners)]);
      const Real off = point ? foot_on(b, *point).squared : best.squared;
      best = off < best.squared ? Foot<Real>{*point, off} : best;
    }
  }
  return best.point;
}
// [common_point]

// [forms_overlap]
/// Whether two forms have a point in common; touching counts.
template <class Real>
bool forms_overlap(const PlaneForm<Real>& a, const PlaneForm<Real>& b)
{
  if (a.corners > 1 && b.corners > 1)
  {
    return !separating_axis<Real>(a.polygon(), b.polygon());
  }
  const Real radii = a.radius + b.radius;
  const Foot<Real> foot = a.corners == 1 ? foot_on(b, a.center) : foot_on(a, b.center);
  return foot.squared <= radii * radii;
}
// [forms_overlap]

// [forms_closest]
/// How far a length [m], the root of a square [m²], stays within a reach [m]: below zero exactly
/// where forms_overlap() says no.
///
/// It decides by squares, of which several have the same root. So do we, where the root is the
/// reach.
template <class Real>
Real depth_within(const Real& squared, const Real& length, const Real& radii)
{
  return length == radii && radii > Real(0) ? (radii * radii - squared) / (radii + length)
                                            : radii - length;
}

/// The closest points of two forms; a common point where they overlap.
template <class Real>
ClosestPoints<Real, 2> forms_closest(const PlaneForm<Real>& a, const PlaneForm<Real>& b)
{
  const bool overlap = forms_overlap(a, b);
  if (overlap && a.corners > 1 && b.corners > 1)
  {
    const Vector<Real, 2> common = common_point(a, b);
    return {common, common, Real(0)};
  }
  const FootPair<Real> feet = nearest_corner(a, b);
  const Real between = std::sqrt(feet.squared);
  const Vector<Real, 2> unit = unit_in_plane<Real>(feet.b - feet.a);
  if (overlap)
  {
    const Real first = std::max(Real(0), between - b.radius), last = std::min(a.radius, between);
    const Vector<Real, 2> common = feet.a + (first + last) / 2 * unit;
    return {common, common, Real(0)};
  }
  const Real within = depth_within<Real>(feet.squared, between, a.radius + b.radius);
  return {feet.a + a.radius * unit, feet.b - b.radius * unit, std::max(Real(0), Real(-within))};
}
// [forms_closest]

} // namespace cookbook
