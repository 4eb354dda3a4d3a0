#pragma once

/// \file
/// \brief Where a path first meets a tetrahedron.

#include "02_primitives/casts/cast_triangle.hpp"
#include "02_primitives/shapes/more_shapes.hpp"

#include <limits>
#include <optional>

namespace cookbook
{

// [cast_tetrahedron]
/// Where a path first meets a tetrahedron: its line lies in it between the first and the last face.
template <class Real>
std::optional<Hit<Real, 3>> first_hit_on(const CastPath<Real>& path, const Tetrahedron<Real>& solid)
{
  const ShearedView<Real> view = sheared_view(path);
  const Vector3<Real> a = seen_along(view, solid.a), b = seen_along(view, solid.b);
  const Vector3<Real> c = seen_along(view, solid.c), d = seen_along(view, solid.d);
  const LineSpan<Real> spans[] = {
      span_of<Real>(view, a, b, c), span_of<Real>(view, a, b, d), span_of<Real>(view, a, c, d),
      span_of<Real>(view, b, c, d)};
  const Triangle<Real> faces[] = {
      {solid.a, solid.b, solid.c},
      {solid.a, solid.b, solid.d},
      {solid.a, solid.c, solid.d},
      {solid.b, solid.c, solid.d}};
  const Real infinite = std::numeric_limits<Real>::infinity();
  LineSpan<Real> whole{infinite, -infinite, Real(0)};
  int face = 0;
  for (int i = 0; i < 4; ++i)
  {
    const LineSpan<Real>& one = spans[i];
    if (!(one.first <= one.last))
    {
      continue;
    }
    // Of faces that the line enters at once, one that it does not lie in tells the normal.
    const bool earlier = one.first < whole.first;
    if (earlier || (one.first == whole.first && whole.facing == Real(0)))
    {
      whole.first = one.first;
      whole.facing = one.certain_facing();
      face = i;
    }
    whole.last = one.last > whole.last ? one.last : whole.last;
  }
  if (!(whole.first <= whole.last) || !(whole.last >= Real(0)))
  {
    return std::nullopt;
  }
  if (whole.first <= Real(0))
  {
    return hit_from_inside(path);
  }
  if (path.direction.isZero(0))
  {
    return std::nullopt;
  }
  // At a corner or an edge the line meets several faces at once: of these one that it enters by,
  // whose normal on the path's side points away from the corner across, tells the normal.
  const Vector3<Real>* across[] = {&solid.d, &solid.c, &solid.b, &solid.a};
  const Real rounding = 8 * std::numeric_limits<Real>::epsilon() * whole.first;
  Vector3<Real> normal = facing_normal(path, view, faces[face], whole.facing);
  for (int i = 0; i < 4 && normal.dot(*across[face] - faces[face].a) > Real(0); ++i)
  {
    const LineSpan<Real>& one = spans[i];
    if (one.first <= one.last && one.first <= whole.first + rounding &&
        one.certain_facing() != Real(0))
    {
      face = i;
      normal = facing_normal(path, view, faces[i], one.certain_facing());
    }
  }
  return hit_at<Real>(path, whole.first, normal);
}
// [cast_tetrahedron]

} // namespace cookbook
