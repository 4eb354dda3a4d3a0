/// \file
/// What holds for the manifolds of face_clipping(): formulas O10, O12, O13 and O14, the known
/// cases, and random pairs.

#include "02_primitives/closest_point_box/closest_point_box.hpp"
#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_overlap_truth.hpp"
#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "04_obb_manifolds/face_clipping/face_clipping.hpp"
#include "common/math/rotation.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <algorithm>
#include <numeric>
#include <set>

using namespace cookbook;

namespace
{

constexpr int random_pairs = inputs(200'000, 2'000);

constexpr double rounding = 2e-15;

const Obb<double> unit_cube = upright({0, 0, 0}, {1, 1, 1});

/// Numbers that every compiler draws alike.
class Draw : public BoxDraw
{
public:
  using BoxDraw::BoxDraw;

  int whole(int low, int high) { return low + BoxDraw::whole(high - low + 1); }
  Matrix3<double> rotation()
  {
    const double angle = between(-3, 3);
    return turned(angle, vector(-1, 1));
  }
  Obb<double> box()
  {
    const Matrix3<double> axes = rotation();
    const Vector3<double> center = vector(-1.5, 1.5);
    return {center, axes, vector(0.2, 2)};
  }
  /// A box in fractions.
  Obb<Rational> whole_box()
  {
    const auto vector = [&](int low, int high) -> Vector3<Rational>
    {
      const int x = whole(low, high), y = whole(low, high);
      return {Rational(x), Rational(y), Rational(whole(low, high))};
    };
    const int w = whole(1, 2), x = whole(-2, 2), y = whole(-2, 2), z = whole(-2, 2);
    const Vector3<Rational> center = vector(-3, 3);
    return {center, rational_rotation<Rational>(w, x, y, z), vector(1, 6)};
  }
};

BoxCase case_named(const std::string& id)
{
  for (const BoxCase& pair : box_cases())
  {
    if (pair.id == id)
    {
      return pair;
    }
  }
  throw std::logic_error("no case " + id);
}

/// The distance [m] of a point from a box; zero inside.
template <class Real>
double distance(const Obb<Real>& box, const Vector3<Real>& point)
{
  const double d =
      signed_distance_box<Wide<Real>>(box_coordinates(box, point), widen(box.half_extents)).length;
  return std::max(d, 0.0);
}

/// How far the points of a manifold are from a box, beyond half the depth, by the pair's size; all
/// numbers must be finite, points at least one, and none deeper than the whole.
template <class Real>
double farthest_out(const Manifold<Real>& manifold, const Obb<Real>& a, const Obb<Real>& b)
{
  REQUIRE(manifold.points.size() >= 1);
  REQUIRE(manifold.points.size() <= 8);
  const double size = double(a.half_extents.sum() + b.half_extents.sum());
  const double half = double(manifold.depth) / 2;
  double farthest = -1;
  for (const ContactPoint<Real>& point : manifold.points)
  {
    REQUIRE(point.position.allFinite());
    const double out = std::max(distance(a, point.position), distance(b, point.position));
    const double deeper = double(point.depth) - double(manifold.depth);
    const double wider = -double(point.depth) - double(manifold.depth);
    farthest = std::max({farthest, (out - half) / size, deeper / size, wider / size});
  }
  return farthest;
}

template <class Real>
Real greatest_depth(const Manifold<Real>& manifold)
{
  Real depth = manifold.points[0].depth;
  for (const ContactPoint<Real>& point : manifold.points)
  {
    depth = std::max(depth, point.depth);
  }
  return depth;
}

template <class Real>
std::set<std::uint32_t> features(const Manifold<Real>& manifold)
{
  std::set<std::uint32_t> found;
  for (const ContactPoint<Real>& point : manifold.points)
  {
    found.insert(point.feature);
  }
  return found;
}

/// The points have these depths, from the deepest to the shallowest.
void check_depths(const Manifold<double>& manifold, const std::vector<double>& right)
{
  std::vector<double> depths;
  for (const ContactPoint<double>& point : manifold.points)
  {
    depths.push_back(point.depth);
  }
  std::sort(depths.begin(), depths.end(), std::greater<>());
  REQUIRE(depths.size() == right.size());
  for (std::size_t i = 0; i < right.size(); ++i)
  {
    CHECK(depths[i] == Catch::Approx(right[i]).margin(10 * rounding));
  }
}

} // namespace

// [O10]
TEST_CASE(
    "of a box turned by 3-4-5 the face along (1, 3, 2) is that of its axis (−4, 3, 0)/5", "[O10]")
{
  // The quaternion (2, 0, 0, 1) turns x to (3, 4, 0)/5 and y to (−4, 3, 0)/5. Along (1, 3, 2) these
  // go 3 and 1, and z goes 2: the face of x. Against (3, −4, 0) the face of y goes farthest: 24/5.
  const Obb<double> box{{10, 0, 0}, rational_rotation<double>(2, 0, 0, 1), {1, 2, 3}};
  const BoxFace<double> reference = face_along<double>({box, 0}, {1, 3, 2});
  CHECK((reference.axes.col(2) - Vector3<double>(0.6, 0.8, 0)).norm() <= rounding);
  CHECK((reference.center - Vector3<double>(10.6, 0.8, 0)).norm() <= 10 * rounding);
  CHECK(reference.half_sides == Vector<double, 2>(2, 3));
  const BoxFace<double> incident = face_along<double>({box, 0}, {3, -4, 0});
  CHECK((incident.axes.col(2) - Vector3<double>(0.8, -0.6, 0)).norm() <= rounding);
  CHECK((incident.center - Vector3<double>(11.6, -1.2, 0)).norm() <= 10 * rounding);
  CHECK(incident.half_sides == Vector<double, 2>(1, 3));
}

