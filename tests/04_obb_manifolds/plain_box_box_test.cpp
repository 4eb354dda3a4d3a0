/// \file
/// \brief The plain manifold of two boxes: by hand, against box_box(), and where it fails.

#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_overlap_truth.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_workloads.hpp"
#include "04_obb_manifolds/plain_box_box/plain_box_box.hpp"
#include "04_obb_manifolds/plain_box_box/trial/plain_box_box_rungs.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <set>

using namespace cookbook;
using Catch::Approx;

namespace
{

constexpr double half_turn = 3.141592653589793;

/// How often two methods differ, over all pairs of a workload.
struct Differences
{
  int pairs = 0, verdicts = 0, depths = 0, counts = 0;
};

Differences differences(const std::string& workload, std::size_t count)
{
  Differences found;
  for (const auto& [first, second] : box_workload(workload, count).pairs)
  {
    const Obb<double> a = orthonormal(first), b = orthonormal(second);
    const auto plain = plain_box_box(a, b), hardened = box_box(a, b);
    const double size = a.half_extents.sum() + b.half_extents.sum();
    found.pairs += 1;
    found.verdicts += plain.has_value() != hardened.has_value();
    if (plain && hardened)
    {
      found.depths += std::abs(plain->depth - hardened->depth) > 1e-9 * size;
      found.counts += plain->points.size() != hardened->points.size();
    }
  }
  return found;
}

} // namespace

// [faces]
TEST_CASE(
    "a cube on a cube, moved by (0.4, 0.9, 0.2), meets it in four points 0.1 deep",
    "[O10][O12][O14]")
{
  const Obb<double> below = upright({0, 0, 0}, {0.5, 0.5, 0.5});
  const Obb<double> above = upright({0.4, 0.9, 0.2}, {0.5, 0.5, 0.5});
  const auto manifold = plain_box_box(below, above);
  REQUIRE(manifold);
  CHECK(manifold->normal == Vector3<double>(0, 1, 0));
  CHECK(manifold->depth == Approx(0.1).epsilon(1e-12));
  REQUIRE(manifold->points.size() == 4);
  std::set<std::pair<int, int>> corners;
  for (const ContactPoint<double>& point : manifold->points)
  {
    CHECK(point.depth == Approx(0.1).epsilon(1e-12));
    CHECK(point.position.y() == Approx(0.45).epsilon(1e-12));
    corners.insert(
        {static_cast<int>(std::lround(point.position.x() * 10)),
         static_cast<int>(std::lround(point.position.z() * 10))});
  }
  CHECK(corners == std::set<std::pair<int, int>>{{-1, -3}, {-1, 5}, {5, -3}, {5, 5}});
}
// [faces]

// [edges]
TEST_CASE(
    "two ridges that cross at a right angle, 0.2 deep, meet in the point between them", "[O13]")
{
  const Matrix3<double> ridge_x = turned(half_turn / 4, {1, 0, 0}),
                        ridge_z = turned(half_turn / 4, {0, 0, 1});
  const double r = std::sqrt(0.5); // from a bar's middle to its ridge
  const auto manifold = plain_box_box<double>(
      {{0, 0, 0}, ridge_x, {2, 0.5, 0.5}}, {{0.3, 2 * r - 0.2, 0.1}, ridge_z, {0.5, 0.5, 2}});
  REQUIRE(manifold);
  CHECK((manifold->normal - Vector3<double>(0, 1, 0)).norm() < 1e-12);
  CHECK(manifold->depth == Approx(0.2).epsilon(1e-12));
  REQUIRE(manifold->points.size() == 1);
  CHECK((manifold->points[0].position - Vector3<double>(0.3, r - 0.1, 0)).norm() < 1e-12);
}
// [edges]

