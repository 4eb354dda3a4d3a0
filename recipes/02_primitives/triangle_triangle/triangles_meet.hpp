#pragma once

/// \file
/// \brief Whether two triangles meet, decided by signs without an error.

#include "02_primitives/triangle_triangle/triangle_triangle.hpp"

namespace cookbook
{

/// Signs without an error, for what follows to ask; a trial asks rounded ones.
struct ExactSigns
{
  /// On which side of the plane of a, b and c the point d is.
  int side(
      const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c,
      const Vector3<double>& d) const
  {
    return orient3d(a, b, c, d);
  }

  /// Which way a, b and c turn, seen along the axis k.
  int turn(
      const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c, int k) const
  {
    return orient2d(a, b, c, k);
  }
};

/// Whether the segments pq and rs meet, seen along the axis k.
template <class Signs>
bool segments_meet_seen_along(
    const Signs& signs, const Vector3<double>& p, const Vector3<double>& q,
    const Vector3<double>& r, const Vector3<double>& s, int k)
{
  const bool across = signs.turn(p, q, r, k) * signs.turn(p, q, s, k) <= 0 &&
                      signs.turn(r, s, p, k) * signs.turn(r, s, q, k) <= 0;
  bool boxes_meet = true;
  for (int i = 0; i < 3; ++i)
  {
    boxes_meet = boxes_meet && std::max(p[i], q[i]) >= std::min(r[i], s[i]) &&
                 std::max(r[i], s[i]) >= std::min(p[i], q[i]);
  }
  return across && boxes_meet;
}

/// Whether they meet in space: in one plane, and seen along each axis.
template <class Signs>
bool segments_meet(
    const Signs& signs, const Vector3<double>& p, const Vector3<double>& q,
    const Vector3<double>& r, const Vector3<double>& s)
{
  return signs.side(p, q, r, s) == 0 && segments_meet_seen_along(signs, p, q, r, s, 0) &&
         segments_meet_seen_along(signs, p, q, r, s, 1) &&
         segments_meet_seen_along(signs, p, q, r, s, 2);
}

// [edge_meets]
/// Whether three signs are all 0 or more, or all 0 or less.
inline bool agree(int one, int other, int third)
{
  return (one >= 0 && other >= 0 && third >= 0) || (one <= 0 && other <= 0 && third <= 0);
}

/// Whether a point of a triangle's plane is in the triangle, which is no line: seen along each
/// axis.
template <class Signs>
bool holds_in_plane(const Signs& signs, const Triangle<double>& t, const Vector3<double>& p)
{
  bool inside = signs.side(t.a, t.b, t.c, p) == 0;
  bool has_area = false;
  for (int k = 0; k < 3; ++k)
  {
    inside =
        inside &&
        agree(signs.turn(t.a, t.b, p, k), signs.turn(t.b, t.c, p, k), signs.turn(t.c, t.a, p, k));
    has_area = has_area || signs.turn(t.a, t.b, t.c, k) != 0;
  }
  return inside && has_area;
}

/// Whether the edge pq goes through a triangle; touching counts.
template <class Signs>
bool edge_meets(
    const Signs& signs, const Vector3<double>& p, const Vector3<double>& q,
    const Triangle<double>& t)
{
  const int side_p = signs.side(t.a, t.b, t.c, p), side_q = signs.side(t.a, t.b, t.c, q);
  if (side_p == 0 && side_q == 0)
  {
    return segments_meet(signs, p, q, t.a, t.b) || segments_meet(signs, p, q, t.b, t.c) ||
           segments_meet(signs, p, q, t.c, t.a) || holds_in_plane(signs, t, p);
  }
  return side_p * side_q <= 0 &&
         agree(signs.side(p, q, t.a, t.b), signs.side(p, q, t.b, t.c), signs.side(p, q, t.c, t.a));
}
// [edge_meets]

/// Whether two triangles have a point in common: an edge of one goes through the other.
///
/// Without an error, for numbers from 1e-90 to 1e100; triangles may be flat, or points.
template <class Real, class Signs = ExactSigns>
bool triangles_meet(const Triangle<Real>& one, const Triangle<Real>& other, const Signs& signs = {})
{
  const auto in_double = [](const Triangle<Real>& t)
  {
    return Triangle<double>{
        t.a.template cast<double>(), t.b.template cast<double>(), t.c.template cast<double>()};
  };
  const Triangle<double> a = in_double(one), b = in_double(other);
  return edge_meets(signs, a.a, a.b, b) || edge_meets(signs, a.b, a.c, b) ||
         edge_meets(signs, a.c, a.a, b) || edge_meets(signs, b.a, b.b, a) ||
         edge_meets(signs, b.b, b.c, a) || edge_meets(signs, b.c, b.a, a);
}

} // namespace cookbook
