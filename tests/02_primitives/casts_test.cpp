/// \file
/// What holds for a ray or a segment that is cast against a shape: formulas P8, P9, P10 and P12.

#include "02_primitives/casts/casts.hpp"
#include "02_primitives/casts/trial/casts_cases.hpp"
#include "common/math/rotation.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/verdicts.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace cookbook;

// [P8]
TEMPLATE_TEST_CASE(
    "a ray sinks by 4 a step: 4 above the floor, it meets at t = 1", "[P8]", float, double)
{
  const Plane<TestType> floor{{0, 1, 0}, 1};
  const auto hit = cast(Ray<TestType>{{0, 5, 0}, {3, -4, 0}}, floor);
  REQUIRE(hit);
  CHECK(hit->t == 1);
  CHECK(hit->point == Vector3<TestType>(3, 1, 0));
  CHECK(hit->normal == Vector3<TestType>(0, 1, 0));
  CHECK_FALSE(cast(Ray<TestType>{{0, 5, 0}, {3, 0, 0}}, floor)); // along it
  CHECK_FALSE(cast(Ray<TestType>{{0, 5, 0}, {3, 4, 0}}, floor)); // away
}
// [P8]

// [P9]
TEMPLATE_TEST_CASE(
    "a ball of radius 5, passed at 3: half a chord is 4, by 3-4-5", "[P9]", float, double)
{
  const Sphere<TestType> ball{{10, 3, 0}, 5};
  const auto hit = cast(Ray<TestType>{{0, 0, 0}, {2, 0, 0}}, ball);
  REQUIRE(hit);
  CHECK(hit->t == 3); // 10 - 4, in steps of 2
  CHECK(hit->point == Vector3<TestType>(6, 0, 0));
  CHECK((hit->normal - Vector3<double>(-0.8, -0.6, 0).cast<TestType>()).norm() <= 1e-7);
}

TEMPLATE_TEST_CASE(
    "a ball of radius 1, 10 km away and passed at 0.9: t = 9999.5641", "[P9]", float, double)
{
  const Sphere<TestType> ball{{10000, TestType(0.9), 0}, 1};
  const auto hit = cast(Ray<TestType>{{0, 0, 0}, {1, 0, 0}}, ball);
  REQUIRE(hit);
  CHECK(
      std::abs(double(hit->t) - (10000 - std::sqrt(0.19))) <=
      0x1p-10); // floats are as coarse there
  const Sphere<TestType> beside{{10000, TestType(1.5), 0}, 1};
  CHECK_FALSE(cast(Ray<TestType>{{0, 0, 0}, {1, 0, 0}}, beside));
}
// [P9]

// [cast_capsule_test]
TEMPLATE_TEST_CASE(
    "a capsule is met on its side, on its ends, and along its axis", "[P9]", float, double)
{
  using V = Vector3<TestType>;
  const Capsule<TestType> capsule{{{0, 0, 0}, {0, 8, 0}}, 5};
  const auto t = [&](const V& origin, const V& direction) {
    return cast(Ray<TestType>{origin, direction}, capsule)->t;
  };
  CHECK(t({-9, 4, 3}, {1, 0, 0}) == 5);  // the side, at 3 from the axis
  CHECK(t({-9, 11, 0}, {1, 0, 0}) == 5); // the upper ball, 3 above its centre
  CHECK(t({-9, -3, 0}, {1, 0, 0}) == 5); // the lower ball
  CHECK(t({0, 20, 0}, {0, -1, 0}) == 7); // along the axis
  CHECK(t({3, 20, 0}, {0, -1, 0}) == 8); // beside it
  CHECK_FALSE(cast(Ray<TestType>{{6, 20, 0}, {0, -1, 0}}, capsule));
}
// [cast_capsule_test]

// [P10]
TEMPLATE_TEST_CASE(
    "a ray along the edge of a box meets it at t = 1", "[P10][case:E3]", float, double)
{
  using V = Vector3<TestType>;
  const Aabb<TestType> box(V(0, 0, 0), V(1, 1, 1));
  const auto hit = cast(Ray<TestType>{{-1, 1, TestType(0.5)}, {1, 0, 0}}, box);
  REQUIRE(hit);
  CHECK(hit->t == 1);
  CHECK(hit->point == V(0, 1, TestType(0.5)));
  CHECK(hit->normal == V(-1, 0, 0));
  // x is entered at 1 and left at 2, y at 2 and 3: never in both.
  CHECK_FALSE(cast(Ray<TestType>{{-1, -2, TestType(0.5)}, {1, TestType(0.9), 0}}, box));
}
// [P10]

