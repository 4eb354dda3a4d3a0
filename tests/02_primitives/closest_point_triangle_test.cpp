/// \file
/// What holds for the closest point of a triangle and of two segments: formulas P11, P13 and P14.

#include "02_primitives/closest_point_triangle/nearest_by_region.hpp"
#include "02_primitives/closest_point_triangle/trial/point_triangle_cases.hpp"
#include "02_primitives/closest_segments/closest_segments.hpp"
#include "02_primitives/shapes/trial/number_draw.hpp"
#include "tools/exact/exact.hpp"

#include "tests/02_primitives/shape_oracle.hpp"
#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/verdicts.hpp"

using namespace cookbook;

namespace
{

/// How far a triangle of these corners is from the origin, by a hundred digits; that no other point
/// is closer is asked of them.
double true_distance(const Eigen::Vector3d* corners)
{
  const Vector3<Reference> exactly[] = {
      exact<Reference>(corners[0]), exact<Reference>(corners[1]), exact<Reference>(corners[2])};
  const Vector<Reference, 4> weights = nearest_on_triangle(exactly, 0, 1, 2).weights;
  const Vector3<Reference> point =
      weights[0] * exactly[0] + weights[1] * exactly[1] + weights[2] * exactly[2];
  REQUIRE(weights.minCoeff() >= 0);
  REQUIRE(abs(Reference(weights.sum() - 1)) < 1e-90);
  for (const Vector3<Reference>& corner : exactly)
  {
    const Vector3<Reference> difference = corner - point;
    REQUIRE(point.dot(difference) >= -1e-60 * Reference(1 + corner.squaredNorm()));
  }
  return static_cast<double>(Reference(sqrt(Reference(point.squaredNorm()))));
}

/// How far two segments are apart, in the same way.
double true_distance(const Segment<double>& a, const Segment<double>& b)
{
  const auto exactly = [](const Segment<double>& segment) {
    return Segment<Reference>{exact<Reference>(segment.start), exact<Reference>(segment.end)};
  };
  const Segment<Reference> one = exactly(a), other = exactly(b);
  const ClosestFractions<Reference> at = closest_fractions(one, other);
  const Vector3<Reference> on_a = one.start + at.on_a * (one.end - one.start);
  const Vector3<Reference> on_b = other.start + at.on_b * (other.end - other.start);
  const Vector3<Reference> difference = on_a - on_b;
  const auto leads_on = [&](const Vector3<Reference>& towards)
  { return difference.dot(towards) < -1e-60; };
  REQUIRE((at.on_a >= 0 && at.on_a <= 1 && at.on_b >= 0 && at.on_b <= 1));
  REQUIRE_FALSE((leads_on(one.start - on_a) || leads_on(one.end - on_a)));
  REQUIRE_FALSE((leads_on(on_b - other.start) || leads_on(on_b - other.end)));
  return static_cast<double>(Reference(sqrt(Reference(difference.squaredNorm()))));
}

} // namespace

// [P11]
TEST_CASE("shares are 0 or more, their sum is 1, and they make the closest point", "[P11]")
{
  ShapeDraw<double> from(1);
  for (const Draws draws : {Draws::any, Draws::lattice, Draws::thin})
  {
    from.use(draws);
    for (int i = 0; i < random_inputs / 3; ++i)
    {
      const Triangle<double> t = drawn<Triangle<double>>(from);
      const Eigen::Vector3d corners[] = {t.a, t.b, t.c};
      for (const Nearest<double>& nearest :
           {nearest_on_triangle(corners, 0, 1, 2), nearest_by_region(t.a, t.b, t.c)})
      {
        const Eigen::Vector3d mixed =
            nearest.weights[0] * t.a + nearest.weights[1] * t.b + nearest.weights[2] * t.c;
        REQUIRE(nearest.weights.minCoeff() >= 0);
        REQUIRE(std::abs(nearest.weights.sum() - 1) < 1e-15);
        REQUIRE((mixed - nearest.point).norm() < 1e-14);
      }
    }
  }
}
// [P11]

// [P13]
TEST_CASE("no corner lies on the origin's side of the plane through the closest point", "[P13]")
{
  ShapeDraw<double> from(2);
  for (const Draws draws : {Draws::any, Draws::lattice, Draws::thin})
  {
    from.use(draws);
    for (int i = 0; i < random_inputs / 3; ++i)
    {
      const Triangle<double> t = drawn<Triangle<double>>(from);
      const Eigen::Vector3d corners[] = {t.a, t.b, t.c};
      for (const Nearest<double>& nearest :
           {nearest_on_triangle(corners, 0, 1, 2), nearest_by_region(t.a, t.b, t.c)})
      {
        for (const Eigen::Vector3d& x : corners)
        {
          REQUIRE(-nearest.point.dot(x - nearest.point) <= 2e-14);
        }
      }
    }
  }
}
// [P13]

