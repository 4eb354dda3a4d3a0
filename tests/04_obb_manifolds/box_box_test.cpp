/// \file
/// What holds for the manifolds of box_box(), worked out by hand; random pairs are in
/// box_box_accuracy_test.cpp.

#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_box/trial/compare_pairs.hpp"
#include "04_obb_manifolds/box_cases/trial/box_cases.hpp"
#include "04_obb_manifolds/face_clipping/face_clipping.hpp"
#include "04_obb_manifolds/feature_memory/feature_memory.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <fstream>
#include <set>

using namespace cookbook;

namespace
{

/// Rounding of a few sums of numbers up to four.
template <class Real>
constexpr double rounding = 32 * static_cast<double>(std::numeric_limits<Real>::epsilon());

/// The boxes' numbers in `Real`.
template <class Real>
std::optional<Manifold<Real>> manifold_of(const Obb<double>& a, const Obb<double>& b)
{
  return box_box(box_in<Real>(a), box_in<Real>(b));
}

/// That there is exactly one point at each place, each as deep as said.
template <class Real>
void check_points(
    const Manifold<Real>& manifold, const std::vector<Vector3<double>>& places, double depth,
    double tolerance)
{
  REQUIRE(manifold.points.size() == places.size());
  std::set<std::uint32_t> features;
  for (const Vector3<double>& place : places)
  {
    CAPTURE(place.transpose());
    const auto is_there = [&](const ContactPoint<Real>& point)
    { return (point.position.template cast<double>() - place).norm() <= tolerance; };
    CHECK(std::count_if(manifold.points.begin(), manifold.points.end(), is_there) == 1);
  }
  for (const ContactPoint<Real>& point : manifold.points)
  {
    CHECK(double(point.depth) == Catch::Approx(depth).margin(tolerance));
    features.insert(point.feature);
  }
  CHECK(features.size() == places.size());
}

/// That a manifold has this normal and depth, and these points.
template <class Real>
void check_manifold(
    const std::optional<Manifold<Real>>& manifold, const Vector3<double>& normal, double depth,
    const std::vector<Vector3<double>>& places)
{
  REQUIRE(manifold);
  CHECK((manifold->normal.template cast<double>() - normal).norm() <= rounding<Real>);
  CHECK(double(manifold->depth) == Catch::Approx(depth).margin(rounding<Real>));
  check_points(*manifold, places, depth, rounding<Real>);
}

const Obb<double> cube = upright({0, 0, 0}, {1, 1, 1});
const double eighth = std::atan(1.0);

} // namespace

// [faces]
TEMPLATE_TEST_CASE(
    "a cube beside the middle of another, 0.25 deep: the four corners of the common rectangle",
    "[O12][O16]", float, double)
{
  //        +-------+ 2.75          seen along -z; B is 0.5 to the right and 0.25 towards us.
  //        |   B   |               The faces share x from -0.5 to 1 and z from -0.75 to 1;
  //   +----|..+    | 1             midway between A's top, 1, and B's bottom, 0.75, is 0.875.
  //   |  A +--|----+ 0.75
  //   +-------+
  const Obb<double> above = upright({0.5, 1.75, 0.25}, {1, 1, 1});
  const std::vector<Vector3<double>> corners{
      {-0.5, 0.875, -0.75}, {-0.5, 0.875, 1}, {1, 0.875, -0.75}, {1, 0.875, 1}};
  check_manifold(manifold_of<TestType>(cube, above), {0, 1, 0}, 0.25, corners);
  check_manifold(manifold_of<TestType>(above, cube), {0, -1, 0}, 0.25, corners);
}

