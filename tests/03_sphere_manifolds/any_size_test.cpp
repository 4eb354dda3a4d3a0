/// \file
/// What holds for shapes so large that the squares of their numbers do not fit: the answers are
/// those of small shapes, enlarged, and no finite number turns into NaN.

#include "03_sphere_manifolds/sphere_box.hpp"
#include "03_sphere_manifolds/sphere_capsule.hpp"
#include "03_sphere_manifolds/sphere_plane.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

namespace
{

/// Exponents of two at which squares, and then sums, no longer fit.
template <class Real>
std::vector<int> exponents()
{
  const int most = std::numeric_limits<Real>::max_exponent;
  return {0, most / 2 + 4, most - 5};
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
  const Sphere<TestType> ball{{3, 4, 5}, 5};
  const Plane<TestType> plane{{TestType(0.6), TestType(0.8), 0}, 1};
  for (const int exponent : exponents<TestType>())
  {
    expect_enlarged(
        sphere_plane(scaled(ball, exponent), scaled(plane, exponent)), sphere_plane(ball, plane),
        exponent);
  }
}

TEMPLATE_TEST_CASE(
    "a ball and a capsule of any size answer as small ones do", "[P2]", float, double)
{
  const Sphere<TestType> ball{{7, 1, 0}, TestType(4.5)};
  const Capsule<TestType> capsule{{{0, 0, 0}, {6, 8, 0}}, 1};
  for (const int exponent : exponents<TestType>())
  {
    expect_enlarged(
        sphere_capsule(scaled(ball, exponent), scaled(capsule, exponent)),
        sphere_capsule(ball, capsule), exponent);
  }
}

TEMPLATE_TEST_CASE("a ball and a box of any size answer as small ones do", "[S7]", float, double)
{
  const Obb<TestType> box{{1, 2, 3}, Matrix3<TestType>::Identity(), {2, 1, 1}};
  for (const Sphere<TestType>& ball :
       {Sphere<TestType>{{4, 4, 3}, 3}, Sphere<TestType>{{2, 2, 3}, 1}})
  {
    for (const int exponent : exponents<TestType>())
    {
      expect_enlarged(
          sphere_box(scaled(ball, exponent), scaled(box, exponent)), sphere_box(ball, box),
          exponent);
    }
  }
}

TEMPLATE_TEST_CASE("the largest numbers give no NaN", "[S8]", float, double)
{
  const TestType most = std::numeric_limits<TestType>::max();
  const Sphere<TestType> ball{{most, -most, -most}, most};
  const auto finite = [](const std::optional<Manifold<TestType>>& manifold)
  {
    return !manifold || (manifold->normal.allFinite() && !std::isnan(manifold->depth) &&
                         !manifold->points[0].position.hasNaN());
  };
  CHECK(finite(sphere_plane<TestType>(ball, {{0, 1, 0}, most})));
  CHECK(finite(sphere_capsule<TestType>(ball, {{{-most, most, 0}, {most, most, most}}, most})));
  const Matrix3<TestType> upright = Matrix3<TestType>::Identity();
  CHECK(finite(sphere_box<TestType>(ball, {{-most, most, 0}, upright, {most, most, most}})));
  CHECK(finite(sphere_box<TestType>(ball, {{most, 0, 0}, upright, {most, most, most}})));
}