TEST_CASE("close to triangles of a ten-millionth in width, distances are right to 1e-15", "[P13]")
{
  NumberDraw<double> draw(20261124);
  for (int i = 0; i < 2000; ++i)
  {
    const Eigen::Vector3d a = draw.in_cube(1), b = draw.in_cube(1), width = draw.in_cube(1e-7);
    const Eigen::Vector3d c = a + draw.between(-1.5, 1.5) * (b - a) + width;
    const Eigen::Vector3d origin = (a + b + c) / 3 + draw.in_cube(1e-9);
    const Eigen::Vector3d corners[] = {a - origin, b - origin, c - origin};
    const Nearest<double> nearest = nearest_on_triangle(corners, 0, 1, 2);
    REQUIRE(std::abs(nearest.point.norm() - true_distance(corners)) < 1e-15);
    REQUIRE(nearest.weights.minCoeff() >= 0);
  }
}

TEST_CASE(
    "of any triangle at any distance, the distance is right to 3e-15 of what is asked", "[P13]")
{
  NumberDraw<double> draw(20261125);
  for (int i = 0; i < 20'000; ++i)
  {
    const Eigen::Vector3d ab = draw.in_cube(1), aside = ab.cross(draw.in_cube(1));
    const double along = i % 5 == 0 ? std::pow(10, draw.between(-6, 3)) : draw.between(-1, 2);
    const Eigen::Vector3d ac = along * ab + std::pow(10, draw.between(-17, 0)) * aside;
    const double for_b = draw.between(-1, 2), for_c = i % 4 == 0 ? 0 : draw.between(-1, 2);
    const double distance = std::pow(10, draw.between(-9, 6));
    const Eigen::Vector3d away = i % 3 == 0 ? draw.in_cube(1) : Eigen::Vector3d(ab.cross(aside));
    const Eigen::Vector3d a = distance * away;
    const Eigen::Vector3d first = a - for_b * ab - for_c * ac;
    const Eigen::Vector3d corners[] = {first, first + ab, first + ac};
    const double truth = true_distance(corners);
    const double size = std::max({corners[0].norm(), corners[1].norm(), corners[2].norm()});
    for (const Nearest<double>& nearest :
         {nearest_on_triangle(corners, 0, 1, 2),
          nearest_by_region(corners[0], corners[1], corners[2])})
    {
      const Eigen::Vector3d mixed = nearest.weights[0] * corners[0] +
                                    nearest.weights[1] * corners[1] +
                                    nearest.weights[2] * corners[2];
      REQUIRE(std::abs(nearest.point.norm() - truth) < 3e-15 * size);
      REQUIRE((mixed - nearest.point).norm() < 1e-10 * size);
      REQUIRE(nearest.weights.minCoeff() >= 0);
    }
  }
}

// [P14]
TEST_CASE("at the closest fractions, neither segment leads on towards the other", "[P14]")
{
  ShapeDraw<double> from(4);
  for (const Draws draws : {Draws::any, Draws::lattice, Draws::thin})
  {
    from.use(draws);
    for (int i = 0; i < random_inputs / 3; ++i)
    {
      const Segment<double> a = drawn<Segment<double>>(from), b = drawn<Segment<double>>(from);
      const ClosestFractions<double> at = closest_fractions(a, b);
      const Eigen::Vector3d on_a = a.start + at.on_a * (a.end - a.start);
      const Eigen::Vector3d on_b = b.start + at.on_b * (b.end - b.start);
      REQUIRE(std::min(at.on_a, at.on_b) >= 0);
      REQUIRE(std::max(at.on_a, at.on_b) <= 1);
      REQUIRE((on_a - on_b - at.difference).norm() < 1e-14);
      REQUIRE(at.difference.dot(a.start - on_a) >= -2e-14);
      REQUIRE(at.difference.dot(a.end - on_a) >= -2e-14);
      REQUIRE(at.difference.dot(b.start - on_b) <= 2e-14);
      REQUIRE(at.difference.dot(b.end - on_b) <= 2e-14);
    }
  }
}
// [P14]

TEST_CASE(
    "parallel segments: the first end that is closest; crossing ones: where they cross", "[P14]")
{
  const Segment<double> a{{0, 0, 0}, {4, 0, 0}};
  CHECK(closest_fractions<double>(a, {{1, 3, 0}, {9, 3, 0}}).on_a == 1);
  CHECK(closest_fractions<double>(a, {{1, 3, 0}, {9, 3, 0}}).on_b == 0.375);
  CHECK(closest_fractions<double>(a, {{-3, 3, 0}, {9, 3, 0}}).on_b == 0.25);
  CHECK(closest_fractions<double>(a, {{1, -3, 2}, {1, 1, 2}}).on_a == 0.25);
  CHECK(closest_fractions<double>(a, {{1, -3, 2}, {1, 1, 2}}).on_b == 0.75);
  CHECK(
      closest_fractions<double>({{2, 2, 2}, {2, 2, 2}}, {{2, 2, 5}, {2, 2, 5}}).difference.norm() ==
      3);
}

TEST_CASE("at any angle, the distance of two segments is right to 2e-15", "[P14]")
{
  NumberDraw<double> draw(20261125);
  const auto end_or_inside = [&draw]
  {
    const double kind = draw.between(0, 4), inside = draw.between(0, 1);
    return kind < 1 ? 0.0 : kind < 2 ? 1.0 : kind < 3 ? inside : 3 * inside - 1;
  };
  for (int i = 0; i < 20'000; ++i)
  {
    const Eigen::Vector3d start = draw.in_cube(1), along = draw.in_cube(1);
    const Eigen::Vector3d across = along.cross(draw.in_cube(1)), aside = along.cross(across);
    const double sine = std::pow(10, draw.between(-16, 0)), s = end_or_inside();
    const double distance = std::pow(10, draw.between(-16, 0)), t = end_or_inside();
    const Eigen::Vector3d other = (i % 2 == 0 ? 1 : -1) * along + sine * across;
    const Eigen::Vector3d from = start + s * along - t * other + distance * aside;
    const Segment<double> a{start, start + along}, b{from, from + other};
    const ClosestFractions<double> at = closest_fractions(a, b);
    REQUIRE(std::abs(at.difference.norm() - true_distance(a, b)) < 2e-15);
    REQUIRE(std::min(at.on_a, at.on_b) >= 0);
    REQUIRE(std::max(at.on_a, at.on_b) <= 1);
  }
}

TEST_CASE(
    "where products of ways leave the range of double, two segments keep their distance", "[P14]")
{
  const Segment<double> a{{0, 0, 0}, {1, 0, 0}}, b{{0, -1.4e-162, 0.01}, {1, 1.4e-162, 0.01}};
  CHECK(closest_fractions(a, b).difference.norm() == 0.01);
}

TEST_CASE("of two points as close, the first is taken", "[P13]")
{
  const Nearest<double> one{{1, 0, 0, 0}, {1, 0, 0}}, other{{0, 1, 0, 0}, {0, 1, 0}};
  CHECK(closer_of(one, other).point == one.point);
  CHECK(closer_of(other, one).point == other.point);
}

TEST_CASE("above an obtuse corner, rounding leaves no region: no share is below zero", "[P13]")
{
  const double e = 0x1p-52;
  const Nearest<double> nearest =
      nearest_by_region<double>({-1, 1, 1}, {5 * e, -4 * e, 1}, {1, 0, 1});
  CHECK(nearest.weights.minCoeff() >= 0);
  CHECK(std::abs(nearest.point.norm() - 1) <= e);
}

// [point_triangle_verdicts]
TEST_CASE("which way to find the closest point of a triangle holds in which case", "[case:D10]")
{
  check_verdicts(
      point_triangle_verdicts(), names_of(point_triangle_methods()),
      {{"D10", {"clamped shares", "face, then edges"}},
       {"above the middle", {"signs of normals", "clamped shares", "face, then edges"}},
       {"beyond a corner of 20°", {"signs of normals", "face, then edges"}},
       {"beside a triangle that is a line", {"signs of normals", "face, then edges"}}});
}
// [point_triangle_verdicts]

TEST_CASE("of segments parallel to 3e-8, each of the four ends may be the closest", "[P14]")
{
  const double almost = 1 - 0x1p-24; // the other end is at 1: a sine of 2^-25
  const Eigen::Vector3d low(4, almost, 0), high(6, 1, 0);
  const Segment<double> whole{{0, 0, 0}, {8, 0, 0}}, up{low, high}, down{high, low};
  for (const ClosestFractions<double>& at :
       {closest_fractions(up, whole), closest_fractions(down, whole)})
  {
    CHECK(at.difference == Eigen::Vector3d(0, almost, 0));
    CHECK(at.on_b == 0.5);
  }
  for (const ClosestFractions<double>& at :
       {closest_fractions(whole, up), closest_fractions(whole, down)})
  {
    CHECK(at.difference == Eigen::Vector3d(0, -almost, 0));
    CHECK(at.on_a == 0.5);
  }
}
