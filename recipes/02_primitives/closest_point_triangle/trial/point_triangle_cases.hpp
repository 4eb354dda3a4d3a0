#pragma once

/// \file
/// \brief Points and triangles that break some way to find the closest point.

#include "02_primitives/closest_points/closest_points.hpp"
#include "tools/program/verdicts.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to find the closest point, by name.
struct PointTriangleMethod
{
  std::string name; ///< as on the page
  Vector3<double> (*answer)(const Triangle<double>&, const Vector3<double>&);
};

/// Our model of a published test: the foot on the plane, if the three normals of the triangles that
/// it makes with the edges point the same way, or else an edge; X32.
inline Vector3<double> closest_by_normals(const Triangle<double>& t, const Vector3<double>& p)
{
  const Vector3<double> normal = (t.b - t.a).cross(t.c - t.a).normalized();
  const Vector3<double> foot = p - normal.dot(p - t.a) * normal;
  const Vector3<double> a = t.a - foot, b = t.b - foot, c = t.c - foot;
  const Vector3<double> over_a = b.cross(c), over_b = c.cross(a), over_c = a.cross(b);
  if (!(over_a.dot(over_b) < 0) && !(over_a.dot(over_c) < 0))
  {
    return foot;
  }
  const Vector3<double> corners[] = {t.a - p, t.b - p, t.c - p};
  Nearest<double> edge = nearest_on_segment(corners, 0, 1);
  edge = closer_of(edge, nearest_on_segment(corners, 1, 2));
  edge = closer_of(edge, nearest_on_segment(corners, 2, 0));
  return p + edge.point;
}

/// The foot on the plane with its shares pushed up to zero: not the closest point beyond an edge.
inline Vector3<double>
closest_by_clamped_fractions(const Triangle<double>& t, const Vector3<double>& p)
{
  const Vector3<double> u = t.b - t.a, v = t.c - t.a, w = p - t.a;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), wu = w.dot(u), wv = w.dot(v);
  const double whole = uu * vv - uv * uv;
  const double of_b = std::max(0.0, (wu * vv - wv * uv) / whole);
  const double of_c = std::max(0.0, (wv * uu - wu * uv) / whole);
  const double sum = std::max(1.0, of_b + of_c);
  return t.a + of_b / sum * u + of_c / sum * v;
}

/// The ways that compete, ours last.
inline std::array<PointTriangleMethod, 3> point_triangle_methods()
{
  return {
      {{"signs of normals", closest_by_normals},
       {"clamped shares", closest_by_clamped_fractions},
       {"face, then edges", [](const Triangle<double>& t, const Vector3<double>& p)
        { return closest_points(p, t).b; }}}};
}

/// A triangle, a point and the closest point of the triangle, by hand.
struct PointTriangleCase
{
  std::string id;   ///< in the book; empty for a neighbour of the case above
  std::string what; ///< in words
  Triangle<double> triangle;
  Vector3<double> point, closest;
};

/// The points to try.
inline std::vector<PointTriangleCase> point_triangle_cases()
{
  const Triangle<double> half{{0, 1, 0}, {0, 0, 0}, {1, 0, 0}};
  return {
      {"D10", "in line with an edge, 4 m away", half, {5, 0, 0}, {1, 0, 0}},
      {"", "above the middle", half, {0.25, 0.25, 3}, {0.25, 0.25, 0}},
      {"", "beyond a corner of 20°", {{0, 0, 0}, {11, 2, 0}, {11, -2, 0}}, {-1, 3, 0}, {0, 0, 0}},
      {"",
       "beside a triangle that is a line",
       {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}},
       {3, 2, 0},
       {3, 0, 0}}};
}

/// The verdicts on all ways, case by case.
inline std::vector<VerdictRow> point_triangle_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const PointTriangleCase& one : point_triangle_cases())
  {
    rows.push_back({one.id, one.what, {}});
    for (const PointTriangleMethod& method : point_triangle_methods())
    {
      const Vector3<double> answer = method.answer(one.triangle, one.point);
      const bool holds = (answer - one.closest).norm() < 1e-12;
      const bool is_number = answer.allFinite();
      rows.back().verdicts.push_back(
          {holds, holds       ? "right"
                  : is_number ? "another point"
                              : "not a number"});
    }
  }
  return rows;
}

} // namespace cookbook