TEST_CASE(
    "of all six faces the one chosen is most along, or most against, 1,000 directions", "[O10]")
{
  Draw draw(1);
  for (int i = 0; i < 1000; ++i)
  {
    const Obb<double> box = draw.box();
    const Vector3<double> n = draw.vector(-1, 1).normalized();
    const double along = n.dot(face_along<double>({box, 0}, n).axes.col(2));
    const double against = n.dot(face_along<double>({box, 0}, -n).axes.col(2));
    for (int face = 0; face < 6; ++face)
    {
      const Vector3<double> u = (face < 3 ? 1.0 : -1.0) * box.axes.col(face % 3);
      CHECK(n.dot(u) <= along + rounding);
      CHECK(n.dot(u) >= against - rounding);
    }
  }
}
// [O10]

TEST_CASE("a face's axes are right-handed, and its sides are the edges that they are said to be")
{
  for (int face = 0; face < 6; ++face)
  {
    const Vector3<double> outward = (face < 3 ? 1.0 : -1.0) * Vector3<double>::Unit(face % 3);
    const Obb<double> box = upright({0, 0, 0}, {1, 2, 3});
    const BoxFace<double> found = face_along<double>({box, 0}, outward);
    CHECK(found.axes.determinant() == 1);
    CHECK(found.axes.col(2) == outward);
    const Vector3<double> to_side[] = {
        -found.half_sides.y() * found.axes.col(1), found.half_sides.x() * found.axes.col(0),
        found.half_sides.y() * found.axes.col(1), -found.half_sides.x() * found.axes.col(0)};
    for (std::size_t side = 0; side < 4; ++side)
    {
      const int axis = found.edges[side] / 4;
      const BoxEdge<double> edge = edge_along<double>({box, 0}, axis, found.center + to_side[side]);
      CHECK(edge.number == found.edges[side]);
      CHECK(edge.middle == found.center + to_side[side]);
      CHECK(edge.half_length == box.half_extents[axis]);
    }
  }
}

TEST_CASE("edges have the numbers that edge clipping gives them: A's from 0, B's from 12")
{
  const Obb<double> box = upright({5, 6, 7}, {1, 2, 3});
  int number = 0;
  for (const double z : {-1.0, 1.0})
  {
    for (const double y : {-1.0, 1.0})
    {
      const BoxEdge<double> edge = edge_along<double>({box, 0}, 0, {9, y, z});
      CHECK(edge.number == number);
      CHECK(edge.middle == Vector3<double>(5, 6 + 2 * y, 7 + 3 * z));
      CHECK(edge_along<double>({box, 12}, 0, {-9, y, z}).number == 12 + number);
      ++number;
    }
  }
  // Along y the first of the two others is z.
  CHECK(edge_along<double>({box, 0}, 1, {-1, 0, 1}).number == 5);
  CHECK(edge_along<double>({box, 0}, 2, {-1, 1, 0}).number == 10);
}

// [O12]
TEST_CASE("each point has its own depth: a cube that leans by 2/100 is 0.05 and 0.01 deep", "[O12]")
{
  // The quaternion (100, 0, 0, 1) has sin = 200/10001 and cos = 9999/10001: of the bottom's edges,
  // two metres apart, one is 400/10001 below the other.
  const double sin = 200.0 / 10001, cos = 9999.0 / 10001;
  const Obb<double> floor = upright({0, 0, 0}, {5, 1, 5});
  const auto leaning = [&](double depth) -> Obb<double> {
    return {{0, 1 + sin + cos - depth, 0}, rational_rotation<double>(100, 0, 0, 1), {1, 1, 1}};
  };
  const double less = 400.0 / 10001;
  const auto deep = face_clipping(floor, leaning(0.05)).value();
  CHECK(deep.depth == Catch::Approx(0.05).margin(10 * rounding));
  check_depths(deep, {0.05, 0.05, 0.05 - less, 0.05 - less});
  for (const ContactPoint<double>& point : deep.points)
  {
    // Midway between the floor's top at 1 and the cube's corner.
    CHECK(point.position.y() == Catch::Approx(1 - point.depth / 2).margin(10 * rounding));
    CHECK(std::abs(point.position.z()) == Catch::Approx(1).margin(10 * rounding));
    // The lower edge is the one at −x: the cube leans counter-clockwise.
    const double x = point.depth > 0.04 ? -cos + sin : cos + sin;
    CHECK(point.position.x() == Catch::Approx(x).margin(10 * rounding));
  }
}

TEST_CASE("of gaps of 1/4 all four points are kept up to 1/4, one below: the deepest", "[O12]")
{
  const NumberedBox<double> a{upright({0, 0, 0}, {1, 1, 1}), 0};
  const NumberedBox<double> b{upright({0, 2.25, 0}, {1, 1, 1}), box_edges};
  const LeastOverlap<double> least{{0, 1, 0}, 0, 1};
  CHECK(face_points<double>({a, b, least, 0, 0.25}).size() == 4);
  CHECK(face_points<double>({a, b, least, 0, 0.2499}).size() == 1);
}