// [P12]
TEMPLATE_TEST_CASE(
    "a ray through the middle of a triangle, from both sides", "[P12]", float, double)
{
  using V = Vector3<TestType>;
  const Triangle<TestType> triangle{{0, 0, 2}, {3, 0, 2}, {0, 3, 2}};
  const auto up = cast(Ray<TestType>{{1, 1, 0}, {0, 0, 4}}, triangle);
  const auto down = cast(Ray<TestType>{{1, 1, 4}, {0, 0, -4}}, triangle);
  REQUIRE((up && down));
  CHECK((up->t == TestType(0.5) && down->t == TestType(0.5)));
  CHECK(up->normal == V(0, 0, -1));
  CHECK(down->normal == V(0, 0, 1));
  CHECK_FALSE(cast(Ray<TestType>{{2, 2, 0}, {0, 0, 4}}, triangle));
  CHECK(moller_trumbore(Ray<TestType>{{1, 1, 0}, {0, 0, 4}}, triangle) == TestType(0.5));
}
// [P12]

// [cast_seams]
TEST_CASE(
    "a million rays from within a turned octahedron at its edges and corners: all are stopped",
    "[P12][case:E7]")
{
  const Matrix3<float> turn = rational_rotation<double>(5, 1, 2, 3).cast<float>();
  std::vector<Vector3<float>> corners;
  for (int axis = 0; axis < 3; ++axis)
  {
    corners.push_back(turn.col(axis) * 3);
    corners.push_back(turn.col(axis) * -3);
  }
  std::mt19937 random(7);
  int misses = 0;
  for (int i = 0; i < 10 * random_inputs; ++i)
  {
    const std::size_t p = random() % 6, q = (p / 2 * 2 + 2 + random() % 4) % 6;
    const float fraction = random() % 16 == 0 ? 0 : static_cast<float>(random() % 65537) / 65536;
    const Vector3<float> seam = corners[p] + fraction * (corners[q] - corners[p]);
    const auto drawn = [&] { return static_cast<float>(random() % 2001) / 1000 - 1; };
    const Vector3<float> origin(drawn(), drawn() / 2, drawn() / 2);
    const Ray<float> ray{origin, seam - origin};
    bool met = false;
    for (std::size_t face = 0; face < 8 && !met; ++face)
    {
      const std::size_t x = face % 2, y = 2 + face / 2 % 2, z = 4 + face / 4;
      met = cast(ray, Triangle<float>{corners[x], corners[y], corners[z]}).has_value();
    }
    misses += met ? 0 : 1;
  }
  CHECK(misses == 0);
}
// [cast_seams]

namespace
{

/// Calls `ask(name, shape)` for one shape of each kind, all of which hold (1, 2, 3) inside them.
template <class Real, class Ask>
void for_each_target(const Real& size, const Ask& ask)
{
  using V = Vector3<Real>;
  const V p = V(1, 2, 3) * size;
  const auto at = [&](Real x, Real y, Real z) -> V { return p + V(x, y, z) * size; };
  const Matrix3<Real> axes = rational_rotation<double>(3, 1, 0, 2).template cast<Real>();
  ask("plane", Plane<Real>{{0, 0, -1}, -size});
  ask("sphere", Sphere<Real>{at(1, 0, 0), 2 * size});
  ask("capsule", Capsule<Real>{{at(1, 0, 0), at(5, 0, 0)}, 2 * size});
  ask("aabb", Aabb<Real>(at(-1, -1, -1), at(2, 2, 2)));
  ask("obb", Obb<Real>{p, axes, V(1, 1, 2) * size});
  ask("tetrahedron", Tetrahedron<Real>{at(-1, -1, -1), at(4, 0, 0), at(0, 4, 0), at(0, 0, 4)});
}

} // namespace

// [from_inside]
TEMPLATE_TEST_CASE("from inside: t = 0, the origin, and straight back", "[case:E6]", float, double)
{
  for (const TestType size : {TestType(1), TestType(1e-30), TestType(1e30)})
  {
    for_each_target<TestType>(
        size,
        [&](const char* name, const auto& shape)
        {
          INFO(name << ' ' << size);
          using V = Vector3<TestType>;
          const V origin = V(1, 2, 3) * size;
          const auto hit = cast(Ray<TestType>{origin, V(0, 3, 4) * size}, shape);
          REQUIRE(hit);
          CHECK(hit->t == 0);
          CHECK(hit->point == origin);
          CHECK((hit->normal - V(0, TestType(-0.6), TestType(-0.8))).norm() <= 1e-6);
          const V end = origin + V(0, 1, 0) * size;
          CHECK(cast(Segment<TestType>{origin, end}, shape)->t == 0);
        });
  }
}
// [from_inside]

