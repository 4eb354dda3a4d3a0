#pragma once

/// \file
/// \brief Ways to answer in the plane that fail somewhere: as published, and patched by a small
/// number. Models in our own words.

#include "02_primitives/in_the_plane/in_the_plane.hpp"

#include <cmath>
#include <optional>

namespace cookbook
{

// [as_published]
/// Whether a point is on a line by its slope, X39: a vertical line has none, and ends are not
/// looked at.
inline bool on_segment_by_slope(const Segment2<double>& s, const Vector<double, 2>& p)
{
  const double slope = (s.end.y() - s.start.y()) / (s.end.x() - s.start.x());
  return p.y() == s.start.y() + slope * (p.x() - s.start.x());
}

/// Whether a segment meets a circle, X39: where the foot lies beyond an end, the end is forgotten.
inline bool
meets_circle_without_ends(const Segment2<double>& s, const Circle<double>& c, double beyond = 0)
{
  const Vector<double, 2> edge = s.end - s.start;
  const double t = (c.center - s.start).dot(edge) / edge.squaredNorm();
  const Vector<double, 2> foot = s.start + t * edge;
  return t >= -beyond && t <= 1 + beyond && (c.center - foot).norm() <= c.radius;
}

/// Where a segment enters a rectangle, X39: the inverse of a component that is zero is `of_zero`.
inline std::optional<double>
entry_by_inverse(const Segment2<double>& s, const Rectangle<double>& r, double of_zero = 0)
{
  double entry = 0, exit = 1;
  for (int i = 0; i < 2; ++i)
  {
    const double translation = s.end[i] - s.start[i],
                 inverse = translation == 0 ? of_zero : 1 / translation;
    const double one = (r.center[i] - r.half_extents[i] - s.start[i]) * inverse;
    const double other = (r.center[i] + r.half_extents[i] - s.start[i]) * inverse;
    entry = std::max(entry, std::min(one, other));
    exit = std::min(exit, std::max(one, other));
  }
  return entry <= exit ? std::optional(entry) : std::nullopt;
}

/// The way apart of two circles, by a division that nothing guards.
inline MinimumTranslation<double>
minimum_translation_unguarded(const Circle<double>& a, const Circle<double>& b)
{
  const Vector<double, 2> to_b = b.center - a.center;
  const double length = to_b.norm();
  return {to_b / length, a.radius + b.radius - length};
}
// [as_published]

// [by_epsilon]
/// Whether a point is within a tenth of a millimetre of the segment.
inline bool on_segment_by_epsilon(const Segment2<double>& s, const Vector<double, 2>& p)
{
  return closest_points(p, s).distance <= 1e-4;
}

/// Where a segment enters a rectangle: a component of zero is taken for a hundred-thousandth.
inline std::optional<double> entry_by_epsilon(const Segment2<double>& s, const Rectangle<double>& r)
{
  Segment2<double> nudged = s;
  for (int i = 0; i < 2; ++i)
  {
    nudged.end[i] += s.end[i] == s.start[i] ? 1e-5 : 0;
  }
  return entry_by_inverse(nudged, r);
}

/// The way apart of two circles: centres within a micrometre are taken for one.
inline MinimumTranslation<double>
minimum_translation_by_epsilon(const Circle<double>& a, const Circle<double>& b)
{
  const MinimumTranslation<double> translation = minimum_translation_unguarded(a, b);
  const bool one_centre = (b.center - a.center).norm() < 1e-6;
  return one_centre ? MinimumTranslation<double>{{0, 1}, a.radius + b.radius} : translation;
}
// [by_epsilon]

} // namespace cookbook