TEST_CASE("a gap is kept up to the depth and to a hundredth of the smaller box, no wider", "[O12]")
{
  const double sin = 200.0 / 10001, cos = 9999.0 / 10001, less = 400.0 / 10001;
  const Obb<double> floor = upright({0, 0, 0}, {5, 1, 5});
  const auto leaning = [&](double depth, const Vector3<double>& half)
  {
    const Obb<double> cube{
        {0, 1 + sin * half.x() + cos * half.y() - depth, 0},
        rational_rotation<double>(100, 0, 0, 1),
        half};
    return face_clipping(floor, cube).value();
  };
  // A hundredth of the cube is 0.03. The upper edge is 0.03999 higher than the lower one.
  check_depths(leaning(0.021, {1, 1, 1}), {0.021, 0.021, 0.021 - less, 0.021 - less});
  check_depths(leaning(0.0201, {1, 1, 1}), {0.0201, 0.0201, 0.0201 - less, 0.0201 - less});
  check_depths(leaning(0.0199, {1, 1, 1}), {0.0199, 0.0199});
  // A hundredth of 2 + 0.5 + 0.5 is still 0.03, but now the upper edge is 0.07998 higher.
  check_depths(
      leaning(0.0501, {2, 0.5, 0.5}), {0.0501, 0.0501, 0.0501 - 2 * less, 0.0501 - 2 * less});
  check_depths(leaning(0.0499, {2, 0.5, 0.5}), {0.0499, 0.0499});
}
// [O12]

// [O13]
TEST_CASE(
    "of the lines along x and along (3, 4, 0)/5 past (2, 1, 5) the first is closest at 5/4",
    "[O13]")
{
  // From (2, 1, 5) back by 5/4 along the second line: (2 − 3/4, 1 − 1, 5), right above (5/4, 0, 0).
  const BoxEdge<double> a{{0, 0, 0}, {1, 0, 0}, 2, 0};
  const BoxEdge<double> b{{2, 1, 5}, {0.6, 0.8, 0}, 2, 12};
  CHECK(closest_along(a, b) == Catch::Approx(1.25).margin(rounding));
  CHECK(closest_along(b, a) == Catch::Approx(-1.25).margin(rounding));
  CHECK((midway_between(a, b) - Vector3<double>(1.25, 0, 2.5)).norm() <= 2 * rounding);
}

TEST_CASE("an edge that ends at 1 before the 5/4 is closest at its end", "[O13]")
{
  // The point of the second line closest to (1, 0, 0) is −(1 · 3/5 + 1 · 4/5) = −7/5 along it:
  // (2 − 21/25, 1 − 28/25, 5). The first edge has nothing closer to that than its end.
  const BoxEdge<double> a{{0, 0, 0}, {1, 0, 0}, 1, 0};
  const BoxEdge<double> b{{2, 1, 5}, {0.6, 0.8, 0}, 2, 12};
  const Vector3<double> middle = (Vector3<double>(1, 0, 0) + Vector3<double>(1.16, -0.12, 5)) / 2;
  CHECK((midway_between(a, b) - middle).norm() <= 2 * rounding);
  // And if the second edge ends after 1/2, at (1.7, 0.6, 5), its end is.
  const BoxEdge<double> shorter{{2, 1, 5}, {0.6, 0.8, 0}, 0.5, 12};
  const Vector3<double> ends = (Vector3<double>(1, 0, 0) + Vector3<double>(1.7, 0.6, 5)) / 2;
  CHECK((midway_between(a, shorter) - ends).norm() <= 2 * rounding);
  // Of an edge that reaches past 5/4, the point closest to that end is at 1.7.
  const BoxEdge<double> longer{{0, 0, 0}, {1, 0, 0}, 2, 0};
  CHECK((midway_between(longer, shorter) - Vector3<double>(1.7, 0.3, 2.5)).norm() <= 2 * rounding);
}

TEST_CASE(
    "in fractions, what joins two lines where they are closest is perpendicular to both", "[O13]")
{
  Draw draw(2);
  for (int i = 0; i < 100; ++i)
  {
    const Obb<Rational> box_a = draw.whole_box(), box_b = draw.whole_box();
    const BoxEdge<Rational> a = edge_along<Rational>({box_a, 0}, i % 3, box_b.center);
    const BoxEdge<Rational> b = edge_along<Rational>({box_b, 12}, i / 3 % 3, box_a.center);
    if (a.direction.cross(b.direction).isZero(0))
    {
      continue;
    }
    const Vector3<Rational> on_a = a.middle + closest_along(a, b) * a.direction;
    const Vector3<Rational> on_b = b.middle + closest_along(b, a) * b.direction;
    CHECK((on_b - on_a).dot(a.direction) == 0);
    CHECK((on_b - on_a).dot(b.direction) == 0);
  }
}