TEMPLATE_TEST_CASE(
    "a cube turned by 45° on another: eight points, at 1 and at the root of two less one", "[O14]",
    float, double)
{
  const double root = std::sqrt(2.0) - 1;
  std::vector<Vector3<double>> corners;
  for (const double x : {-1.0, 1.0})
  {
    for (const double z : {-root, root})
    {
      corners.insert(corners.end(), {{x, 0.95, z}, {z, 0.95, x}});
    }
  }
  const Obb<double> above{{0, 1.9, 0}, turned(eighth, {0, 1, 0}), {1, 1, 1}};
  check_manifold(manifold_of<TestType>(cube, above), {0, 1, 0}, 0.1, corners);
}
// [faces]

// [edges]
TEMPLATE_TEST_CASE(
    "two ridges, one across the other, 0.0625 deep: one point between them", "[O13]", float, double)
{
  //      \  B  /
  //       \   /       A's ridge runs along x at the height of the root of two,
  //   -----\ /----    B's runs along z through x = 0.25, a sixteenth below that.
  //     A   v
  const double ridge = std::sqrt(2.0);
  const Obb<double> below{{0, 0, 0}, turned(eighth, {1, 0, 0}), {1, 1, 1}};
  const Obb<double> above{{0.25, 2 * ridge - 0.0625, 0.5}, turned(eighth, {0, 0, 1}), {1, 1, 1}};
  const std::vector<Vector3<double>> point{{0.25, ridge - 0.03125, 0}};
  check_manifold(manifold_of<TestType>(below, above), {0, 1, 0}, 0.0625, point);
  check_manifold(manifold_of<TestType>(above, below), {0, -1, 0}, 0.0625, point);
}
// [edges]

// [corner]
TEMPLATE_TEST_CASE("a cube on its corner: one point, on the way down", "[O12]", float, double)
{
  const Matrix3<double> on_corner = turned(std::atan(std::sqrt(2.0)), {-1, 0, 1});
  const Obb<double> above{{0.5, 1 + std::sqrt(3.0) - 0.0625, 0.25}, on_corner, {1, 1, 1}};
  const std::vector<Vector3<double>> point{{0.5, 0.96875, 0.25}};
  check_manifold(manifold_of<TestType>(cube, above), {0, 1, 0}, 0.0625, point);
  check_manifold(manifold_of<TestType>(above, cube), {0, -1, 0}, 0.0625, point);
}
// [corner]

// [deep]
TEMPLATE_TEST_CASE(
    "a small box deep in a large one leaves by the nearest face", "[O6][O18]", float, double)
{
  // Its far side, at 0.25, is 1.75 from the large box's face at 2; the other ways are longer.
  const Obb<double> large = upright({0, 0, 0}, {2, 2, 2});
  const Obb<double> small = upright({0, 0.5, 0.125}, {0.25, 0.25, 0.25});
  std::vector<Vector3<double>> corners = rectangle(0.25, 1.125, 0.25);
  for (Vector3<double>& corner : corners)
  {
    corner.z() += 0.125;
  }
  check_manifold(manifold_of<TestType>(large, small), {0, 1, 0}, 1.75, corners);
}

TEMPLATE_TEST_CASE("a plate on a plate: midway, however thin", "[O16]", float, double)
{
  const Obb<double> below = upright({0, 0, 0}, {1, 0.015625, 1});
  const Obb<double> above = upright({0.5, 0.030273, 0}, {1, 0.015625, 0.5});
  const double depth = 0.03125 - 0.030273;
  check_manifold(
      manifold_of<TestType>(below, above), {0, 1, 0}, depth,
      {{-0.5, 0.0151365, -0.5}, {-0.5, 0.0151365, 0.5}, {1, 0.0151365, -0.5}, {1, 0.0151365, 0.5}});
}
// [deep]

