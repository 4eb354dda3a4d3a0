/// \file
/// What holds for the manifold of a sphere and a capsule.

#include "02_primitives/shapes/trial/number_draw.hpp"
#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"
#include "03_sphere_manifolds/sphere_capsule/sphere_capsule.hpp"

#include "tests/catch.hpp"

#include <array>
#include <cmath>
#include <limits>

using namespace cookbook;

namespace
{

/// The plain function and the hardened one.
const std::array rungs{plain_sphere_capsule<double>, sphere_capsule<double>};

constexpr double rounding = 1e-14;

/// A capsule along (3,4,0), 10 long, so that its unit direction is (0.6, 0.8, 0).
const Capsule<double> slanted{{{0, 0, 0}, {6, 8, 0}}, 1};

} // namespace

// [sphere_capsule]
TEST_CASE("a ball 5 off a capsule's axis, radii 4.5 and 1, is 0.5 deep", "[P2][S1]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Manifold<double> manifold = manifold_of({{7, 1, 0}, 4.5}, slanted).value();
  CHECK(manifold.depth == Catch::Approx(0.5).epsilon(rounding));
  CHECK((manifold.normal - Vector3<double>(-0.8, 0.6, 0)).norm() <= rounding);
  // 4.5 - 0.25 from the ball's centre.
  const Vector3<double> contact = Vector3<double>(7, 1, 0) + 4.25 * Vector3<double>(-0.8, 0.6, 0);
  CHECK((manifold.points[0].position - contact).norm() <= rounding);
}

TEST_CASE("beyond a capsule's end a ball meets the ball at that end", "[S1]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Sphere<double> sphere{{9, 12, 0}, 4.5}; // 5 beyond the end, along the axis
  const Manifold<double> capsule = manifold_of(sphere, slanted).value();
  const Manifold<double> end = sphere_sphere<double>(sphere, {{6, 8, 0}, 1}).value();
  CHECK(capsule.depth == Catch::Approx(0.5).epsilon(rounding));
  CHECK((capsule.normal - end.normal).norm() <= rounding);
}
// [sphere_capsule]

TEST_CASE("a capsule of length 0 is a sphere, and a ball too far away has no manifold", "[S1]")
{
  const Capsule<double> dot{{{1, 0, 0}, {1, 0, 0}}, 1};
  CHECK(sphere_capsule<double>({{0, 0, 0}, 0.5}, dot)->depth == 0.5);
  CHECK_FALSE(sphere_capsule<double>({{7, 1, 0}, 3.9}, slanted));
}

// [on_the_axis]
TEST_CASE("a ball centred on a capsule's axis leaves perpendicular to it", "[case:C3]")
{
  const auto normal_of = [](const Capsule<double>& capsule)
  {
    const Vector3<double> middle = (capsule.segment.start + capsule.segment.end) / 2;
    const Manifold<double> manifold = sphere_capsule<double>({middle, 0.5}, capsule).value();
    CHECK(manifold.depth == 1.5);
    return manifold.normal;
  };
  // As close to +y as is perpendicular to the axis; +x where the axis itself is y.
  CHECK((normal_of(slanted) - Vector3<double>(-0.8, 0.6, 0)).norm() <= rounding);
  CHECK(normal_of({{{-2, 0, 0}, {2, 0, 0}}, 1}) == Vector3<double>(0, 1, 0));
  CHECK(normal_of({{{0, 0, -2}, {0, 0, 2}}, 1}) == Vector3<double>(0, 1, 0));
  CHECK(normal_of({{{0, -2, 0}, {0, 2, 0}}, 1}) == Vector3<double>(1, 0, 0));
  CHECK(normal_of({{{1, 2, 3}, {1, 2, 3}}, 1}) == Vector3<double>(0, 1, 0));
}

