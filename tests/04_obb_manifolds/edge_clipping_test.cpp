/// \file
/// What holds for the points of edge_clipping(), formula O11.

#include "03_sphere_manifolds/manifold/any_size.hpp"
#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "04_obb_manifolds/box_failures/trial/box_pitfalls.hpp"
#include "04_obb_manifolds/box_workloads/trial/boxes_file.hpp"
#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "04_obb_manifolds/edge_clipping/edge_clipping.hpp"
#include "common/math/rotation.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <set>

using namespace cookbook;

namespace
{

constexpr double rounding = 2e-15;

const Obb<double> unit_cube = upright({0, 0, 0}, {1, 1, 1});

/// The contact positions [m] of a manifold; none where the boxes are apart.
std::vector<Vector3<double>> clipped_points(const Obb<double>& a, const Obb<double>& b)
{
  std::vector<Vector3<double>> points;
  if (const auto manifold = edge_clipping(a, b))
  {
    for (const ContactPoint<double>& point : manifold->points)
    {
      points.push_back(point.position);
    }
  }
  return points;
}

/// The manifold's points, sorted by z, then y, then x.
std::vector<Vector3<double>> sorted_points(const Obb<double>& a, const Obb<double>& b)
{
  std::vector<Vector3<double>> points = clipped_points(a, b);
  std::sort(
      points.begin(), points.end(),
      [](const Vector3<double>& p, const Vector3<double>& q)
      { return std::tuple(p.z(), p.y(), p.x()) < std::tuple(q.z(), q.y(), q.x()); });
  return points;
}

/// Numbers that every compiler draws alike.
class Draw : public BoxDraw
{
public:
  using BoxDraw::BoxDraw;

  Obb<double> box()
  {
    const Vector3<double> axis = vector(-1, 1), center = vector(-1.5, 1.5);
    return {center, turned(between(-3, 3), axis), vector(0.2, 2)};
  }
};

} // namespace

// [O11]
TEST_CASE("an edge from (−3, 0, 0) to (5, 2, 0) enters [−1, 1]³ at 1/4 and leaves at 1/2", "[O11]")
{
  // x = −3 + 8 s is −1 at 1/4 and 1 at 1/2; y = 2 s stays below 1.5.
  const auto piece = clip_edge<double>({-3, 0, 0}, {5, 2, 0}, {1, 1.5, 1}, 1e-15);
  REQUIRE(piece);
  CHECK(piece->enter == 0.25);
  CHECK(piece->enter_face == 1);
  CHECK(piece->leave == 0.5);
  CHECK(piece->leave_face == 0);
}

TEST_CASE(
    "an edge that ends inside has one crossing, one inside none, one beside no piece", "[O11]")
{
  const auto ends_inside = clip_edge<double>({0, 0, 3}, {0, 0.5, -0.5}, {1, 1, 1}, 1e-15);
  REQUIRE(ends_inside);
  CHECK(ends_inside->enter == Catch::Approx(2 / 3.5).margin(rounding));
  CHECK(ends_inside->enter_face == 4);
  CHECK(ends_inside->leave == 1);
  CHECK(ends_inside->leave_face == -1);
  const auto inside = clip_edge<double>({0, 0, 0.5}, {0, 0.5, -0.5}, {1, 1, 1}, 1e-15);
  CHECK((inside && inside->enter_face == -1 && inside->leave_face == -1));
  CHECK_FALSE(clip_edge<double>({2, -3, 0}, {2, 3, 0}, {1, 1, 1}, 1e-15));
  CHECK_FALSE(clip_edge<double>({-3, 0, 0}, {0, 3.5, 0}, {1, 1, 1}, 1e-15));
}

TEST_CASE("an edge along an edge of the box passes its two ends", "[O11]")
{
  const auto piece = clip_edge<double>({-1, 1, 1}, {1, 1, 1}, {1, 1, 1}, 1e-15);
  REQUIRE(piece);
  CHECK((piece->enter == 0 && piece->enter_face == 1));
  CHECK((piece->leave == 1 && piece->leave_face == 0));
}

TEST_CASE("an edge that misses the box by less than the tolerance touches it", "[O11]")
{
  // From x = 3 to y = 3, past the box's edge x = y = 1 by gap · √2 along the way.
  const auto past = [](double separation) {
    return clip_edge<double>({3, separation - 1, 0}, {separation - 1, 3, 0}, {1, 1, 1}, 0.01);
  };
  CHECK_FALSE(past(0.01));
  CHECK(past(0.005));
}
// [O11]

