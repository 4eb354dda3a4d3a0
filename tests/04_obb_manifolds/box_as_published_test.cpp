/// \file
/// What the model of the published code makes of the cases that break it, with each fault alone.

#include "04_obb_manifolds/box_as_published/trial/box_as_published.hpp"
#include "04_obb_manifolds/box_as_published/trial/box_as_published_rates.hpp"
#include "04_obb_manifolds/box_failures/trial/box_failures.hpp"
#include "common/math/rotation.hpp"

#include "tests/catch.hpp"

#include <set>

using namespace cookbook;

namespace
{

constexpr double rounding = 2e-15;

const Obb<double> cube = upright({0, 0, 0}, {1, 1, 1});

/// Whether the manifold's normal and depth are these.
bool has(const auto& found, const Vector3<double>& normal, double depth)
{
  return found && (found->normal - normal).norm() <= 1e-12 &&
         std::abs(found->depth - depth) <= 1e-12;
}

std::size_t count(const Obb<double>& a, const Obb<double>& b, const PublishedFaults& faults)
{
  return box_as_published(a, b, faults).value().points.size();
}

} // namespace

// [mended]
TEST_CASE(
    "with every fault mended it is edge_clipping: 2,000 pairs in four workloads", "[published]")
{
  for (const char* const name : {"random", "resting", "edge-edge", "thin plates"})
  {
    for (const auto& [float_a, float_b] : box_workload(name, 500).pairs)
    {
      const Obb<double> a = orthonormal(float_a), b = orthonormal(float_b);
      const auto ours = edge_clipping(a, b);
      const auto mended = box_as_published(a, b, no_faults);
      REQUIRE(ours.has_value() == mended.has_value());
      CHECK(ours.has_value() == overlap_as_published(a, b, no_faults));
      if (ours)
      {
        CHECK(std::abs(ours->depth - mended->depth) <= 1e-12);
        CHECK((ours->normal - mended->normal).norm() <= 1e-9);
        CHECK(ours->points.size() == mended->points.size());
      }
    }
  }
}
// [mended]

// [published_axes_test]
TEST_CASE("X08: cubes edge to edge, 0.0495 apart, are found 0.25 deep", "[case:X08][case:G1]")
{
  const Obb<double> b{{2.25, 2.25, 0}, turned(std::atan(1.0), {-1, 1, 0}), {1, 1, 1}};
  CHECK_FALSE(box_as_published(cube, b, no_faults));
  const auto found = box_as_published(cube, b, only(&PublishedFaults::crosses_a_with_a));
  REQUIRE(found);
  CHECK(found->depth == Catch::Approx(0.25).margin(rounding));
  CHECK(box_as_published(cube, b)->depth == Catch::Approx(0.25).margin(rounding));
}

TEST_CASE("X09: on a slope of 30° the normal is 90° wrong and the depth 1, not 0.15", "[case:X09]")
{
  const double cosine = std::sqrt(0.75);
  const Matrix3<double> slope = turned(std::atan(1.0) * 2 / 3, {0, 0, 1});
  const Obb<double> ground{{0, 0, 0}, slope, {2, 0.5, 1}};
  const Obb<double> on_it{slope * Vector3<double>(0.3, 0.85, 0), slope, {0.5, 0.5, 0.5}};
  CHECK(has(box_as_published(ground, on_it, no_faults), {-0.5, cosine, 0}, 0.15));
  // The slope's normal (−1/2, √3/2, 0) becomes (0, 1, 0): a fair direction, but not the least.
  const auto alone = box_as_published(ground, on_it, only(&PublishedFaults::erases_negatives));
  CHECK(has(box_as_published(ground, on_it), {cosine, 0.5, 0}, 1.0));
  CHECK(alone->depth > 0.15 + 0.1);
}

TEST_CASE("X09: a component of 2e-6 stays, one of 5e-7 or less is erased", "[case:X09]")
{
  const auto tilted = [](double sine)
  {
    Matrix3<double> turn;
    turn << 1, 0, sine, 0, 1, 0, -sine, 0, 1;
    const Obb<double> box{{0, 0, 0}, turn, {1, 1, 1}};
    return published_axes(box, box, only(&PublishedFaults::erases_negatives));
  };
  CHECK(tilted(2e-6)[2].x() == 2e-6);
  CHECK(tilted(5e-7)[2].x() == 0);
  CHECK(tilted(1e-12)[0].z() == 0);
  CHECK(tilted(0.5)[0].z() == 0);
  CHECK(tilted(0.5)[0].x() == 1);
}

