/// \file
/// What holds for shapes so large that the squares of their numbers do not fit: the answers are
/// those of small shapes, enlarged, and no finite number turns into NaN.

#include "03_sphere_manifolds/sphere_box/sphere_box.hpp"
#include "03_sphere_manifolds/sphere_capsule/sphere_capsule.hpp"
#include "03_sphere_manifolds/sphere_plane/sphere_plane.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

namespace
{

/// Exponents of two at which sums of squares, then squares, and then sums no longer fit.
template <class Real>
std::vector<int> exponents()
{
  const int most = std::numeric_limits<Real>::max_exponent;
  return {0, most / 2, most / 2 + 4, most - 5};
}

template <class Real>
void expect_enlarged(
    const std::optional<Manifold<Real>>& large, const std::optional<Manifold<Real>>& small,
    int exponent)
{
  REQUIRE(small);
  REQUIRE(large);
  CHECK(large->normal == small->normal);
  CHECK(large->depth == std::ldexp(small->depth, exponent));
  CHECK(large->points[0].depth == large->depth);
  const Vector3<Real> position = scaled(small->points[0].position, exponent);
  CHECK(large->points[0].position == position);
}

} // namespace

TEMPLATE_TEST_CASE("a ball and a plane of any size answer as small ones do", "[P1]", float, double)
{
  const Sphere<TestType> sphere{{3, 4, 5}, 5};
  const Plane<TestType> plane{{TestType(0.6), TestType(0.8), 0}, 1};
  for (const int exponent : exponents<TestType>())
  {
    expect_enlarged(
        sphere_plane(scaled(sphere, exponent), scaled(plane, exponent)),
        sphere_plane(sphere, plane), exponent);
  }
}

TEMPLATE_TEST_CASE(
    "a ball and a capsule of any size answer as small ones do", "[P2]", float, double)
{
  const Sphere<TestType> sphere{{7, 1, 0}, TestType(4.5)};
  const Capsule<TestType> capsule{{{0, 0, 0}, {6, 8, 0}}, 1};
  for (const int exponent : exponents<TestType>())
  {
    expect_enlarged(
        sphere_capsule(scaled(sphere, exponent), scaled(capsule, exponent)),
        sphere_capsule(sphere, capsule), exponent);
  }
}

TEMPLATE_TEST_CASE("a ball and a box of any size answer as small ones do", "[S7]", float, double)
{
  const Obb<TestType> box{{1, 2, 3}, Matrix3<TestType>::Identity(), {2, 1, 1}};
  for (const Sphere<TestType>& sphere :
       {Sphere<TestType>{{4, 4, 3}, 3}, Sphere<TestType>{{2, 2, 3}, 1}})
  {
    for (const int exponent : exponents<TestType>())
    {
      expect_enlarged(
          sphere_box(scaled(sphere, exponent), scaled(box, exponent)), sphere_box(sphere, box),
          exponent);
    }
  }
}

TEMPLATE_TEST_CASE("a ball 5 off the middle of a vast capsule is 0.5 deep", "[P2]", float, double)
{
  // Only one of the two shapes is too large to be squared.
  const TestType end =
      std::ldexp(TestType(1), std::numeric_limits<TestType>::max_exponent / 2 + 10);
  const Capsule<TestType> capsule{{{-end, 0, 0}, {end, 0, 0}}, 1};
  const Manifold<TestType> manifold =
      sphere_capsule<TestType>({{0, 5, 0}, TestType(4.5)}, capsule).value();
  CHECK(manifold.depth == TestType(0.5));
  CHECK(manifold.normal == Vector3<TestType>(0, -1, 0));
  CHECK(manifold.points[0].position == Vector3<TestType>(0, TestType(0.75), 0));
}

