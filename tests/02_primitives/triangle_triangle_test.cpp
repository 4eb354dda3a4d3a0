/// \file
/// What holds for two triangles: formulas P16 and P17, and the pairs that break a way to answer.

#include "02_primitives/overlaps/overlaps.hpp"
#include "02_primitives/shapes/trial/in_fractions.hpp"
#include "02_primitives/triangle_triangle/trial/triangle_triangle_cases.hpp"
#include "02_primitives/triangle_triangle/triangles_meet.hpp"

#include "tests/02_primitives/shape_oracle.hpp"
#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/verdicts.hpp"

using namespace cookbook;

namespace
{

Rational volume(
    const Vector3<Rational>& a, const Vector3<Rational>& b, const Vector3<Rational>& c,
    const Vector3<Rational>& d)
{
  const Vector3<Rational> p = a - d, q = b - d, r = c - d;
  return p.x() * (q.y() * r.z() - q.z() * r.y()) + p.y() * (q.z() * r.x() - q.x() * r.z()) +
         p.z() * (q.x() * r.y() - q.y() * r.x());
}

bool is_flat(const Triangle<double>& t)
{
  return orient2d(t.a, t.b, t.c, 0) == 0 && orient2d(t.a, t.b, t.c, 1) == 0 &&
         orient2d(t.a, t.b, t.c, 2) == 0;
}

} // namespace

// [P16]
TEST_CASE("the side of a plane is that of exact fractions, also next to the plane", "[P16]")
{
  ShapeDraw<double> from(3);
  int on_plane = 0;
  for (const Draws draws : {Draws::lattice, Draws::thin, Draws::distant})
  {
    from.use(draws);
    for (int i = 0; i < random_inputs / 10; ++i)
    {
      const Tetrahedron<double> t = drawn<Tetrahedron<double>>(from);
      const Rational exactly = volume(
          exact<Rational>(t.a), exact<Rational>(t.b), exact<Rational>(t.c), exact<Rational>(t.d));
      REQUIRE(orient3d(t.a, t.b, t.c, t.d) == exactly.sign());
      on_plane += exactly.sign() == 0;
    }
  }
  CHECK(on_plane > random_inputs / 100);
}
// [P16]

// [P17]
TEST_CASE("17 axes of exact fractions and exact signs agree on triangles", "[P17]")
{
  ShapeDraw<double> from(5);
  int meeting = 0;
  for (const Draws draws : {Draws::any, Draws::lattice, Draws::thin})
  {
    from.use(draws);
    for (int i = 0; i < random_inputs / 20; ++i)
    {
      const Triangle<double> a = drawn<Triangle<double>>(from), b = drawn<Triangle<double>>(from);
      if (is_flat(a) || is_flat(b))
      {
        continue;
      }
      const bool meet = triangles_meet(a, b);
      REQUIRE(meet == triangles_meet_by_17_axes(in_fractions(a), in_fractions(b)));
      meeting += meet;
    }
  }
  CHECK(meeting > random_inputs / 200);
}
// [P17]

TEST_CASE("triangles in one plane are told apart by the 6 axes of the plane", "[P17]")
{
  ShapeDraw<double> from(9);
  from.use(Draws::lattice);
  int only_by_17 = 0;
  for (int i = 0; i < random_inputs / 20; ++i)
  {
    Triangle<double> a = drawn<Triangle<double>>(from), b = drawn<Triangle<double>>(from);
    a.a.y() = a.b.y() = a.c.y() = b.a.y() = b.b.y() = b.c.y() = 1;
    if (!is_flat(a) && !is_flat(b))
    {
      REQUIRE(triangles_meet(a, b) == triangles_meet_by_17_axes(a, b));
      only_by_17 += triangles_meet_by_11_axes(a, b) && !triangles_meet(a, b);
    }
  }
  CHECK(only_by_17 > 0);
}

TEST_CASE("flat triangles are segments and points, answered as those", "[triangle_triangle]")
{
  ShapeDraw<double> from(11);
  from.use(Draws::lattice);
  for (int i = 0; i < random_inputs / 4; ++i)
  {
    Triangle<double> a = drawn<Triangle<double>>(from), b = drawn<Triangle<double>>(from);
    a.c = i % 3 == 0 ? a.b : Vector3<double>(a.a / 2 + a.b / 2);
    b.c = i % 2 == 0 ? b.c : Vector3<double>(b.a / 4 + b.b * 0.75);
    REQUIRE(triangles_meet(a, b) == overlaps(a, b));
    REQUIRE(triangles_meet(b, a) == overlaps(a, b));
  }
}

// [triangle_verdicts]
TEST_CASE(
    "which way to ask two triangles holds in which case", "[case:F1][case:F2][case:F3][case:F5]")
{
  check_verdicts(
      triangle_triangle_verdicts(), names_of(triangle_triangle_methods()),
      {{"F1", {"17 axes in float", "rounded signs", "17 axes", "GJK", "exact signs"}},
       {"F2", {"11 axes", "17 axes in float", "rounded signs", "17 axes", "GJK", "exact signs"}},
       {"F3", {"11 axes", "17 axes in float", "rounded signs", "17 axes", "GJK", "exact signs"}},
       {"F5", {"17 axes in float", "17 axes", "GJK", "exact signs"}},
       {"an edge along an edge, turned",
        {"11 axes", "17 axes in float", "rounded signs", "17 axes", "GJK", "exact signs"}},
       {"1e-17 m above the middle",
        {"11 axes", "17 axes in float", "rounded signs", "17 axes", "exact signs"}},
       {"a triangle that is a point, on an edge",
        {"11 axes", "17 axes in float", "rounded signs", "17 axes", "GJK", "exact signs"}}});
}
// [triangle_verdicts]