TEST_CASE(
    "edge on edge, the point is half the depth from an edge of each box, along the normal", "[O13]")
{
  Draw draw(3);
  int edges = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Obb<double> a = draw.box(), b = draw.box();
    const auto least = separating_axes(a, b);
    if (!least || axis_kind(least->axis) != AxisKind::edges)
    {
      continue;
    }
    ++edges;
    const Manifold<double> manifold = face_clipping(a, b).value();
    REQUIRE(manifold.points.size() == 1);
    CHECK(manifold.points[0].depth == manifold.depth);
    const Vector3<double> half = manifold.normal * (manifold.depth / 2);
    const auto is_on_edge = [](const Obb<double>& box, int k, const Vector3<double>& point)
    {
      const Vector3<double> local = box_coordinates(box, point).cwiseAbs();
      const Vector3<double> beside = (local - box.half_extents).cwiseAbs();
      return local[k] <= box.half_extents[k] + 1e-12 && beside[(k + 1) % 3] <= 1e-12 &&
             beside[(k + 2) % 3] <= 1e-12;
    };
    const Vector3<double>& p = manifold.points[0].position;
    CHECK(is_on_edge(a, (least->axis - 6) / 3, p + half));
    CHECK(is_on_edge(b, (least->axis - 6) % 3, p - half));
  }
  CHECK(edges > 500);
}
// [O13]

namespace
{

using Point2 = Vector<Rational, 2>;

Rational cross(const Point2& p, const Point2& q)
{
  return p.x() * q.y() - p.y() * q.x();
}

// [exact_area]
/// Twice the area of the smallest convex polygon around points, by its lower and upper chain.
Rational doubled_hull_area(std::vector<Point2> points)
{
  std::sort(
      points.begin(), points.end(),
      [](const Point2& p, const Point2& q)
      { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); });
  Rational area = 0;
  for (int way = 0; way < 2; ++way)
  {
    std::vector<Point2> chain;
    for (const Point2& point : points)
    {
      while (chain.size() >= 2 &&
             cross(chain.back() - chain[chain.size() - 2], point - chain.back()) <= 0)
      {
        chain.pop_back();
      }
      chain.push_back(point);
    }
    for (std::size_t i = 1; i < chain.size(); ++i)
    {
      area += cross(chain[i - 1], chain[i]);
    }
    std::reverse(points.begin(), points.end());
  }
  return area;
}

/// Twice the area that a rectangle [−h, h] and a parallelogram have in common: of all corners and
/// all crossings of sides, those that lie in both. It knows nothing of cutting.
Rational
doubled_common_area(const Point2& h, const Point2& center, const Point2& u, const Point2& v)
{
  const auto corners = [](const Point2& c, const Point2& x, const Point2& y) {
    return std::vector<Point2>{c - x - y, c + x - y, c + x + y, c - x + y};
  };
  const Rational area = cross(u, v);
  const auto in_both = [&](const Point2& p)
  {
    const Point2 from = p - center;
    return abs(p.x()) <= h.x() && abs(p.y()) <= h.y() && abs(cross(from, v)) <= abs(area) &&
           abs(cross(u, from)) <= abs(area);
  };
  const std::vector<Point2> of_r = corners({0, 0}, {h.x(), 0}, {0, h.y()}),
                            of_p = corners(center, u, v);
  std::vector<Point2> candidates = of_r;
  candidates.insert(candidates.end(), of_p.begin(), of_p.end());
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t j = 0; j < 4; ++j)
    {
      const Point2 side = of_r[(i + 1) % 4] - of_r[i], other = of_p[(j + 1) % 4] - of_p[j];
      const Rational sine = cross(side, other);
      if (sine != 0)
      {
        candidates.push_back(of_r[i] + side * (cross(of_p[j] - of_r[i], other) / sine));
      }
    }
  }
  candidates.erase(
      std::remove_if(
          candidates.begin(), candidates.end(), [&](const Point2& p) { return !in_both(p); }),
      candidates.end());
  return doubled_hull_area(candidates);
}
// [exact_area]

} // namespace

// [O14]
TEST_CASE("a square turned by 3-4-5 over an equal one: eight corners, an area of 10/3", "[O14]")
{
  // Eight right triangles are missing from 2 · 2: in all the area is 8 / (1 + sin + cos).
  const Obb<Rational> below{{0, 0, 0}, Matrix3<Rational>::Identity(), {1, 1, 1}};
  const Obb<Rational> above{{0, 2, 0}, rational_rotation<Rational>(2, 0, 1, 0), {1, 1, 1}};
  const FacePolygon<Rational> polygon = overlap_polygon<Rational>(
      face_along<Rational>({below, 0}, {0, 1, 0}), face_along<Rational>({above, 12}, {0, -1, 0}),
      0);
  REQUIRE(polygon.size == 8);
  Rational doubled = 0;
  for (int i = 0; i < 8; ++i)
  {
    doubled += cross(polygon[i].point.head<2>(), polygon[i + 1].point.head<2>());
    CHECK(polygon[i].point.z() == 0);
  }
  CHECK(doubled == Rational(-20, 3)); // clockwise: the face of B is seen from behind
}