TEST_CASE("the largest of a shape's numbers is found wherever it stands, without its sign", "[P2]")
{
  CHECK(largest<double>(Sphere<double>{{1, -5, 2}, 3}) == 5);
  CHECK(largest<double>(Sphere<double>{{1, -2, 2}, 3}) == 3);
  CHECK(largest<double>(Plane<double>{{0, 1, 0}, -3}) == 3);
  CHECK(largest<double>(Capsule<double>{{{-7, 1, 2}, {3, 1, 4}}, 5}) == 7);
  CHECK(largest<double>(Capsule<double>{{{1, 2, 3}, {2, -9, 0}}, 5}) == 9);
  CHECK(largest<double>(Capsule<double>{{{1, 2, 3}, {2, -9, 0}}, 11}) == 11);
  const Matrix3<double> upright = Matrix3<double>::Identity();
  CHECK(largest<double>(Obb<double>{{-4, 1, 2}, upright, {2, 3, 1}}) == 4);
  CHECK(largest<double>(Obb<double>{{-4, 1, 2}, upright, {2, 6, 1}}) == 6);
}

TEST_CASE("a shape times two to the power of 1 has twice every length", "[P2]")
{
  const Capsule<double> capsule = scaled(Capsule<double>{{{1, 2, 3}, {4, 5, 6}}, 7}, 1);
  CHECK(capsule.segment.start == Vector3<double>(2, 4, 6));
  CHECK(capsule.segment.end == Vector3<double>(8, 10, 12));
  CHECK(capsule.radius == 14);
  const Obb<double> box = scaled(Obb<double>{{1, 2, 3}, Matrix3<double>::Identity(), {4, 5, 6}}, 1);
  CHECK(box.center == Vector3<double>(2, 4, 6));
  CHECK(box.axes == Matrix3<double>::Identity());
  CHECK(box.half_extents == Vector3<double>(8, 10, 12));
  const Sphere<double> sphere = scaled(Sphere<double>{{1, 2, 3}, 4}, 1);
  CHECK(sphere.center == Vector3<double>(2, 4, 6));
  CHECK(sphere.radius == 8);
  const Plane<double> plane = scaled(Plane<double>{{0, 1, 0}, 3}, 1);
  CHECK(plane.normal == Vector3<double>(0, 1, 0));
  CHECK(plane.distance == 6);
}

TEST_CASE("far along the ground a gap of 5e-10 is still a gap", "[P1]")
{
  CHECK_FALSE(sphere_plane<float>({{3e37f, 1e-9f, 0}, 5e-10f}, {{0, 1, 0}, 0}));
  CHECK(sphere_plane<float>({{3e37f, 1e-9f, 0}, 2e-9f}, {{0, 1, 0}, 0})->depth == 2e-9f - 1e-9f);
}

TEST_CASE("a contact point is finite where the depth is not", "[S4]")
{
  const Manifold<float> manifold =
      sphere_sphere_relative<float>({1e10f, 1e-30f, -8.5e37f}, 3.4e38f, 3.4e38f).value();
  CHECK(std::isinf(manifold.depth));
  CHECK(manifold.points[0].position.z() == Catch::Approx(-4.25e37));
  const auto lopsided = sphere_sphere_relative<float>({1e10f, 1e-30f, -8.5e37f}, 3.4e38f, 0);
  CHECK(lopsided->points[0].position.z() == Catch::Approx(-2.125e38));
}

TEMPLATE_TEST_CASE("the largest numbers give no NaN", "[S8]", float, double)
{
  const TestType most = std::numeric_limits<TestType>::max();
  const Sphere<TestType> sphere{{most, -most, -most}, most};
  const auto finite = [](const std::optional<Manifold<TestType>>& manifold)
  {
    return !manifold || (manifold->normal.allFinite() && !std::isnan(manifold->depth) &&
                         !manifold->points[0].position.hasNaN());
  };
  CHECK(finite(sphere_plane<TestType>(sphere, {{0, 1, 0}, most})));
  CHECK(finite(sphere_capsule<TestType>(sphere, {{{-most, most, 0}, {most, most, most}}, most})));
  const Matrix3<TestType> upright = Matrix3<TestType>::Identity();
  CHECK(finite(sphere_box<TestType>(sphere, {{-most, most, 0}, upright, {most, most, most}})));
  CHECK(finite(sphere_box<TestType>(sphere, {{most, 0, 0}, upright, {most, most, most}})));
}