TEMPLATE_TEST_CASE("a ray that starts on a box starts inside", "[P10]", float, double)
{
  using V = Vector3<TestType>;
  const Aabb<TestType> box(V(-1, -1, -1), V(1, 1, 1));
  const auto hit = cast(Ray<TestType>{{-1, 0, 0}, {3, 4, 0}}, box);
  REQUIRE(hit);
  CHECK(hit->t == 0);
  CHECK((hit->normal - V(TestType(-0.6), TestType(-0.8), 0)).norm() < TestType(1e-6));
}

// [zero_direction]
TEMPLATE_TEST_CASE("a zero direction meets what holds the origin, with +y", "[P8]", float, double)
{
  using V = Vector3<TestType>;
  for_each_target<TestType>(
      1,
      [](const char* name, const auto& shape)
      {
        INFO(name);
        const V in(1, 2, 3), out(-4, -5, -6);
        const auto hit = cast(Ray<TestType>{in, V(0, 0, 0)}, shape);
        REQUIRE(hit);
        CHECK((hit->t == 0 && hit->point == in && hit->normal == V(0, 1, 0)));
        CHECK_FALSE(cast(Ray<TestType>{out, V(0, 0, 0)}, shape));
        CHECK(cast(Segment<TestType>{in, in}, shape));
        CHECK_FALSE(cast(Segment<TestType>{out, out}, shape));
      });
  const Triangle<TestType> triangle{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}};
  CHECK(cast(Ray<TestType>{{1, 1, 1}, {0, 0, 0}}, triangle)->normal == V(0, 1, 0));
  CHECK_FALSE(cast(Ray<TestType>{{1, 1, 2}, {0, 0, 0}}, triangle));
}
// [zero_direction]

// [segments]
TEMPLATE_TEST_CASE("a segment reaches to its end, and no farther", "[P9]", float, double)
{
  const Sphere<TestType> ball{{0, 0, 0}, 1};
  const auto from_five_to = [&](TestType x) {
    return cast(Segment<TestType>{{5, 0, 0}, {x, 0, 0}}, ball);
  };
  CHECK(from_five_to(-3)->t == TestType(0.5));
  CHECK(from_five_to(1)->t == 1); // it ends on the surface
  CHECK_FALSE(from_five_to(TestType(1.0001)));
}
// [segments]

// [edge_side_test]
TEST_CASE("(1 + u)(1 − u) is less than 1, also where its double is not", "[P12]")
{
  const double u = 0x1p-52;
  const Vector3<double> p(1 + u, 1, 0), q(1, 1 - u, 0);
  CHECK(p.x() * q.y() - p.y() * q.x() == 0);
  CHECK(edge_side<double>(p, q) == -u * u);
  CHECK(edge_side<double>(q, p) == u * u);
}
// [edge_side_test]

// [in_the_plane]
TEMPLATE_TEST_CASE(
    "a ray in a triangle's plane meets its edge, straight back", "[P12]", float, double)
{
  using V = Vector3<TestType>;
  const Triangle<TestType> triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const auto hit = cast(Ray<TestType>{{-2, 1, 0}, {1, 0, 0}}, triangle);
  REQUIRE(hit);
  CHECK((hit->t == 2 && hit->point == V(0, 1, 0) && hit->normal == V(-1, 0, 0)));
  CHECK_FALSE(cast(Ray<TestType>{{-2, 5, 0}, {1, 0, 0}}, triangle));
  CHECK_FALSE(cast(Ray<TestType>{{-2, 1, 1}, {1, 0, 0}}, triangle));
  // Corners on a line, or all in one place: what is left is a segment, or a point.
  const Triangle<TestType> line{{0, 0, 0}, {1, 1, 1}, {4, 4, 4}},
      dot{{2, 2, 2}, {2, 2, 2}, {2, 2, 2}};
  CHECK(cast(Ray<TestType>{{2, 2, -3}, {0, 0, 1}}, line)->t == 5);
  CHECK(cast(Ray<TestType>{{2, 2, -3}, {0, 0, 1}}, dot)->t == 5);
  CHECK_FALSE(cast(Ray<TestType>{{2, 3, -3}, {0, 0, 1}}, line));
  CHECK_FALSE(cast(Ray<TestType>{{2, 3, -3}, {0, 0, 1}}, dot));
}
// [in_the_plane]