// [touching]
TEMPLATE_TEST_CASE(
    "cubes that touch have depth 0 and all four points; a gap of a millionth separates them",
    "[O5]", float, double)
{
  check_manifold(
      manifold_of<TestType>(cube, upright({2, 0.5, 0}, {1, 1, 1})), {1, 0, 0}, 0,
      {{1, -0.5, -1}, {1, -0.5, 1}, {1, 1, -1}, {1, 1, 1}});
  CHECK_FALSE(manifold_of<TestType>(cube, upright({2.000001, 0.5, 0}, {1, 1, 1})));
  const Obb<double> across{{2 * std::sqrt(2.0) + 1e-6, 0, 0}, turned(eighth, {0, 1, 0}), {1, 1, 1}};
  const Obb<double> standing{{0, 0, 0}, turned(eighth, {0, 0, 1}), {1, 1, 1}};
  CHECK_FALSE(manifold_of<TestType>(standing, across));
}
// [touching]

// [touching_edges]
TEMPLATE_TEST_CASE(
    "of a lattice, boxes that touch along an edge have its two ends, at a corner that one", "[O5]",
    float, double)
{
  using Real = TestType;
  Matrix3<double> turn;
  turn << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const auto lies = [](const auto& points, const Vector3<Real>& place)
  {
    return std::count_if(
        points.begin(), points.end(),
        [&](const ContactPoint<Real>& point)
        { return (point.position - place).norm() <= Real(rounding<Real>); });
  };
  std::size_t edges = 0, corners = 0, wrong = 0;
  for (int i = 0; i < 27 * 17 * 17 * 17; ++i)
  {
    // Halves of whole numbers: half extents up to 1.5, centres up to 4 to either side.
    const int k = i / 27;
    const Vector3<double> half(1 + i % 3, 1 + i / 3 % 3, 1 + i / 9 % 3);
    const Vector3<double> center(k % 17 - 8, k / 17 % 17 - 8, k / 289 - 8);
    const Obb<double> b{center / 2, i % 2 == 0 ? turn : cube.axes, half / 2};
    const Vector3<double> radius = b.axes * b.half_extents;
    const Vector3<double> overlap = cube.half_extents + radius - b.center.cwiseAbs();
    const auto touching = (overlap.array() == 0).count();
    if (overlap.minCoeff() < 0 || touching < 2)
    {
      continue;
    }
    const Manifold<Real> ours = manifold_of<Real>(cube, b).value();
    const Manifold<Real> clipped = face_clipping(box_in<Real>(cube), box_in<Real>(b)).value();
    (touching == 2 ? edges : corners) += 1;
    wrong += ours.points.size() == std::size_t(touching == 2 ? 2 : 1) ? 0 : 1;
    wrong += ours.depth == Real(0) && ours.normal == clipped.normal ? 0 : 1;
    for (const ContactPoint<Real>& point : clipped.points)
    {
      wrong += lies(ours.points, point.position) == 1 ? 0 : 1;
    }
  }
  CHECK(edges == 2268);
  CHECK(corners == 216);
  CHECK(wrong == 0);
}
// [touching_edges]

namespace
{

/// Whether there is a manifold, with points and without a NaN or an infinity.
template <class Real>
bool answers(const Obb<double>& a, const Obb<double>& b)
{
  const auto manifold = manifold_of<Real>(a, b);
  return manifold && is_whole(*manifold) && manifold->depth >= Real(0);
}

} // namespace

// [degenerate]
TEMPLATE_TEST_CASE(
    "flat boxes, segments, points and boxes in one place have an answer in numbers", "[O9]", float,
    double)
{
  const Matrix3<double> anyhow = turned(0.7, {1, 2, 3});
  for (const Vector3<double>& half :
       std::vector<Vector3<double>>{{1, 0, 1}, {0, 1, 0}, {0, 0, 0}, {1, 1, 1}, {1e-20, 1, 1e-20}})
  {
    CAPTURE(half.transpose());
    for (const Matrix3<double>& axes : {Matrix3<double>(Matrix3<double>::Identity()), anyhow})
    {
      CHECK(answers<TestType>(cube, {{0, 0, 0}, axes, half}));
      CHECK(answers<TestType>({{0, 0, 0}, axes, half}, cube));
      CHECK(answers<TestType>({{0, 0, 0}, axes, half}, {{0, 0, 0}, axes, half}));
    }
  }
}