TEST_CASE("X14: the cross product of edges 1.7° apart is left out", "[case:X14]")
{
  // sin² 1.7° is 0.00088: below a thousandth; sin² 1.9° is 0.0011.
  const auto second_edge = [](double degrees)
  {
    const double angle = degrees * std::atan(1.0) / 45;
    const auto axes = published_axes(
        cube, {{0, 0, 0}, turned(angle, {0, 1, 0}), {1, 1, 1}},
        only(&PublishedFaults::drops_short_axes));
    return axes[6].norm();
  };
  CHECK(second_edge(1.7) == 0);
  CHECK(second_edge(1.9) == Catch::Approx(std::sin(1.9 * std::atan(1.0) / 45)).margin(rounding));
}

TEST_CASE(
    "X14: bars that cross ridge on ridge at 1.5° are found 0.18 deeper, or not apart", "[case:X14]")
{
  const PublishedFaults fault = only(&PublishedFaults::drops_short_axes);
  const BoxCase deep = bars_case(0.01), apart = bars_case(-0.01);
  CHECK(has(box_as_published(deep.a, deep.b, no_faults), deep.normal, 0.01));
  // Along a face's normal A reaches 1, B 10 sin 1.5° / √2 more than about 1.
  CHECK(box_as_published(deep.a, deep.b, fault)->depth == Catch::Approx(0.192).margin(1e-3));
  CHECK_FALSE(box_as_published(apart.a, apart.b, no_faults));
  CHECK(box_as_published(apart.a, apart.b, fault));
}

TEST_CASE(
    "X14 hidden by X08 and X09: with the bars straight, all faults together find 0.01",
    "[case:X14]")
{
  // −a2 = (0, √½, −√½), one of A's axes crossed with A's, becomes (0, √½, 0): the missing axis.
  const Matrix3<double> back = rational_rotation<double>(1, 2, 3, 3).transpose();
  const BoxCase deep = bars_case(0.01);
  CHECK(has(box_as_published(placed(deep.a, back), placed(deep.b, back)), {0, 1, 0}, 0.01));
  CHECK_FALSE(has(box_as_published(deep.a, deep.b), deep.normal, 0.01));
}
// [published_axes_test]

// [published_overlap_test]
TEST_CASE("X10: boxes 100 m apart overlap in the yes-or-no test", "[case:X10]")
{
  const Obb<double> distant = upright({60, 0, 80}, {1, 1, 1});
  CHECK_FALSE(overlap_as_published(cube, distant, no_faults));
  CHECK(overlap_as_published(cube, distant, only(&PublishedFaults::casts_a_twice)));
  CHECK(overlap_as_published(cube, distant));
  CHECK_FALSE(box_as_published(cube, distant));
}

TEST_CASE(
    "X11, X12: a cube sunk through a plate is 0.2 deep, and sent through it",
    "[case:X11][case:X12][case:G3]")
{
  const Obb<double> plate = upright({0, 0, 0}, {5, 0.1, 5}), sunk = upright({0, 0.5, 0}, {1, 1, 1});
  const Vector3<double> up(0, 1, 0), down(0, -1, 0);
  CHECK(has(box_as_published(plate, sunk, no_faults), up, 0.6));
  CHECK(has(box_as_published(plate, sunk, only(&PublishedFaults::measures_union)), up, 0.2));
  CHECK(has(box_as_published(plate, sunk, only(&PublishedFaults::turns_by_begin)), down, 0.6));
  CHECK(has(box_as_published(plate, sunk), down, 0.2));
}

TEST_CASE("X13: cubes that touch have no contact", "[case:X13][case:G6]")
{
  const Obb<double> above = upright({0, 2, 0}, {1, 1, 1});
  CHECK(has(box_as_published(cube, above, no_faults), {0, 1, 0}, 0));
  CHECK(count(cube, above, no_faults) == 4);
  CHECK_FALSE(box_as_published(cube, above, only(&PublishedFaults::drops_touching)));
  CHECK_FALSE(box_as_published(cube, above));
}
// [published_overlap_test]

// [published_points_test]
TEST_CASE("X15: a box inside another overlaps it without a point", "[case:X15][case:G4]")
{
  const Obb<double> large = upright({0, 0, 0}, {10, 10, 10});
  const Obb<double> small = upright({9.8, 0, 0}, {0.1, 0.1, 0.1});
  CHECK(count(large, small, no_faults) == 1);
  CHECK(count(large, small, only(&PublishedFaults::tests_points_bare)) == 0);
  CHECK(count(large, small, {}) == 0);
}