TEST_CASE(
    "in fractions, 300 polygons have the right area, are convex, and lie in both faces", "[O14]")
{
  Draw draw(4);
  int areas = 0, most = 0;
  for (int i = 0; i < 300; ++i)
  {
    const Obb<Rational> a = draw.whole_box(), b = draw.whole_box();
    const Vector3<Rational> n = (i % 2 == 0 ? 1 : -1) * a.axes.col(i % 3);
    const BoxFace<Rational> reference = face_along<Rational>({a, 0}, n);
    const BoxFace<Rational> incident = face_along<Rational>({b, 12}, -n);
    const FacePolygon<Rational> polygon = overlap_polygon<Rational>(reference, incident, 0);
    REQUIRE(polygon.size <= 8);
    most = std::max(most, polygon.size);
    Rational doubled = 0;
    for (int k = 0; k < polygon.size; ++k)
    {
      const Vector3<Rational>&p = polygon[k].point, &q = polygon[k + 1].point;
      const Point2 side = q.head<2>() - p.head<2>();
      const Point2 next = polygon[k + 2].point.head<2>() - q.head<2>();
      CHECK(cross(side, next) <= 0);
      CHECK(abs(p.x()) <= reference.half_sides.x());
      CHECK(abs(p.y()) <= reference.half_sides.y());
      const Vector3<Rational> on_incident =
          incident.axes.transpose() * (reference.center + reference.axes * p - incident.center);
      CHECK(abs(on_incident.x()) <= incident.half_sides.x());
      CHECK(abs(on_incident.y()) <= incident.half_sides.y());
      CHECK(on_incident.z() == 0);
      doubled -= cross(p.head<2>(), q.head<2>());
    }
    const auto flat = [&](const Vector3<Rational>& v) -> Point2
    { return (reference.axes.transpose() * v).template head<2>(); };
    const Point2 u = flat(incident.axes.col(0)) * incident.half_sides.x();
    const Point2 v = flat(incident.axes.col(1)) * incident.half_sides.y();
    const Point2 center = flat(incident.center - reference.center);
    CHECK(doubled == doubled_common_area(reference.half_sides, center, u, v));
    areas += doubled > 0 ? 1 : 0;
  }
  CHECK(areas > 150);
  CHECK(most >= 7);
}

TEST_CASE("a cube turned by 45° on an equal one: an octagon of 8 (√2 − 1) = 3.3137 m²", "[O14]")
{
  const Obb<double> above{{0, 1.9, 0}, turned(std::atan(1.0), {0, 1, 0}), {1, 1, 1}};
  const Manifold<double> manifold = face_clipping(unit_cube, above).value();
  REQUIRE(manifold.points.size() == 8);
  double doubled = 0;
  for (std::size_t i = 0; i < 8; ++i)
  {
    const Vector3<double>&p = manifold.points[i].position,
          &q = manifold.points[(i + 1) % 8].position;
    CHECK(std::max(std::abs(p.x()), std::abs(p.z())) == Catch::Approx(1).margin(rounding));
    CHECK(p.y() == Catch::Approx(0.95).margin(rounding));
    doubled += p.x() * q.z() - p.z() * q.x();
  }
  CHECK(std::abs(doubled) == Catch::Approx(16 * (std::sqrt(2.0) - 1)).margin(10 * rounding));
}
// [O14]

// [cases]
TEST_CASE(
    "known contacts: ridges, plate, box in a box, stack, beams, cubes in a row, corner, slope",
    "[case:G2][case:G3][case:G4][case:G6][case:G7][case:G8][case:G15][case:G16][case:X09]")
{
  for (const char* const id : {"G2", "G3", "G4", "G6", "G7", "G8", "G15", "G16", "X09"})
  {
    CAPTURE(id);
    const BoxCase pair = case_named(id);
    const Manifold<double> manifold = face_clipping(pair.a, pair.b).value();
    CHECK(manifold.depth == Catch::Approx(pair.depth).margin(20 * rounding));
    CHECK((manifold.normal - pair.normal).norm() <= 10 * rounding);
    REQUIRE(manifold.points.size() == pair.contacts.size());
    CHECK(features(manifold).size() == manifold.points.size());
    for (const Vector3<double>& contact : pair.contacts)
    {
      CHECK(std::any_of(
          manifold.points.begin(), manifold.points.end(),
          [&](const ContactPoint<double>& point)
          { return (point.position - contact).norm() <= 20 * rounding; }));
    }
    for (const ContactPoint<double>& point : manifold.points)
    {
      CHECK(point.depth == Catch::Approx(pair.depth).margin(20 * rounding));
    }
  }
}

TEST_CASE(
    "boxes apart have no manifold, equal boxes in one place have four points", "[case:G1][case:G5]")
{
  CHECK_FALSE(face_clipping(case_named("G1").a, case_named("G1").b));
  const Manifold<double> manifold = face_clipping(unit_cube, unit_cube).value();
  CHECK(manifold.normal == Vector3<double>(1, 0, 0));
  check_depths(manifold, {2, 2, 2, 2});
  for (const ContactPoint<double>& point : manifold.points)
  {
    CHECK(point.position.cwiseAbs() == Vector3<double>(0, 1, 1));
  }
}

TEST_CASE("tilted a little, an edge is least and a stack stands on one point", "[case:G9]")
{
  const Vector3<double> half(0.5, 0.5, 0.5);
  const auto points = [&](double tilt)
  {
    const Obb<double> above{{0, 0.999, 0}, turned(tilt, {1, 2, 3}), half};
    return face_clipping(upright({0, 0, 0}, half), above)->points.size();
  };
  CHECK(points(0) == 4);
  CHECK(points(1e-8) >= 4);
  CHECK(points(1e-5) == 1);
  CHECK(points(1e-3) == 1);
  CHECK(points(1e-2) == 1);
}
// [cases]

