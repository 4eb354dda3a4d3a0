#pragma once

/// \file
/// \brief Pairs of triangles, whether exactly they meet, and other libraries' ways to find out.

#include "02_primitives/overlap_chart/trial/known_pair.hpp"
#include "02_primitives/shapes/trial/bullet_shapes.hpp"
#include "02_primitives/shapes/trial/in_fractions.hpp"
#include "02_primitives/shapes/trial/number_draw.hpp"
#include "02_primitives/triangle_triangle/triangle_triangle.hpp"

#ifdef COOKBOOK_HAS_BULLET
#include <BulletCollision/Gimpact/btTriangleShapeEx.h>
#endif
#ifdef COOKBOOK_HAS_FCL
#include <fcl/narrowphase/detail/traversal/collision/intersect.h>
#endif

#include <vector>

namespace cookbook
{

/// Two triangles, and whether they meet.
using KnownTriangles = KnownPair<Triangle<double>>;

// [triangle_pairs]
/// Triangles with corners in a cube of 2 m, in floats, so that all libraries are asked the same.
/// Where they shall be `neighbours`, in turn: one plane, a corner shared, an edge shared, a corner
/// of b on a face of a, but for rounding.
inline std::vector<KnownTriangles> known_triangles_in_pairs(int count, bool neighbours)
{
  FloatDraw draw(20261123);
  const auto corner = [&]() -> Vector3<double> { return draw.in_cube(1).cast<double>(); };
  const auto in_floats = [](const Vector3<double>& p) -> Vector3<double>
  { return p.cast<float>().cast<double>(); };
  std::vector<KnownTriangles> pairs;
  for (int i = 0; i < count; ++i)
  {
    const Triangle<double> a{corner(), corner(), corner()};
    Triangle<double> b{corner(), corner(), corner()};
    const auto in_plane_of_a = [&]
    {
      const double s = draw.between(-1, 2), t = draw.between(-1, 2);
      return in_floats(a.a + s * (a.b - a.a) + t * (a.c - a.a));
    };
    switch (neighbours ? i % 4 : -1)
    {
    case 0:
      b = {in_plane_of_a(), in_plane_of_a(), in_plane_of_a()};
      break;
    case 1:
      b.a = a.a;
      break;
    case 2:
      b = {a.a, a.b, b.c};
      break;
    case 3:
      b.a = in_floats((a.a + a.b + 2 * a.c) / 4);
      break;
    default:
      break;
    }
    pairs.push_back({a, b, triangles_meet_by_17_axes(in_fractions(a), in_fractions(b))});
  }
  return pairs;
}
// [triangle_pairs]

#ifdef COOKBOOK_HAS_FCL
/// FCL's answer, in double.
inline bool fcl_meet(const Triangle<double>& a, const Triangle<double>& b)
{
  return fcl::detail::Intersect<double>::intersect_Triangle(a.a, a.b, a.c, b.a, b.b, b.c);
}
#endif

#ifdef COOKBOOK_HAS_BULLET
/// Bullet's answer, in float, without the margin around its triangles.
inline bool bullet_meet(const Triangle<double>& a, const Triangle<double>& b)
{
  const auto of = [](const Triangle<double>& t)
  {
    btPrimitiveTriangle all;
    all.m_vertices[0] = of_bullet(t.a.cast<float>());
    all.m_vertices[1] = of_bullet(t.b.cast<float>());
    all.m_vertices[2] = of_bullet(t.c.cast<float>());
    all.m_margin = 0;
    all.buildTriPlane();
    return all;
  };
  btPrimitiveTriangle one = of(a), other = of(b);
  GIM_TRIANGLE_CONTACT contacts;
  return one.overlap_test_conservative(other) &&
         one.find_triangle_collision_clip_method(other, contacts);
}
#endif

} // namespace cookbook