// [crossings]
TEST_CASE(
    "each of 24 edges is clipped: crossings lie on a face of one box and an edge of the other",
    "[O11]")
{
  Draw draw(1);
  int crossings = 0;
  for (int i = 0; i < 500; ++i)
  {
    const RelativeBoxes<double> boxes = relative_boxes(draw.box(), draw.box());
    each_crossing<double>(
        {boxes.rotation, boxes.offset, boxes.half_b, boxes.half_a}, rounding_tolerance(boxes),
        [&](const Vector3<double>& point, std::uint32_t number)
        {
          ++crossings;
          const int edge = int(number) / 6, face = int(number) % 6;
          const Vector3<double> in_b = boxes.rotation.transpose() * (point - boxes.offset);
          const Vector3<double> fraction_b = in_b.cwiseQuotient(boxes.half_b);
          const Vector3<double> fraction_a = point.cwiseQuotient(boxes.half_a);
          const int k = edge / 4;
          const double tolerance = 1e-12;
          CHECK(fraction_a[face / 2] == Catch::Approx(face % 2 == 0 ? 1 : -1).margin(tolerance));
          CHECK(fraction_a.cwiseAbs().maxCoeff() <= 1 + tolerance);
          CHECK(fraction_b[(k + 1) % 3] == Catch::Approx(edge % 2 == 0 ? -1 : 1).margin(tolerance));
          CHECK(fraction_b[(k + 2) % 3] == Catch::Approx(edge % 4 < 2 ? -1 : 1).margin(tolerance));
          CHECK(std::abs(fraction_b[k]) <= 1 + tolerance);
        });
  }
  CHECK(crossings > 1000);
}
// [crossings]

// [points]
TEST_CASE("a cube on a cube, 0.1 deep, has four corners midway between the faces", "[O16][case:G7]")
{
  const auto manifold = edge_clipping(unit_cube, upright({0, 1.9, 0}, {1, 1, 1}));
  CHECK(manifold->normal == Vector3<double>(0, 1, 0));
  CHECK(manifold->depth == Catch::Approx(0.1).margin(rounding));
  REQUIRE(manifold->points.size() == 4);
  for (const ContactPoint<double>& point : manifold->points)
  {
    CHECK(point.depth == manifold->depth);
    CHECK(std::abs(point.position.x()) == Catch::Approx(1).margin(rounding));
    CHECK(point.position.y() == Catch::Approx(0.95).margin(rounding));
    CHECK(std::abs(point.position.z()) == Catch::Approx(1).margin(rounding));
  }
}

TEST_CASE("points move, turn and scale with the boxes", "[O16]")
{
  const Matrix3<double> turn = turned(0.7, {1, -2, 0.5});
  const Vector3<double> offset(10, -20, 30);
  for (const double scale : {1e-3, 1.0, 1e3})
  {
    const auto moved = [&](const Obb<double>& box) -> Obb<double> {
      return {offset + scale * (turn * box.center), turn * box.axes, scale * box.half_extents};
    };
    const Obb<double> b{{0.3, 1.7, 0.2}, turned(0.4, {0, 1, 0}), {0.8, 0.8, 0.8}};
    const std::vector<Vector3<double>> here = clipped_points(unit_cube, b);
    const std::vector<Vector3<double>> there = clipped_points(moved(unit_cube), moved(b));
    REQUIRE(here.size() == there.size());
    REQUIRE(here.size() >= 4);
    for (std::size_t i = 0; i < here.size(); ++i)
    {
      CHECK((offset + scale * (turn * here[i]) - there[i]).norm() <= 1e-12 * (1 + scale));
    }
  }
}

TEST_CASE(
    "every point of 2,000 pairs is on the middle plane and within half the depth of both", "[O16]")
{
  Draw draw(2);
  std::size_t overlapping = 0, most = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Obb<double> a = draw.box(), b = draw.box();
    const auto manifold = edge_clipping(a, b);
    if (!manifold)
    {
      CHECK_FALSE(separating_axes(a, b));
      continue;
    }
    ++overlapping;
    most = std::max(most, manifold->points.size());
    REQUIRE_FALSE(manifold->points.empty());
    const Vector3<double>& n = manifold->normal;
    const double top_of_a =
        n.dot(a.center) + (a.axes.transpose() * n).cwiseAbs().dot(a.half_extents);
    const double tolerance = 2 * same_point<double>();
    for (const ContactPoint<double>& point : manifold->points)
    {
      CHECK(n.dot(point.position) == Catch::Approx(top_of_a - manifold->depth / 2).margin(1e-13));
      CHECK(point.depth == manifold->depth);
      const auto outside = [&](const Obb<double>& box)
      {
        return signed_distance_box<double>(box_coordinates(box, point.position), box.half_extents)
            .length;
      };
      CHECK(outside(a) <= manifold->depth / 2 + tolerance);
      CHECK(outside(b) <= manifold->depth / 2 + tolerance);
    }
  }
  CHECK(overlapping > 1000);
  CHECK(most > 8);
  CHECK(most <= most_crossings);
}