TEST_CASE(
    "a ball centred on the axis but for rounding still leaves perpendicular to it", "[case:C3]")
{
  const Vector3<double> along = slanted.segment.end.normalized();
  for (int i = 1; i < 1000; ++i)
  {
    const Vector3<double> center = slanted.segment.start + i * 0.001 * slanted.segment.end;
    const Manifold<double> manifold = sphere_capsule<double>({center, 0.5}, slanted).value();
    REQUIRE(std::abs(manifold.normal.dot(along)) <= rounding);
    REQUIRE(manifold.depth == Catch::Approx(1.5).epsilon(rounding));
  }
}

TEMPLATE_TEST_CASE(
    "a ball centred on either end of a segment leaves perpendicular to it, by both radii",
    "[case:C3]", float, double)
{
  // start + (end - start) is the end but for rounding; in float, computed in double, it is the end
  // itself unless the start is far away.
  using Real = TestType;
  using Point = Vector3<Real>;
  const Point from(Real(-0.1), 0, 0), to(Real(0.3), 0, 0);
  const Manifold<Real> named = sphere_capsule<Real>({to, 0.5}, {{from, to}, 0.25}).value();
  CHECK(named.normal == Point(0, 1, 0));
  CHECK(named.depth == Real(0.75));
  NumberDraw<Real> draw(1);
  int not_perpendicular = 0, not_deep = 0, not_the_end = 0;
  for (int i = 0; i < 1000; ++i)
  {
    Point start = draw.in_cube(1);
    start.x() *= i % 2 == 0 ? Real(1) : Real(0x1p33);
    const Segment<Real> segment{start, draw.in_cube(1)};
    const Point along = (segment.end - segment.start).normalized();
    for (const Point& end : {segment.start, segment.end})
    {
      const Manifold<Real> manifold = sphere_capsule<Real>({end, 0.5}, {segment, 0.25}).value();
      const Real tolerance = 8 * std::numeric_limits<Real>::epsilon();
      not_perpendicular += std::abs(manifold.normal.dot(along)) <= tolerance ? 0 : 1;
      not_deep += manifold.depth == Real(0.75) ? 0 : 1;
      const Segment<double> wide{widen(segment.start), widen(segment.end)};
      not_the_end += closest_point<double>(wide, widen(end)) == widen(end) ? 0 : 1;
    }
  }
  CHECK(not_perpendicular == 0);
  CHECK(not_deep == 0);
  CHECK(not_the_end == 0);
}
// [on_the_axis]

TEST_CASE("beside a slanted beam of 1 km, a float ball 5 off the axis is 2^-20 deep", "[P2]")
{
  const Capsule<float> beam{{{0, 0, 0}, {600, 800, 0}}, 0.5f};
  for (int k = 1; k < 200; ++k)
  {
    CAPTURE(k);
    // (3k, 4k) lies on the axis, and (-4, 3) is perpendicular to it: all numbers are whole.
    const Vector3<float> center(static_cast<float>(3 * k - 4), static_cast<float>(4 * k + 3), 0);
    const auto manifold = sphere_capsule<float>({center, 4.5f + 0x1p-20f}, beam);
    REQUIRE(manifold);
    // In double the axis is right to 1e-13 m; the depth is rounded to float.
    CHECK(std::abs(manifold->depth - 0x1p-20f) <= 1e-12f);
  }
}

TEST_CASE("a float ball 1e-6 from touching a 1 km capsule gets that gap right", "[P2]")
{
  // In float the closest point would be rounded to 6e-5 m; the wider type keeps the distance.
  const Capsule<float> beam{{{0, 0, 0}, {1000, 0, 0}}, 0.5f};
  const Sphere<float> sphere{{777.7f, 1.0f - 0x1p-20f, 0}, 0.5f};
  const Manifold<float> manifold = sphere_capsule(sphere, beam).value();
  CHECK(manifold.depth == 0x1p-20f);
  CHECK(manifold.normal == Vector3<float>(0, -1, 0));
}