// [cast_degenerate]
TEMPLATE_TEST_CASE("radius 0, flat and empty boxes, mixed sizes", "[P9][P10]", float, double)
{
  using V = Vector3<TestType>;
  const Ray<TestType> along{{-3, 0, 0}, {2, 0, 0}};
  const auto dot = cast(along, Sphere<TestType>{{1, 0, 0}, 0});
  REQUIRE(dot);
  CHECK((dot->t == 2 && dot->normal == V(-1, 0, 0)));
  const auto wire = cast(along, Capsule<TestType>{{{1, -1, 0}, {1, 1, 0}}, 0});
  REQUIRE(wire);
  CHECK((wire->t == 2 && wire->normal == V(-1, 0, 0)));
  CHECK(cast(along, Aabb<TestType>(V(1, -1, -1), V(1, 1, 1)))->t == 2);
  CHECK_FALSE(cast(along, Aabb<TestType>()));
  // A speck, far away, and dead ahead.
  const TestType large = TestType(1e30), tiny = TestType(1e-30);
  const auto tiny_sphere =
      cast(Ray<TestType>{{-large, 0, 0}, {tiny, 0, 0}}, Sphere<TestType>{{0, 0, 0}, tiny});
  REQUIRE(tiny_sphere);
  CHECK(tiny_sphere->point.norm() <= tiny * 2);
  CHECK(tiny_sphere->normal == V(-1, 0, 0));
  CHECK_FALSE(cast(Ray<TestType>{{-large, 1, 0}, {tiny, 0, 0}}, Sphere<TestType>{{0, 0, 0}, tiny}));
}
// [cast_degenerate]

// [cast_targets]
TEST_CASE("what has no size is no target: two points or lines hardly ever meet", "[P8]")
{
  STATIC_REQUIRE(CastTarget<double, Triangle<double>>);
  STATIC_REQUIRE_FALSE(CastTarget<double, Segment<double>>);
  STATIC_REQUIRE_FALSE(CastTarget<double, Vector3<double>>);
}
// [cast_targets]

// [P19]
TEST_CASE("two balls on their way touch where a ray meets one ball with both radii", "[P19]")
{
  // B is 3 ahead and 4 aside of where A passes; A moves by 10: they touch when 4 and 3 make 5.
  const Sphere<double> a{{-6, 0, 0}, 2}, b{{0, 4, 0}, 3};
  const Vector3<double> displacement(10, 0, 0);
  const auto hit = cast(
      Segment<double>{a.center, a.center + displacement},
      Sphere<double>{b.center, a.radius + b.radius});
  REQUIRE(hit);
  CHECK(std::abs(hit->t - 0.3) <= 0x1p-52);
  CHECK((hit->point - b.center).norm() == Catch::Approx(a.radius + b.radius).epsilon(1e-15));
  // The smaller root: at the larger one, t = 0.9, they part.
  const Vector3<double> later = a.center + 0.9 * displacement;
  CHECK((later - b.center).norm() == Catch::Approx(5).epsilon(1e-15));
}
// [P19]

// [casts_cases_test]
TEST_CASE(
    "each way to cast a ray holds or fails as the table says",
    "[case:E1][case:E2][case:E3][case:E4][case:E6][case:E7][case:E9][case:X29][case:X30][case:X31]"
    "[case:X34][long]")
{
  const std::string published = "as published", taught = "as taught", best = "recommended";
  check_verdicts(
      cast_verdicts(), names_of(cast_methods()),
      {{"E1", {taught, best}},
       {"X29", {taught, best}},
       {"E2", {taught, best}},
       {"X31", {taught, best}},
       {"E3", {best}},
       {"E4", {best}},
       {"X30", {best}},
       {"E6", {best}},
       {"from inside a box", {best}},
       {"E7", {best}},
       {"E9", {taught, best}},
       {"X34", {taught, best}},
       {"a direction of length 2", {taught, best}},
       {"a sphere of 1e-25 m, 3e-25 m away", {best}},
       {"a triangle from behind", {taught, best}},
       {"a triangle with edges of 0.5 mm", {published, best}}});
}
// [casts_cases_test]

TEST_CASE("a ray that touches a tetrahedron at a corner has a normal out of it", "[casts]")
{
  const Ray<double> ray{{-6, 7, 5}, {3, -2, -3}};
  const Tetrahedron<double> solid{{0, 2, 1}, {0, 3, -1}, {0, 1, 0}, {-1, -1, -2}};
  const auto hit = cast(ray, solid);
  REQUIRE(hit);
  for (const Vector3<double>& corner : {solid.a, solid.b, solid.c, solid.d})
  {
    CHECK(hit->normal.dot(corner - hit->point) <= 1e-12);
  }
}