TEST_CASE("features are different for different points, and tell the edge and the face", "[O11]")
{
  // The cube's four upright edges, number 4 to 7, pass the slab's face +y, number 2.
  const Obb<double> slab = upright({0, 0, 0}, {3, 1, 3});
  const Obb<double> cube{{0, 1.5, 0}, turned(0.3, {0, 1, 0}), {1, 1, 1}};
  const auto features = [](const Obb<double>& a, const Obb<double>& b)
  {
    const auto manifold = edge_clipping(a, b).value();
    std::set<std::uint32_t> found;
    for (const ContactPoint<double>& point : manifold.points)
    {
      found.insert(point.feature);
    }
    return found;
  };
  CHECK(features(cube, slab) == std::set<std::uint32_t>{1 + 26, 1 + 32, 1 + 38, 1 + 44});
  CHECK(features(slab, cube) == std::set<std::uint32_t>{73 + 26, 73 + 32, 73 + 38, 73 + 44});
}
// [points]

// [contained]
TEST_CASE(
    "a box inside another: no edge passes a face, and its deepest point is the answer",
    "[case:G4][case:X15]")
{
  const Obb<double> large = upright({0, 0, 0}, {10, 10, 10});
  const Obb<double> small{{9.8, 5, -2}, turned(0.5, {1, 0, 0}), {0.1, 0.1, 0.1}};
  CHECK(untolerant_points(large, small).empty());
  const auto b_inside = edge_clipping(large, small);
  REQUIRE(b_inside->points.size() == 1);
  CHECK(b_inside->points[0].feature == 0);
  CHECK(b_inside->depth == Catch::Approx(0.3).margin(10 * rounding));
  // B's face at 9.7 and A's at 10, over the middle of B's face.
  CHECK((b_inside->points[0].position - Vector3<double>(9.85, 5, -2)).norm() <= 10 * rounding);
  const auto a_inside = edge_clipping(small, large);
  REQUIRE(a_inside->points.size() == 1);
  CHECK(a_inside->normal.x() == Catch::Approx(-1).margin(rounding));
  CHECK((a_inside->points[0].position - Vector3<double>(9.85, 5, -2)).norm() <= 10 * rounding);
}

TEST_CASE("a contained box on its corner answers with the corner", "[case:G4]")
{
  const Matrix3<double> corner_down = turned(std::atan(std::sqrt(2.0)), {-1, 0, 1});
  const Obb<double> small{{1, 7, -3}, corner_down, {1, 1, 1}};
  const auto manifold = edge_clipping(small, upright({0, 0, 0}, {10, 10, 10}));
  // A sinks through B's top at 10: its lowest corner is √3 below its centre.
  CHECK((manifold->normal - Vector3<double>(0, -1, 0)).norm() <= rounding);
  CHECK(manifold->depth == Catch::Approx(3 + std::sqrt(3.0)).margin(1e-14));
  REQUIRE(manifold->points.size() == 1);
  const double middle = (10 + 7 - std::sqrt(3.0)) / 2;
  CHECK((manifold->points[0].position - Vector3<double>(1, middle, -3)).norm() <= 1e-14);
}

TEST_CASE("a contained box that is turned answers with its deepest edge", "[case:G4]")
{
  // Axes (3, 4, 0)/5 and (−4, 3, 0)/5: along x the box reaches 0.6 + 2 · 0.8 to either side.
  const Obb<double> large = upright({0, 0, 0}, {10, 10, 10});
  const Matrix3<double> turn = rational_rotation<double>(2, 0, 0, 1);
  const Obb<double> right{{5, 1, -2}, turn, {1, 2, 1}}, left{{-5, 1, -2}, turn, {1, 2, 1}};
  for (const auto& points : {clipped_points(large, right), clipped_points(right, large)})
  {
    REQUIRE(points.size() == 1);
    CHECK((points[0] - Vector3<double>((10 + 2.8) / 2, 1.4, -2)).norm() <= 10 * rounding);
  }
  for (const auto& points : {clipped_points(large, left), clipped_points(left, large)})
  {
    REQUIRE(points.size() == 1);
    CHECK((points[0] - Vector3<double>(-(10 + 2.8) / 2, 0.6, -2)).norm() <= 10 * rounding);
  }
  const std::vector<Vector3<double>> inside = clipped_points(upright({-5, 1, 2}, {1, 1, 1}), large);
  REQUIRE(inside.size() == 1);
  CHECK((inside[0] - Vector3<double>(-7, 1, 2)).norm() <= 10 * rounding);
}
// [contained]