// [same]
TEST_CASE(
    "plain_box_box decides, measures and counts points as box_box: 100,000 random pairs, 10,000 "
    "resting",
    "[O5][O14][O19][O20]")
{
  for (const auto& [workload, count] :
       {std::pair("random", inputs(100'000, 1'000)), std::pair("resting", inputs(10'000, 500)),
        std::pair("edge-edge", inputs(10'000, 500))})
  {
    CAPTURE(workload);
    const Differences found = differences(workload, static_cast<std::size_t>(count));
    CHECK(found.pairs == count);
    CHECK(found.verdicts == 0);
    CHECK(found.depths == 0);
    CHECK(found.counts == 0);
  }
}
// [same]

// [features]
TEST_CASE("features name points: unique in a manifold, and the same after a move of 1e-6", "[O17]")
{
  int points = 0, kept = 0, doubled = 0;
  for (const auto& [first, second] : box_workload("resting", 500).pairs)
  {
    const Obb<double> a = orthonormal(first);
    Obb<double> b = orthonormal(second);
    const auto before = plain_box_box(a, b);
    b.center += Vector3<double>(1e-6, -1e-6, 1e-6);
    const auto after = plain_box_box(a, b);
    REQUIRE((before && after));
    std::set<std::uint32_t> old;
    for (const ContactPoint<double>& point : before->points)
    {
      doubled += !old.insert(point.feature).second;
    }
    for (const ContactPoint<double>& point : after->points)
    {
      points += 1;
      kept += static_cast<int>(old.count(point.feature));
    }
  }
  CHECK(doubled == 0);
  CHECK(kept >= points * 99 / 100);
}
// [features]

// [rungs_fail]
TEST_CASE("each rung of the ladder fails the case of the next one", "[O9][O19]")
{
  const std::vector<RungCase> rows = rung_cases();
  const RungCase &resting = rows[0], &touching = rows[1], &tiny = rows[2], &stack = rows[3],
                 &beam = rows[4];
  CHECK(resting.least == 1); // and the stack stands on one point
  CHECK(resting.plain == resting.right);
  CHECK(touching.plain == 3); // one end twice
  CHECK(touching.hardened == touching.right);
  CHECK(tiny.plain < tiny.right);
  CHECK(tiny.hardened == tiny.right);
  CHECK(stack.hardened > 50);
  CHECK(stack.steady == stack.right);
  CHECK(beam.plain > 40);
  CHECK(beam.hardened > 40);
  CHECK(beam.steady == beam.right);
}
// [rungs_fail]

TEST_CASE(
    "corners exactly on a side: plain gives the triangle's 3 points, box_box 2 of them twice",
    "[O14]")
{
  const Obb<double> a = upright({0, 0, 0}, {1, 1, 1});
  const double half = std::sqrt(0.5);
  const Obb<double> b{{1, 1.4, 0}, turned(half_turn / 4, {0, 1, 0}), {half, 0.5, half}};
  CHECK(plain_box_box(a, b)->points.size() == 3);
  CHECK(box_box(a, b)->points.size() == 5);
}

TEST_CASE("boxes with a number that is none, or without end, do not meet", "[O1]")
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double endless = std::numeric_limits<double>::infinity();
  const Obb<double> a = upright({0, 0, 0}, {1, 1, 1});
  for (const double wrong : {none, endless})
  {
    CHECK_FALSE(plain_box_box(a, upright({wrong, 0, 0}, {1, 1, 1})));
  }
  CHECK_FALSE(plain_box_box(a, upright({0, 0, 0}, {1, none, 1})));
  Obb<double> skewed = a;
  skewed.axes(0, 0) = none;
  CHECK_FALSE(plain_box_box(a, skewed));
}

// [separates]
TEST_CASE("moving B by the depth along the normal ends the overlap, in a room", "[O5][O16]")
{
  int found = 0;
  for (const auto& [first, second] : box_workload("random", inputs(5'000, 500)).pairs)
  {
    const Obb<double> a = orthonormal(first);
    Obb<double> b = orthonormal(second);
    if (const auto manifold = plain_box_box(a, b))
    {
      const double size = a.half_extents.sum() + b.half_extents.sum();
      b.center += manifold->normal * (manifold->depth + 1e-12 * size);
      found += 1;
      CHECK_FALSE(plain_box_box(a, b));
      CHECK(manifold->normal.norm() == Approx(1).epsilon(1e-12));
      CHECK_FALSE(manifold->points.empty());
    }
  }
  CHECK(found > 100);
}
// [separates]
