/// \file
/// What the model of the published code makes of the cases that break it: the wrong answers are
/// those that the published code itself gave.

#include "04_obb_manifolds/box_as_published/trial/box_as_published.hpp"
#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_failures/trial/box_failures.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_overlap_truth.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_workloads.hpp"

#include "tests/catch.hpp"

#include <set>

using namespace cookbook;

namespace
{

const Obb<double> cube = upright({0, 0, 0}, {1, 1, 1});

/// Whether the manifold's normal and depth are these.
bool has(const auto& found, const Vector3<double>& normal, double depth)
{
  return found && (found->normal - normal).norm() <= 1e-12 &&
         std::abs(found->depth - depth) <= 1e-12;
}

std::size_t count(const auto& found)
{
  return found.value().points.size();
}

} // namespace

// [published_axes_test]
TEST_CASE("X08: cubes edge to edge, 0.0495 apart, are found 0.25 deep", "[case:X08][case:G1]")
{
  const Obb<double> b{{2.25, 2.25, 0}, turned(std::atan(1.0), {-1, 1, 0}), {1, 1, 1}};
  CHECK_FALSE(box_box(cube, b));
  CHECK(box_as_published(cube, b).value().depth == Catch::Approx(0.25).margin(2e-15));
}

TEST_CASE("X09: on a slope of 30° the normal is 90° wrong and the depth 1, not 0.15", "[case:X09]")
{
  const double cosine = std::sqrt(0.75);
  const Matrix3<double> slope = turned(std::atan(1.0) * 2 / 3, {0, 0, 1});
  const Obb<double> ground{{0, 0, 0}, slope, {2, 0.5, 1}};
  const Obb<double> on_it{slope * Vector3<double>(0.3, 0.85, 0), slope, {0.5, 0.5, 0.5}};
  CHECK(has(box_box(ground, on_it), {-0.5, cosine, 0}, 0.15));
  CHECK(has(box_as_published(ground, on_it), {cosine, 0.5, 0}, 1.0));
}

TEST_CASE("X09: a component of 2e-6 stays, one of 5e-7 or less is erased", "[case:X09]")
{
  CHECK(published_axis<double>({1, 2e-6, 0}) == Vector3<double>(1, 2e-6, 0));
  CHECK(published_axis<double>({1, 5e-7, 0}) == Vector3<double>(1, 0, 0));
  CHECK(published_axis<double>({0.8, -0.6, 0}) == Vector3<double>(0.8, 0, 0));
}

TEST_CASE("X14: the cross product of edges 1.7° apart is left out", "[case:X14]")
{
  // sin² 1.7° is 0.00088: below a thousandth; sin² 1.9° is 0.0011.
  const auto cross = [](double degrees) -> Vector3<double> {
    return {0, std::sin(degrees * std::atan(1.0) / 45), 0};
  };
  CHECK(published_axis(cross(1.7)).isZero(0));
  CHECK(published_axis(cross(1.9)) == cross(1.9));
}

TEST_CASE("X14: bars that cross ridge on ridge at 1.5°, 0.01 apart, overlap", "[case:X14]")
{
  const BoxCase deep = bars_case(0.01), apart = bars_case(-0.01);
  CHECK_FALSE(box_box(apart.a, apart.b));
  CHECK(box_as_published(apart.a, apart.b));
  CHECK(has(box_box(deep.a, deep.b), deep.normal, 0.01));
  // Along a face's normal A reaches 1, B 10 sin 1.5° / √2 more than about 1.
  CHECK(box_as_published(deep.a, deep.b).value().depth == Catch::Approx(0.192).margin(1e-3));
}

TEST_CASE(
    "X14 hidden by X08 and X09: with the bars straight, all mistakes together find 0.01",
    "[case:X14]")
{
  // −a2 = (0, √½, −√½), one of A's axes crossed with A's, becomes (0, √½, 0): the missing axis.
  const Matrix3<double> back = rational_rotation<double>(1, 2, 3, 3).transpose();
  const BoxCase deep = bars_case(0.01);
  CHECK(has(box_as_published(placed(deep.a, back), placed(deep.b, back)), {0, 1, 0}, 0.01));
}
// [published_axes_test]

// [published_overlap_test]
TEST_CASE("X10: boxes 100 m apart overlap in the yes-or-no test", "[case:X10]")
{
  const Obb<double> distant = upright({60, 0, 80}, {1, 1, 1});
  CHECK_FALSE(box_box(cube, distant));
  CHECK(overlap_as_published(cube, distant));
}