// [tolerant]
TEST_CASE(
    "touching and flush cubes, turned anyhow, keep four points; exact tests lose some",
    "[case:G6][case:G7][case:X15]")
{
  Draw draw(3);
  int lost = 0;
  for (int i = 0; i < 500; ++i)
  {
    const Matrix3<double> anyhow = draw.box().axes;
    const Obb<double> a = placed(unit_cube, anyhow);
    const Obb<double> b = placed(upright({0, 1.9, 0}, {1, 1, 1}), anyhow);
    CHECK(clipped_points(a, b).size() == 4);
    lost += untolerant_points(a, b).size() < 4 ? 1 : 0;
  }
  CHECK(lost > 100);
}
// [tolerant]

// [limits]
TEST_CASE("crossed ridges have four points around the one that is right", "[case:G2]")
{
  const double eighth = std::atan(1.0);
  const Obb<double> a{{0, 0, 0}, turned(eighth, {1, 0, 0}), {1, 1, 1}};
  const Obb<double> b{{0, std::sqrt(8.0) - 0.01, 0}, turned(eighth, {0, 0, 1}), {1, 1, 1}};
  const std::vector<Vector3<double>> points = sorted_points(a, b);
  REQUIRE(points.size() == 4);
  const double y = std::sqrt(2.0) - 0.005;
  CHECK((points[0] - Vector3<double>(0, y, -0.01)).norm() <= 1e-14);
  CHECK((points[3] - Vector3<double>(0, y, 0.01)).norm() <= 1e-14);
}

TEST_CASE(
    "a cube on its corner has three points where one is right, on a rim 0.07 away", "[case:G16]")
{
  const BoxCase pair = []
  {
    for (const BoxCase& each : box_cases())
    {
      if (each.id == "G16")
      {
        return each;
      }
    }
    throw std::logic_error("no such case");
  }();
  // The edges rise at a slope of 1/√2 from the corner: at height 0.05 they are 0.05 √2 away.
  for (const Vector3<double>& point : clipped_points(pair.a, pair.b))
  {
    CHECK(std::hypot(point.x(), point.z()) == Catch::Approx(0.05 * std::sqrt(2.0)).margin(1e-13));
  }
}

TEST_CASE("a tilted cube gets the depth of its deepest corner at every point", "[case:G9]")
{
  const double tilt = 0.02;
  const Obb<double> floor = upright({0, 0, 0}, {5, 1, 5});
  const Obb<double> cube{{0, 1.95, 0}, turned(tilt, {0, 0, 1}), {1, 1, 1}};
  const auto manifold = edge_clipping(floor, cube);
  REQUIRE(manifold->points.size() == 4);
  for (const ContactPoint<double>& point : manifold->points)
  {
    CHECK(point.depth == manifold->depth);
  }
  // The lowest corners are sin + cos of the tilt below the centre; the face rises by 2 sin from
  // there, and at its other end the boxes overlap by less than half as much.
  const double lowest = 1.95 - std::sin(tilt) - std::cos(tilt);
  CHECK(manifold->depth == Catch::Approx(1 - lowest).margin(1e-14));
  CHECK(1 - (lowest + 2 * std::sin(tilt)) < manifold->depth / 2);
}
// [limits]

TEST_CASE("boxes so large that squares do not fit are refused by file, line and column", "[pairs]")
{
  const auto boxes = [](double x, double half)
  {
    std::vector<double> numbers{0, 0, 0, 1, 0, 0, 0, 1, 1, 1, x, 0, 0, 1, 0, 0, 0, 1, half, 1};
    return PairsRow{"boxes.csv", box_pairs_header, {2, numbers}};
  };
  CHECK(box_pair_at<float>(boxes(1, 2)).second.half_extents.y() == 2);
  CHECK(box_pair_at<float>(boxes(1e18, 1e18)).first.half_extents.y() == 1);
  CHECK(box_pair_at<double>(boxes(1e38, 3e38)).second.half_extents.y() == 3e38);
  CHECK_THROWS_WITH(
      box_pair_at<float>(boxes(1, 3e38)),
      "boxes.csv:2:19: bhy: lengths must be at most 1.15292144e+18, got 3e+38");
  CHECK_THROWS_WITH(
      box_pair_at<float>(boxes(-1e38, 1)),
      "boxes.csv:2:11: bx: lengths must be at most 1.15292144e+18, got -1e+38");
}

TEMPLATE_TEST_CASE("the largest boxes that are read have finite points", "[pairs]", float, double)
{
  using Real = TestType;
  const Real most = squares_fit<Real>;
  const Obb<Real> a{{0, 0, 0}, Matrix3<Real>::Identity(), {most, most, most}};
  const Obb<Real> b{{most, -most, most}, rational_rotation<Real>(1, 2, 3, 4), a.half_extents};
  const auto manifold = edge_clipping(a, b);
  REQUIRE(manifold);
  CHECK(std::isfinite(manifold->depth));
  CHECK(manifold->points.size() >= 3);
  CHECK(manifold->points.size() <= 16);
  for (const ContactPoint<Real>& point : manifold->points)
  {
    CHECK(point.position.allFinite());
  }
}