// [touching]
TEST_CASE("cubes that touch at a face, an edge, a corner have four points, two, one", "[case:G6]")
{
  const auto points = [](const Vector3<double>& center)
  {
    const Manifold<double> manifold = face_clipping(unit_cube, upright(center, {1, 1, 1})).value();
    CHECK(manifold.depth == 0);
    CHECK(features(manifold).size() == manifold.points.size());
    std::vector<Vector3<double>> positions;
    for (const ContactPoint<double>& point : manifold.points)
    {
      CHECK(point.depth == 0);
      CHECK_FALSE(std::signbit(point.depth));
      positions.push_back(point.position);
    }
    std::sort(
        positions.begin(), positions.end(),
        [](const Vector3<double>& p, const Vector3<double>& q)
        { return std::tuple(p.z(), p.y(), p.x()) < std::tuple(q.z(), q.y(), q.x()); });
    return positions;
  };
  using Points = std::vector<Vector3<double>>;
  CHECK(points({2, 0.5, 0}) == Points{{1, -0.5, -1}, {1, 1, -1}, {1, -0.5, 1}, {1, 1, 1}});
  CHECK(points({2, 2, 0.5}) == Points{{1, 1, -0.5}, {1, 1, 1}});
  CHECK(points({2, 2, -0.5}) == Points{{1, 1, -1}, {1, 1, 0.5}});
  CHECK(points({-2, 2, 0}) == Points{{-1, 1, -1}, {-1, 1, 1}});
  CHECK(points({2, -2, 2}) == Points{{1, -1, 1}});
}

TEST_CASE("flush and touching cubes, turned anyhow, keep their four points", "[case:G6][case:G7]")
{
  Draw draw(5);
  int touching = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const Matrix3<double> anyhow = draw.rotation();
    const Obb<double> a = placed(unit_cube, anyhow);
    CHECK(face_clipping(a, placed(upright({0, 1.9, 0}, {1, 1, 1}), anyhow))->points.size() == 4);
    if (const auto manifold = face_clipping(a, placed(upright({0, 2, 0}, {1, 1, 1}), anyhow)))
    {
      ++touching;
      CHECK(manifold->points.size() == 4);
    }
  }
  // After turning, rounding decides whether they touch.
  CHECK(touching > 300);
}

TEST_CASE(
    "cubes on half steps, turned by quarters and eighths: points close to both, all different")
{
  const double eighth = std::atan(1.0);
  int manifolds = 0;
  for (int i = 0; i < 9 * 9 * 9; ++i)
  {
    const Vector3<double> center(i % 9 * 0.5 - 2, i / 9 % 9 * 0.5 - 2, i / 81 * 0.5 - 2);
    for (int k = 0; k < 9; ++k)
    {
      const Matrix3<double> axes =
          turned(eighth * (k % 3), {1, 0, 0}) * turned(eighth * (k / 3), {0, 0, 1});
      const double half = i % 2 == 0 ? 1 : 0.5;
      const Obb<double> b{center, axes, {half, half, half}};
      if (const auto manifold = face_clipping(unit_cube, b))
      {
        ++manifolds;
        CHECK(farthest_out(*manifold, unit_cube, b) <= 1e-15);
        CHECK(features(*manifold).size() == manifold->points.size());
        CHECK(greatest_depth(*manifold) == Catch::Approx(manifold->depth).margin(rounding));
      }
    }
  }
  CHECK(manifolds > 2000);
}
// [touching]

// [random]
TEMPLATE_TEST_CASE(
    "random pairs: one point to eight, within half the depth of both, the deepest as deep as all",
    "[case:G11]", float, double)
{
  // In float the boxes' own axes are square only to 1e-7, and sums of a few such are compared.
  const double tolerance = std::is_same_v<TestType, float> ? 5e-6 : 1e-12;
  Draw draw(6);
  int overlapping = 0;
  std::array<int, 9> counts{};
  double farthest = -1, shallower = 0;
  for (int i = 0; i < random_pairs; ++i)
  {
    const Obb<TestType> a = box_in<TestType>(draw.box()), b = box_in<TestType>(draw.box());
    const auto manifold = face_clipping(a, b);
    if (!manifold)
    {
      continue;
    }
    ++overlapping;
    ++counts[manifold->points.size()];
    farthest = std::max(farthest, farthest_out(*manifold, a, b));
    const double size = double(a.half_extents.sum() + b.half_extents.sum());
    shallower = std::max(shallower, double(manifold->depth - greatest_depth(*manifold)) / size);
  }
  CHECK(overlapping > random_pairs / 2);
  CHECK(counts[1] > overlapping / 4);
  CHECK(counts[6] > 0);
  CHECK(farthest <= tolerance);
  CHECK(shallower <= tolerance);
}