TEST_CASE(
    "X11, X12: a cube sunk through a plate is 0.2 deep, and sent through it",
    "[case:X11][case:X12][case:G3]")
{
  const Obb<double> plate = upright({0, 0, 0}, {5, 0.1, 5}), sunk = upright({0, 0.5, 0}, {1, 1, 1});
  const Vector3<double> up(0, 1, 0);
  CHECK(has(box_box(plate, sunk), up, 0.6));
  CHECK(has(box_as_published(plate, sunk), -up, 0.2));
  CHECK(has(std::optional(published_overlap(plate, sunk, up)), -up, 0.2));
}

TEST_CASE("X13: cubes that touch have no contact", "[case:X13][case:G6]")
{
  const Obb<double> above = upright({0, 2, 0}, {1, 1, 1});
  CHECK(has(box_box(cube, above), {0, 1, 0}, 0));
  CHECK(count(box_box(cube, above)) == 4);
  CHECK_FALSE(box_as_published(cube, above));
}
// [published_overlap_test]

// [published_points_test]
TEST_CASE("X15: a box inside another overlaps it without a point", "[case:X15][case:G4]")
{
  const Obb<double> large = upright({0, 0, 0}, {10, 10, 10});
  const Obb<double> small = upright({9.8, 0, 0}, {0.1, 0.1, 0.1});
  CHECK(count(box_box(large, small)) == 4);
  CHECK(count(box_as_published(large, small)) == 0);
}

TEST_CASE("X16: cubes of 8 mm keep 2 of 4 points; of 8 m, all 4", "[case:X16]")
{
  for (const double size : {0.004, 4.0})
  {
    const Obb<double> a = upright({0, 0, 0}, {size, size, size});
    const Obb<double> b = upright({0, 1.9 * size, 0}, a.half_extents);
    CHECK(count(box_box(a, b)) == 4);
    CHECK(count(box_as_published(a, b)) == (size < 1 ? 2 : 4));
  }
}

TEST_CASE("X16: of points in a row 8 mm apart, one stays", "[case:X16]")
{
  const auto at = [](double x) { return ContactPoint<double>{{x, 0, 0}, 0, 0}; };
  // From the last on: 0.016 is replaced by 0.008, and that by 0.
  const PublishedPoints<double> row{at(0), at(0.008), at(0.016)};
  const PublishedPoints<double> left = merged(row, 0.01);
  REQUIRE(left.size() == 1);
  CHECK(left[0].position.x() == 0);
  CHECK(merged(row, 0.005).size() == 3);
}

TEST_CASE("X17: no point knows its features, and there may be more than eight", "[case:X17]")
{
  std::size_t most = 0;
  for (const auto& [float_a, float_b] : box_workload("random", 500).pairs)
  {
    if (const auto found = box_as_published(orthonormal(float_a), orthonormal(float_b)))
    {
      most = std::max(most, found->points.size());
      CHECK(std::all_of(
          found->points.begin(), found->points.end(),
          [](const auto& point) { return point.feature == 0; }));
    }
  }
  CHECK(most > 8);
  std::set<std::uint32_t> features;
  const auto right = box_box(cube, upright({0.3, 1.9, 0.2}, {1, 1, 1}));
  for (const auto& point : right->points)
  {
    features.insert(point.feature);
  }
  CHECK(features.size() == 4);
}

TEST_CASE("all points are where edges pass faces, moved midway, wherever the boxes are", "[O16]")
{
  // A's top is at 17, B's bottom at 16.75; B's four upright edges pass it.
  const auto found =
      box_as_published(upright({8, 16, 4}, {3, 1, 3}), upright({8.5, 17.75, 4.25}, {1, 1, 1}));
  REQUIRE(count(found) == 4);
  std::set<std::pair<double, double>> places;
  for (const ContactPoint<double>& point : found->points)
  {
    CHECK(point.position.y() == 16.875);
    CHECK(point.depth == 0.25);
    CHECK(std::abs(point.position.x() - 8.5) == 1);
    CHECK(std::abs(point.position.z() - 4.25) == 1);
    places.emplace(point.position.x(), point.position.z());
  }
  CHECK(places.size() == 4);
}
// [published_points_test]
