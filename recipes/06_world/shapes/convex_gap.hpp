#pragma once

/// \file
/// \brief The signed gap of any two convex shapes: GJK where they are apart, EPA where they
/// overlap.

#include "02_primitives/closest_points/gjk_distance.hpp"
#include "02_primitives/closest_points/nearest_on_simplex.hpp"
#include "04_obb_manifolds/gjk_epa/gjk_epa.hpp"
#include "06_world/shapes/placed_convex.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace cookbook
{

// [convex_difference]
/// The Minkowski difference A ⊖ B of two convex shapes, seen from A's centre: its support function.
template <class A, class B>
struct ConvexDifference
{
  const Placed<A>& a;
  const Placed<B>& b;

  SupportPoint<double> operator()(const Vector3<double>& direction) const
  {
    const Vector3<double> on_a = support_arm(a, direction);
    const Vector3<double> on_b = (b.pose.center - a.pose.center) + support_arm(b, -direction);
    return {on_a - on_b, on_a};
  }
};

/// How far [m] the projections of two convex shapes along a unit direction from A to B are apart.
template <class Support>
double separation_along(const Support& support, const Vector3<double>& unit)
{
  return -unit.dot(support(unit).point);
}
// [convex_difference]

// [gjk_closest]
/// The signed gap of two convex shapes, and a point of A and one of B that are that far apart.
struct ConvexGap
{
  Direction<double> gap;   ///< [m], from A to B; the length is negative where they overlap
  SupportPoint<double> at; ///< the point of A from A's centre, and the difference of both, world
};

/// The point of a solid closest to the origin by GJK, as a mixture of the support points that it is
/// between; a tetrahedron, or a point within a tolerance [m], where the solid holds the origin.
template <class Support>
std::pair<Simplex<double>, SupportPoint<double>>
gjk_closest(const Support& support, const Vector3<double>& start, double tolerance)
{
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  Simplex<double> simplex;
  simplex.add(support(normalize<double>(start).unit));
  SupportPoint<double> closest = simplex.points[0];
  for (int step = 0; step < gjk_distance_limit && simplex.size < 4; ++step)
  {
    const double squared = closest.point.squaredNorm();
    if (!(squared > tolerance * tolerance))
    {
      break;
    }
    const SupportPoint<double> found = support(-closest.point);
    const double gain = squared - closest.point.dot(found.point);
    if (!(gain > rounding * squared))
    {
      break;
    }
    Simplex<double> grown = simplex, kept;
    grown.add(found);
    const std::array corners{grown.at(0), grown.at(1), grown.at(2), grown.at(3)};
    const Nearest<double> nearest = nearest_on_simplex(corners.data(), grown.size);
    if (!(nearest.point.squaredNorm() < squared))
    {
      break;
    }
    closest = {nearest.point, Vector3<double>::Zero()};
    for (int i = 0; i < grown.size; ++i)
    {
      if (const double weight = nearest.weights[i]; weight > 0)
      {
        kept.add(grown.points[std::size_t(i)]);
        closest.on_a += weight * grown.points[std::size_t(i)].on_a;
      }
    }
    simplex = kept;
  }
  return {simplex, closest};
}
// [gjk_closest]

// [convex_gap]
/// Lengths of two shapes that differ by less than this fraction of their outer radii are equal.
inline constexpr double convex_tolerance = 1e-10;

/// The unit axes of both shapes, both ways, as directions of the gap: where one of them is as good
/// as what was found, to the tolerance [m], it is taken. Where a face or an edge lies along an
/// axis, its normal is then exact, and the same from frame to frame.
template <class A, class B>
Direction<double> with_exact_axes(
    const ConvexDifference<A, B>& support, const Direction<double>& found, double tolerance)
{
  Direction<double> best{found.unit, found.length - tolerance};
  for (const Matrix3<double>* axes : {&support.a.pose.axes, &support.b.pose.axes})
  {
    for (int i = 0; i < 3; ++i)
    {
      const Vector3<double> axis = axes->col(i) * (axes->col(i).dot(found.unit) < 0 ? -1 : 1);
      const double separation = separation_along(support, axis);
      best = separation > best.length ? Direction<double>{axis, separation} : best;
    }
  }
  return best.unit == found.unit ? found : best;
}

/// A direction that separates two shapes more, by Newton's method on the unit sphere; the one given
/// where that finds none.
///
/// EPA gives up on round shapes that it cannot close. Across a unit direction n the separation
/// changes as the support point p moves: its slope is −p, its curvature that of p by differences
/// over small leans, and the separation itself, for n stays of length one.
template <class Support>
Direction<double> refined(const Support& support, Direction<double> best)
{
  constexpr double lean = 1e-4;
  for (int step = 0; step < 8; ++step)
  {
    const Vector3<double> x = normalize<double>(best.unit.unitOrthogonal()).unit;
    Eigen::Matrix<double, 3, 2> across;
    across << x, best.unit.cross(x);
    const Vector3<double> point = support(best.unit).point;
    Eigen::Matrix2d curvature = best.length * Eigen::Matrix2d::Identity();
    for (int i = 0; i < 2; ++i)
    {
      const Vector3<double> leaning = support(best.unit + lean * across.col(i)).point;
      curvature.col(i) += across.transpose() * (leaning - point) / lean;
    }
    const Eigen::Vector2d way = -curvature.inverse() * (across.transpose() * point);
    const Vector3<double> unit = (best.unit + across * way).normalized();
    const double separation = separation_along(support, unit);
    if (!(separation > best.length))
    {
      break;
    }
    best = {unit, separation};
  }
  return best;
}

/// The signed gap of two convex shapes by their support functions alone.
///
/// Where round shapes overlap by about their radius the depth may be too large, by 1e-4 of their
/// size at most in all that was tried; it still ends the overlap.
template <class A, class B>
ConvexGap convex_gap(const Placed<A>& a, const Placed<B>& b)
{
  const ConvexDifference<A, B> support{a, b};
  const double size = extent(a.shape).outer + extent(b.shape).outer;
  const double tolerance = convex_tolerance * size;
  const auto [simplex, closest] = gjk_closest(support, b.pose.center - a.pose.center, tolerance);
  ConvexGap found{normalize<double>(-closest.point), closest};
  if (simplex.size == 4 || !(found.gap.length > tolerance))
  {
    const Expansion<double> expansion = epa(support, simplex, tolerance);
    found.gap = refined(support, Direction<double>{expansion.normal, -expansion.depth});
    found.at = contact_on_ray(expansion);
  }
  else
  {
    found.gap.length = separation_along(support, found.gap.unit);
  }
  found.gap = with_exact_axes(support, found.gap, 100 * tolerance);
  return found;
}
// [convex_gap]

} // namespace cookbook
