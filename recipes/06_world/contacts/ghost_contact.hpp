#pragma once

/// \file
/// \brief Contacts that bodies seem to have only because their shapes were grown.

#include "06_world/shapes/gap_between.hpp"

#include <algorithm>
#include <cmath>

namespace cookbook
{

// [ghost_contact]
/// An axis is across a normal where they are 60° or more apart; a nearer one has mostly the overlap
/// along the normal itself.
inline constexpr double across_cosine = 0.5;
/// Boxes nearer along the normal than this fraction of the margin are about to touch, and pass each
/// other only if they overlap across it by that fraction: solvers leave overlaps of less.
inline constexpr double near_fraction = 0.1;
/// A sphere touches where its separation is no more than this fraction of its radius: rounding.
inline constexpr double touching_separation = 1e-9;
/// It is above a face where 1 − cos between its normal and the face's is no more than this, 1.4e-6
/// rad: more than rounding makes of a normal up to 1e9 radii from the origin.
inline constexpr double above_face = 1e-12;

/// True if two shapes that are a gap [m] apart along a normal are about to pass each other, not to
/// meet: along an axis of either across the normal they overlap by no more than a margin [m] and by
/// no more than half of either, or, once the gap is below a tenth of the margin, by no more than a
/// tenth of both. The offset [m] is from A's centre to B's.
///
/// So it is with a cube on flush tiles and the side of the tile that it comes to next.
template <class A, class B>
bool are_passing(
    const A& a, const Matrix3<double>& axes_a, const B& b, const Matrix3<double>& axes_b,
    const Vector3<double>& offset, const Vector3<double>& normal, double separation, double margin)
{
  const double fraction = separation > near_fraction * margin ? 1 : near_fraction;
  const auto passes = [&](Vector3<double> axis)
  {
    if (std::abs(axis.dot(normal)) >= across_cosine)
    {
      return false;
    }
    axis *= axis.dot(offset) < 0 ? -1 : 1;
    const double reach_a = projected_radius(a, axis), reach_b = projected_radius(b, -axis);
    const double overlap = reach_a + reach_b - axis.dot(offset);
    return overlap <= fraction * std::min({margin, reach_a, reach_b});
  };
  for (int i = 0; i < 3; ++i)
  {
    if (passes(axes_a.col(i)) || passes(axes_b.col(i)))
    {
      return true;
    }
  }
  return false;
}

/// The same of two boxes.
inline bool is_ghost(
    const Obb<double>& a, const Obb<double>& b, const Vector3<double>& normal, double separation,
    double margin)
{
  return are_passing(a, a.axes, b, b.axes, b.center - a.center, normal, separation, margin);
}

/// True if a ball that is a gap [m] apart from a box along a normal is not above one of its faces:
/// it may well pass by the edge.
inline bool is_ghost(
    const Sphere<double>& sphere, const Obb<double>& box, const Vector3<double>& normal,
    double separation, double)
{
  const double upright = (box.axes.transpose() * normal).cwiseAbs().maxCoeff();
  return separation > touching_separation * sphere.radius && upright < 1 - above_face;
}

/// The same, the other way round.
inline bool is_ghost(
    const Obb<double>& box, const Sphere<double>& sphere, const Vector3<double>& normal,
    double separation, double margin)
{
  return is_ghost(sphere, box, normal, separation, margin);
}

/// No other two shapes pass each other by.
template <class A, class B>
bool is_ghost(const A&, const B&, const Vector3<double>&, double, double)
{
  return false;
}
// [ghost_contact]

} // namespace cookbook
