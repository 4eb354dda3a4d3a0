#pragma once

/// \file
/// \brief Pairs of triangles that break some way to ask whether they meet.

#include "02_primitives/closest_points/closest_points.hpp"
#include "02_primitives/triangle_triangle/triangles_meet.hpp"
#include "tools/program/verdicts.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to ask, by name.
struct TrianglesMethod
{
  std::string name; ///< as on the page
  bool (*meet)(const Triangle<double>&, const Triangle<double>&);
};

/// Signs of volumes and areas as they come out, rounded: our model of tests by sides as published.
struct RoundedSigns
{
  /// On which side of a plane.
  int side(
      const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c,
      const Vector3<double>& d) const
  {
    const double volume = (a - d).dot((b - d).cross(c - d));
    return volume < 0 ? -1 : volume > 0 ? 1 : 0;
  }

  /// Which way three points turn.
  int turn(
      const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c, int k) const
  {
    const double area = (b - a).cross(c - a)[k];
    return area < 0 ? -1 : area > 0 ? 1 : 0;
  }
};

/// The ways that compete, the exact one last.
inline std::array<TrianglesMethod, 6> triangle_triangle_methods()
{
  const auto in_float = [](const Triangle<double>& a, const Triangle<double>& b)
  {
    const auto rounded = [](const Triangle<double>& t) {
      return Triangle<float>{t.a.cast<float>(), t.b.cast<float>(), t.c.cast<float>()};
    };
    return triangles_meet_by_17_axes(rounded(a), rounded(b));
  };
  return {
      {{"11 axes", triangles_meet_by_11_axes<double>},
       {"17 axes in float", in_float},
       {"rounded signs", [](const Triangle<double>& a, const Triangle<double>& b)
        { return triangles_meet(a, b, RoundedSigns{}); }},
       {"17 axes", triangles_meet_by_17_axes<double>},
       {"GJK", [](const Triangle<double>& a, const Triangle<double>& b)
        { return closest_points(a, b).distance == 0; }},
       {"exact signs", [](const Triangle<double>& a, const Triangle<double>& b)
        { return triangles_meet(a, b); }}}};
}

/// Two triangles and whether they meet.
struct TrianglesCase
{
  std::string id;   ///< in the book; empty for a neighbour of the case above
  std::string what; ///< in words
  Triangle<double> a, b;
  bool meet;
};

/// The pairs to try.
inline std::vector<TrianglesCase> triangle_triangle_cases()
{
  const Vector3<double> shared(76.582, 54.6752, 14.7879);
  return {
      {"F1",
       "one plane, 6 m apart",
       {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
       {{5, 5, 0}, {6, 5.3, 0}, {5.2, 6, 0}},
       false},
      {"F2",
       "one plane, one in the other",
       {{-1, 0, 0}, {2, 0, -2}, {2, 0, 2}},
       {{0.551, 0, -0.796}, {1.224, 0, 0.326}, {3.469, 0, 1}},
       true},
      {"F3",
       "one plane, a corner shared",
       {{76.648, 54.6752, 15.0012}, {76.648, 54.6752, 14.5542}, shared},
       {{76.6252, 54.6752, 14.892}, shared, {76.5617, 54.6752, 14.7929}},
       true},
      {"F5",
       "one plane, 10.7 m apart",
       {{12.3015, -0.253368, 5.49101}, {18.6765, -2.55337, 4.91756}, {12.3015, -2.55337, 4.91756}},
       {{-11.9885, -0.253368, 5.49101},
        {1.61448, -0.253368, 5.49101},
        {1.61448, -2.55337, 4.91756}},
       false},
      {"",
       "an edge along an edge, turned",
       {{0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}, {0.1, 1.2, 0.3}},
       {{0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}, {1.1, 0.2, 0.3}},
       true},
      {"",
       "1e-17 m above the middle",
       {{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}},
       {{0, 1e-17, 0}, {1, 1, 0}, {-1, 1, 0}},
       false},
      {"",
       "a triangle that is a point, on an edge",
       {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
       {{2, 2, 0}, {2, 2, 0}, {2, 2, 0}},
       true}};
}

/// In how many of the 72 orders of the corners and the triangles a way is right.
inline Verdict triangles_verdict(const TrianglesMethod& method, const TrianglesCase& one)
{
  int right = 0;
  const auto reordered = [](const Triangle<double>& t, std::size_t order)
  {
    const std::array<Vector3<double>, 3> c{t.a, t.b, t.c};
    const std::size_t first = order % 3, step = 1 + order / 3;
    return Triangle<double>{c[first], c[(first + step) % 3], c[(first + 2 * step) % 3]};
  };
  for (std::size_t i = 0; i < 36; ++i)
  {
    const Triangle<double> a = reordered(one.a, i / 6), b = reordered(one.b, i % 6);
    right += method.meet(a, b) == one.meet;
    right += method.meet(b, a) == one.meet;
  }
  const std::string wrong = std::to_string(72 - right) + " of 72 orders wrong";
  return {right == 72, right == 72 ? "right" : wrong};
}

/// The verdicts on all ways, case by case.
inline std::vector<VerdictRow> triangle_triangle_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const TrianglesCase& one : triangle_triangle_cases())
  {
    rows.push_back({one.id, one.what, {}});
    for (const TrianglesMethod& method : triangle_triangle_methods())
    {
      rows.back().verdicts.push_back(triangles_verdict(method, one));
    }
  }
  return rows;
}

} // namespace cookbook