TEST_CASE(
    "near-parallel stacks: within half the depth of both, down to tilts that rounding hides",
    "[case:G9]")
{
  Draw draw(7);
  int edges = 0;
  for (int i = 0; i < random_pairs / 4; ++i)
  {
    const Obb<double> a = draw.box();
    Obb<double> b = draw.box();
    b.axes = turned(std::ldexp(1.0, -draw.whole(1, 52)), draw.vector(-1, 1)) * a.axes;
    const double height = a.half_extents.y() + b.half_extents.y() - draw.between(0, 0.01);
    b.center = a.center +
               a.axes * Vector3<double>(draw.between(-0.5, 0.5), height, draw.between(-0.5, 0.5));
    if (const auto manifold = face_clipping(a, b))
    {
      REQUIRE(farthest_out(*manifold, a, b) <= 1e-12);
      edges += manifold->points.size() == 1 ? 1 : 0;
    }
  }
  // A modelling matter, see the page: in nearly half of them one point stands where four could.
  CHECK(edges > random_pairs / 4 / 4);
}

TEST_CASE("a grain against a slab a million times its size stays within half the depth of both")
{
  Draw draw(8);
  for (int i = 0; i < 5000; ++i)
  {
    const Obb<double> a = draw.box();
    Obb<double> b = draw.box();
    b.half_extents *= std::ldexp(1.0, -draw.whole(0, 40));
    Vector3<double> where = draw.vector(-1, 1).cwiseProduct(a.half_extents);
    const int k = draw.whole(0, 2);
    where[k] = a.half_extents[k];
    where[(k + i) % 3] = a.half_extents[(k + i) % 3];
    b.center = a.center + a.axes * where;
    if (const auto manifold = face_clipping(a, b))
    {
      REQUIRE(farthest_out(*manifold, a, b) <= 1e-14);
    }
  }
}
// [random]

// [features]
TEST_CASE("a cube turned on a slab: the points are named by the edges that cross there")
{
  // Over the slab's end, at x = 3, two corners of the cube stand inside and two edges cross the
  // rim.
  const Obb<double> slab = upright({0, 0, 0}, {3, 1, 3});
  const Obb<double> cube = upright({2.5, 1.9, 0}, {1, 1, 1});
  // A's rim at +x, +y runs along z: edge 8 + 1 + 2 = 11. B's lower edges: along x at z −1 and +1
  // the numbers 12 and 14, along z at x −1 the number 20.
  const std::set<std::uint32_t> right{
      crossing_feature(20, 12), crossing_feature(12, 11), crossing_feature(11, 14),
      crossing_feature(14, 20)};
  CHECK(features(face_clipping(slab, cube).value()) == right);
  CHECK(crossing_feature(20, 12) == 1 + 24 * 20 + 12);
}

TEST_CASE(
    "a cut leads along the side of the reference face from where it leaves to where it comes back")
{
  using Corners = std::vector<std::pair<Vector3<double>, int>>;
  const BoxFace<double> reference{{0, 0, 0}, Matrix3<double>::Identity(), {1, 5}, {0, 1, 2, 3}};
  const auto cut_at_x = [&](const Corners& corners)
  {
    FacePolygon<double> polygon;
    for (const auto& [point, edge] : corners)
    {
      polygon.add({point, edge});
    }
    const FacePolygon<double> inside = cut_at_side(polygon, reference, 1, 1e-12);
    Corners found;
    for (int i = 0; i < inside.size; ++i)
    {
      found.emplace_back(inside[i].point, inside[i].edge);
    }
    return found;
  };
  // Past the side, over a corner that is on it, beside it, and only touching it.
  CHECK(
      cut_at_x({{{-1, -1, 4}, 20}, {{3, -1, 0}, 21}, {{3, 1, 0}, 22}, {{-1, 1, 4}, 23}}) ==
      Corners{{{-1, -1, 4}, 20}, {{1, -1, 2}, 1}, {{1, 1, 2}, 22}, {{-1, 1, 4}, 23}});
  CHECK(
      cut_at_x({{{-1, -1, 4}, 20}, {{1, -1, 4}, 21}, {{3, 1, 0}, 22}, {{-1, 1, 4}, 23}}) ==
      Corners{{{-1, -1, 4}, 20}, {{1, -1, 4}, 1}, {{1, 1, 2}, 22}, {{-1, 1, 4}, 23}});
  CHECK(
      cut_at_x({{{-1, -1, 0}, 20}, {{1, 0, 0}, 21}, {{-1, 1, 0}, 22}}) ==
      Corners{{{-1, -1, 0}, 20}, {{1, 0, 0}, 21}, {{-1, 1, 0}, 22}});
  CHECK(cut_at_x({{{2, -1, 0}, 20}, {{3, 0, 0}, 21}, {{2, 1, 0}, 22}}).empty());
  CHECK(cut_at_x({{{3, -1, 0}, 20}, {{3, 1, 0}, 21}, {{1, 0, 0}, 22}}) == Corners{{{1, 0, 0}, 1}});
}

TEST_CASE("features are the same whichever box has the reference face")
{
  const Obb<double> a = upright({0, 0, 0}, {2, 0.1, 0.7});
  const Obb<double> b{{0.1, 0.19, 0.2}, turned(0.3, {0, 1, 0}), {0.6, 0.1, 2}};
  const auto named = [&](int axis)
  {
    const BoxesInFrameOfA<double> boxes =
        boxes_in_frame_of_a<double>(a, b, {{0, 1, 0}, 0.01, axis});
    std::set<std::uint32_t> found;
    for (const ContactPoint<double>& point : face_points(boxes))
    {
      found.insert(point.feature);
    }
    return found;
  };
  CHECK(named(1).size() == 4);
  CHECK(named(1) == named(4));
}