TEMPLATE_TEST_CASE(
    "equal cubes in one place leave along A's first axis: their depth is their width", "[O9]",
    float, double)
{
  const auto manifold = manifold_of<TestType>(cube, cube);
  REQUIRE(manifold);
  CHECK(manifold->depth == 2);
  CHECK(std::abs(manifold->normal.x()) == 1);
  CHECK(manifold->points.size() == 4);
}

TEMPLATE_TEST_CASE("boxes of 1e-30 m and of 1e30 m have answers in numbers", "[O9]", float, double)
{
  for (const double size : {1e-30, 1e-12, 1e12, 1e30})
  {
    CAPTURE(size);
    const Vector3<double> half(size, size, size);
    const Matrix3<double> anyhow = turned(0.7, {1, 2, 3});
    CHECK(answers<TestType>(upright({0, 0, 0}, half), upright({0, 1.9 * size, 0}, half)));
    CHECK(answers<TestType>(upright({0, 0, 0}, half), {{0, size, 0}, anyhow, half}));
    CHECK_FALSE(manifold_of<TestType>(upright({0, 0, 0}, half), upright({0, 2.1 * size, 0}, half)));
  }
}
// [degenerate]

TEST_CASE("pairs repeated at random are each there equally often", "[compare_pairs]")
{
  const BoxPair<float> one{box_in<float>(cube), box_in<float>(cube)};
  BoxPair<float> two = one;
  two.second.center.x() = 3;
  BoxPairLists given = box_pair_lists({one, two, one});
  const BoxPairLists many = repeated_at_random(given, 100);
  CHECK(many.in_float.size() == 102);
  CHECK(many.in_double.size() == 102);
  const auto is_two = [](const auto& pair) { return pair.second.center.x() == 3; };
  CHECK(std::count_if(many.in_float.begin(), many.in_float.end(), is_two) == 34);
  CHECK(std::count_if(many.in_double.begin(), many.in_double.end(), is_two) == 34);
}

TEST_CASE("times are compared with box_box in the same scalar type", "[compare_pairs]")
{
  const auto timed = [](const std::string& name, double ns) {
    return MeasuredBoxMethod{{{name, ns, ns}}, {}};
  };
  const Cells table = compared_table(
      {timed("fast, float", 50), timed("fast, double", 100), timed("box_box, float", 100),
       timed("box_box, double", 400)});
  CHECK(table[1][2] == "0.5");
  CHECK(table[2][2] == "0.25");
  CHECK(table[4][2] == "1");
}

TEST_CASE("a wrong verdict, an error of the depth and lost points are found", "[compare_pairs]")
{
  const Obb<double> above = upright({0, 1.9, 0}, {1, 1, 1});
  const BoxPair<double> pair{cube, above};
  const auto right = box_box(cube, above);
  CHECK_FALSE(manifold_check(pair, right).wrong);
  CHECK(manifold_check(pair, right).rests);
  CHECK_FALSE(manifold_check(pair, right).points_lost);
  CHECK(manifold_check(pair, right).depth_error < 1e-15);
  const std::optional<Manifold<double>> none;
  CHECK(manifold_check(pair, none).wrong);
  CHECK(manifold_check(pair, none).points_lost);
  Manifold<double> deeper = *right;
  deeper.depth += 0.01;
  CHECK(manifold_check(pair, std::optional(deeper)).depth_error == Catch::Approx(0.01));
  const Manifold<double> single{
      right->normal, right->depth, ContactPoints<double, 8>(right->points[0])};
  CHECK(manifold_check(pair, std::optional(single)).points_lost);
  CHECK(box_accuracy({manifold_check(pair, right), manifold_check(pair, none)}).wrong == 1);
  CHECK(box_accuracy({manifold_check(pair, right), manifold_check(pair, none)}).compared == 1);
}