TEST_CASE("X16: cubes of 8 mm keep 2 of 4 points; of 8 m, all 4", "[case:X16]")
{
  for (const double size : {0.004, 4.0})
  {
    const Obb<double> a = upright({0, 0, 0}, {size, size, size});
    const Obb<double> b = upright({0, 1.9 * size, 0}, a.half_extents);
    const std::size_t kept = size < 1 ? 2 : 4;
    CHECK(count(a, b, no_faults) == 4);
    CHECK(count(a, b, only(&PublishedFaults::merges_within_1_cm)) == kept);
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
  CHECK(merged(row, 0.005)[0].position.x() == 0);
}

TEST_CASE("X17: no point knows its features, and there may be more than eight", "[case:X17]")
{
  std::size_t most = 0;
  for (const auto& [float_a, float_b] : box_workload("random", 500).pairs)
  {
    const Obb<double> a = orthonormal(float_a), b = orthonormal(float_b);
    if (const auto found = box_as_published(a, b))
    {
      most = std::max(most, found->points.size());
      CHECK(std::all_of(
          found->points.begin(), found->points.end(),
          [](const auto& point) { return point.feature == 0; }));
    }
  }
  CHECK(most > 8);
  const auto mended =
      box_as_published(cube, upright({0.3, 1.9, 0.2}, {1, 1, 1}), no_faults).value();
  std::set<std::uint32_t> features;
  for (const ContactPoint<double>& point : mended.points)
  {
    features.insert(point.feature);
  }
  CHECK(features.size() == mended.points.size());
  CHECK(features.count(0) == 0);
}

TEST_CASE(
    "points of bare crossings are on a face of one box and an edge of the other", "[published]")
{
  // B's four upright edges pass A's top, number 2, and no edge of A passes B's bottom.
  const Obb<double> slab = upright({0, 0, 0}, {3, 1, 3}),
                    above = upright({0.5, 1.75, 0.25}, {1, 1, 1});
  PublishedPoints<double> points;
  add_bare_crossings(above, slab, 1, points);
  REQUIRE(points.size() == 4);
  std::set<std::uint32_t> features;
  std::set<std::pair<double, double>> places;
  for (const ContactPoint<double>& point : points)
  {
    places.emplace(point.position.x(), point.position.z());
    CHECK(point.position.y() == 1);
    CHECK(std::abs(point.position.x() - 0.5) == 1);
    CHECK(std::abs(point.position.z() - 0.25) == 1);
    features.insert(point.feature);
  }
  CHECK(features == std::set<std::uint32_t>{1 + 26, 1 + 32, 1 + 38, 1 + 44});
  CHECK(places.size() == 4);
  points.clear();
  add_bare_crossings(slab, above, 1, points);
  CHECK(points.empty());
}

TEST_CASE("all points are midway between the faces, wherever the boxes are", "[published]")
{
  // A's top is at 17, B's bottom at 16.75; edges 4 to 7 of B pass face 2 of A.
  PublishedFaults faults;
  faults.forgets_features = false;
  const auto found =
      box_as_published(
          upright({8, 16, 4}, {3, 1, 3}), upright({8.5, 17.75, 4.25}, {1, 1, 1}), faults)
          .value();
  std::set<std::uint32_t> features;
  for (const ContactPoint<double>& point : found.points)
  {
    CHECK(point.position.y() == 16.875);
    CHECK(point.depth == 0.25);
    features.insert(point.feature);
  }
  CHECK(features == std::set<std::uint32_t>{73 + 26, 73 + 32, 73 + 38, 73 + 44});
}
// [published_points_test]

// [rates]
TEST_CASE(
    "of 12,000 pairs each fault is wrong where it can be, and all mended nowhere",
    "[published][long]")
{
  const std::vector<CheckedPair> pairs = checked_pairs(12000);
  for (const FaultVariant& variant : fault_variants())
  {
    const FaultCounts counts = count_faults(pairs, variant.faults);
    const std::string& id = variant.id;
    INFO(id);
    CHECK(counts.apart > 1000);
    CHECK(counts.overlapping > 1000);
    CHECK(counts.missed == 0);
    CHECK((counts.hit > 0) == (id == "X08" || id == "X09" || id == "X10" || id == "all"));
    CHECK((counts.reversed > 0) == (id == "X12" || id == "all"));
    CHECK((counts.off_depth > 0) == (id == "X08" || id == "X09" || id == "X11" || id == "all"));
    CHECK(
        (counts.lost > counts.asked / 10) ==
        (id == "X08" || id == "X09" || id == "X15" || id == "X16" || id == "all"));
    CHECK((id == "X10") == (counts.hit == counts.apart));
  }
}
// [rates]