TEST_CASE("swapped, boxes have the same points, depths and crossings, and the opposite normal")
{
  Draw draw(9);
  const auto other_way = [](std::uint32_t feature)
  {
    const auto swapped_edge = [](std::uint32_t edge) { return int((edge + 12) % 24); };
    return crossing_feature(swapped_edge((feature - 1) % 24), swapped_edge((feature - 1) / 24));
  };
  int compared = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Obb<double> a = draw.box(), b = draw.box();
    const auto one = face_clipping(a, b), other = face_clipping(b, a);
    REQUIRE(one.has_value() == other.has_value());
    if (!one)
    {
      continue;
    }
    ++compared;
    CHECK((one->normal + other->normal).norm() <= 1e-12);
    REQUIRE(one->points.size() == other->points.size());
    for (const ContactPoint<double>& point : one->points)
    {
      CHECK(std::any_of(
          other->points.begin(), other->points.end(),
          [&](const ContactPoint<double>& same)
          {
            return other_way(same.feature) == point.feature &&
                   (same.position - point.position).norm() <= 1e-12 &&
                   std::abs(same.depth - point.depth) <= 1e-12;
          }));
    }
  }
  CHECK(compared > 1000);
}

TEST_CASE("a turned cube slides over a slab for 5 s: 95 of 100 features stay from frame to frame")
{
  const Obb<double> slab = upright({0, 0, 0}, {1, 0.5, 1});
  std::set<std::uint32_t> before;
  int stayed = 0, all = 0;
  for (int frame = 0; frame <= 300; ++frame)
  {
    const Vector3<double> center(0.6 + 0.1 * frame / 60, 0.99, 0.1);
    const Obb<double> cube{center, turned(0.4, {0, 1, 0}), {0.5, 0.5, 0.5}};
    const std::set<std::uint32_t> now = features(face_clipping(slab, cube).value());
    for (const std::uint32_t feature : before)
    {
      ++all;
      stayed += now.count(feature) == 1 ? 1 : 0;
    }
    before = now;
  }
  CHECK(all >= 1000);
  CHECK(stayed >= all * 95 / 100);
}
// [features]

// [any_size]
TEMPLATE_TEST_CASE(
    "boxes of any size: points scale with the boxes, and are finite", "[case:G12]", float, double)
{
  const Obb<double> a{{0.1, 0.2, 0.3}, turned(0.7, {1, -2, 0.5}), {1, 0.8, 0.9}};
  const Obb<double> b{{0.9, 0.7, 1.4}, turned(-0.4, {3, 1, 0.5}), {0.7, 1, 0.6}};
  const Manifold<double> here = face_clipping(a, b).value();
  using Limits = std::numeric_limits<TestType>;
  for (const TestType scale :
       {Limits::max() / 2, Limits::max() / 64, TestType(1e3), TestType(1e-3), Limits::min() * 1024})
  {
    const auto sized = [&](const Obb<double>& box)
    {
      Obb<TestType> made = box_in<TestType>(box);
      made.center *= scale;
      made.half_extents *= scale;
      return made;
    };
    const auto there = face_clipping(sized(a), sized(b));
    REQUIRE(there);
    CHECK((there->normal.template cast<double>() - here.normal).norm() <= 1e-5);
    CHECK(double(there->depth / scale) == Catch::Approx(here.depth).epsilon(1e-5));
    REQUIRE(there->points.size() == here.points.size());
    for (std::size_t i = 0; i < here.points.size(); ++i)
    {
      const Vector3<TestType> position = there->points[i].position / scale;
      CHECK((position.template cast<double>() - here.points[i].position).norm() <= 1e-5);
      CHECK(there->points[i].feature == here.points[i].feature);
    }
  }
}
// [any_size]

// [beside]
TEST_CASE(
    "an incident face beside the reference face answers with its deepest corner, moved over it")
{
  // What rounding may leave, made large: B's deepest corner is past A's top in x and in z.
  const Obb<double> b{
      {2.6, 1.9, -0.5}, turned(-0.2, {0, 0, 1}) * turned(-0.1, {1, 0, 0}), {1, 1, 1}};
  const BoxesInFrameOfA<double> boxes =
      boxes_in_frame_of_a<double>(unit_cube, b, {{0, 1, 0}, 0.3, 1});
  const ContactPoints<double, 8> points = face_points(boxes);
  REQUIRE(points.size() == 1);
  const Matrix3<double>& r = b.axes;
  Vector3<double> deepest = b.center;
  double lowest = 10;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector3<double> local(corner % 2 * 2 - 1, corner / 2 % 2 * 2 - 1, corner / 4 * 2 - 1);
    const Vector3<double> p = b.center + r * local;
    deepest = p.y() < lowest ? p : deepest;
    lowest = std::min(lowest, p.y());
  }
  CHECK((deepest.x() > 1 && deepest.z() < -1));
  CHECK(points[0].depth == Catch::Approx(1 - lowest).margin(rounding));
  CHECK(
      points[0].position.x() == Catch::Approx(std::clamp(deepest.x(), -1.0, 1.0)).margin(rounding));
  CHECK(points[0].position.y() == Catch::Approx((1 + lowest) / 2).margin(rounding));
  CHECK(
      points[0].position.z() == Catch::Approx(std::clamp(deepest.z(), -1.0, 1.0)).margin(rounding));
}
// [beside]
