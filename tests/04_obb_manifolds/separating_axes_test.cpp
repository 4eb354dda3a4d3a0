/// \file
/// What holds for the fifteen axes of two boxes: formulas O2 to O9 and O16, by hand.

#include "04_obb_manifolds/box_failures/trial/box_pitfalls.hpp"
#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "04_obb_manifolds/separating_axes/separating_axes.hpp"
#include "common/math/rotation.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

using namespace cookbook;

namespace
{

/// A few roundings of numbers of size one: double's unit roundoff is 1.1e-16.
constexpr double rounding = 2e-15;

const Obb<double> cube{{0, 0, 0}, Matrix3<double>::Identity(), {1, 1, 1}};

Obb<double> upright(const Vector3<double>& center, const Vector3<double>& half_extents)
{
  return {center, Matrix3<double>::Identity(), half_extents};
}

/// A box whose axes are the rows of a 3-4-5 triangle about z: every answer is a short fraction.
Obb<double> three_four_five(const Vector3<double>& center, const Vector3<double>& half_extents)
{
  return {center, rational_rotation<double>(2, 0, 0, 1), half_extents};
}

/// Numbers that every compiler draws alike.
class Draw : public BoxDraw
{
public:
  using BoxDraw::BoxDraw;

  Matrix3<double> rotation()
  {
    const Vector3<double> v = vector(-1, 1);
    return Quaternion<double>(between(0.1, 1), v.x(), v.y(), v.z()).normalized().toRotationMatrix();
  }
};

} // namespace

// [O2]
TEST_CASE("a 3-4-5 box reaches 1.4 along x, 2.5 away from a cube: a gap of 0.1", "[O2]")
{
  const Obb<double> turned = three_four_five({2.5, 0, 0}, {1, 1, 1});
  const AxisOverlap<double> along_x = axis_overlap(relative_boxes(cube, turned), 0);
  // 1 of the cube and 0.6 + 0.8 of the oriented box.
  CHECK(along_x.overlap == Catch::Approx(-0.1).margin(rounding));
  CHECK(along_x.offset == 2.5);
  CHECK_FALSE(separating_axes(cube, turned));
}

TEST_CASE("a 3-4-5 box at (2, 1, 0) overlaps a cube by 0.4 and by 0.4 along its own axis", "[O2]")
{
  const Obb<double> turned = three_four_five({2, 1, 0}, {1, 1, 1});
  const RelativeBoxes<double> boxes = relative_boxes(cube, turned);
  CHECK(axis_overlap(boxes, 0).overlap == Catch::Approx(0.4).margin(rounding));
  // B's axis 0 is (0.6, 0.8, 0): 1 + 1.4 less 2·0.6 + 1·0.8.
  CHECK(axis_overlap(boxes, 3).overlap == Catch::Approx(0.4).margin(rounding));
  // B's axis 1 is (−0.8, 0.6, 0): 1 + 1.4 less |−2·0.8 + 1·0.6|.
  CHECK(axis_overlap(boxes, 4).overlap == Catch::Approx(1.4).margin(rounding));
  CHECK(axis_overlap(boxes, 4).offset == Catch::Approx(-1).margin(rounding));
}
// [O2]

// [O3]
TEST_CASE("the reach of both boxes along a0 × b0 is four products, exactly", "[O3]")
{
  // The entries of C by hand from the whole-number quaternion 1 + 2i + 3j + 4k of norm 30.
  const Obb<Rational> a{{0, 0, 0}, Matrix3<Rational>::Identity(), {1, 2, 3}};
  const Obb<Rational> b{{5, 7, 11}, rational_rotation<Rational>(1, 2, 3, 4), {4, 5, 6}};
  const AxisOverlap<Rational> along = edge_axis(relative_boxes(a, b), 0, 0);
  const Rational c10(20, 30), c20(10, 30), c01(4, 30), c02(22, 30);
  const Rational radius_a = 2 * c20 + 3 * c10;
  const Rational radius_b = 5 * c02 + 6 * c01;
  const Rational distance = 11 * c10 - 7 * c20;
  CHECK(along.offset == distance);
  CHECK(along.overlap == radius_a + radius_b - distance);
  CHECK(along.squared_length == c10 * c10 + c20 * c20);
}
// [O3]

// [O4]
TEST_CASE("the length of a_i × b_j is the sine of the angle, √(1 − C_ij²), exactly", "[O4]")
{
  const Obb<Rational> a{{0, 0, 0}, rational_rotation<Rational>(2, 1, 0, 3), {1, 1, 1}};
  const Obb<Rational> b{{0, 0, 0}, rational_rotation<Rational>(1, 2, 3, 4), {1, 1, 1}};
  const RelativeBoxes<Rational> boxes = relative_boxes(a, b);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const Rational cosine = a.axes.col(i).dot(b.axes.col(j));
      CHECK(edge_axis(boxes, i, j).squared_length == 1 - cosine * cosine);
      CHECK(edge_axis(boxes, i, j).axis.squaredNorm() == 1 - cosine * cosine);
    }
  }
}

TEST_CASE(
    "not divided by their length, edges win nearly every stack turned by 0.01", "[O4][case:G9]")
{
  Draw draw(1);
  int edges = 0, wrong = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const Matrix3<double> tilt =
        Eigen::AngleAxis<double>(0.01, draw.vector(-1, 1).normalized()).toRotationMatrix();
    const Obb<double> above{{0, 1.95, 0}, tilt, {1, 1, 1}};
    const double least = separating_axes(cube, above)->depth;
    edges += unnormalized_axes(cube, above)->axis >= 6 ? 1 : 0;
    wrong += unnormalized_axes(cube, above)->depth < least / 2 ? 1 : 0;
  }
  CHECK(edges >= 970);
  CHECK(wrong >= 900);
}
// [O4]

// [near_parallel]
TEST_CASE(
    "float stacks turned by 1e-1 to 1e-9: the fifteen axes keep to 40 roundings, the short reach "
    "calls some apart",
    "[O3][case:G9]")
{
  Draw draw(2);
  int apart = 0;
  float worst = 0, worst_short = 0;
  for (int i = 0; i < 18000; ++i)
  {
    const Matrix3<double> turn =
        Eigen::AngleAxis<double>(std::pow(10.0, -1 - i % 9), draw.vector(-1, 1).normalized())
            .toRotationMatrix();
    const Matrix3<double> anyhow = draw.rotation();
    const Vector3<double> half_a = draw.vector(0.3, 2), half_b = draw.vector(0.3, 2);
    const double height = (half_a.y() + half_b.y()) * draw.between(0.9, 0.9999);
    const Vector3<double> center = anyhow * Vector3<double>(0, height, 0);
    const Obb<float> a{{0, 0, 0}, anyhow.cast<float>(), half_a.cast<float>()};
    const Obb<float> b{center.cast<float>(), (anyhow * turn).cast<float>(), half_b.cast<float>()};
    // The truth: the same float boxes in double, where rounding is 5e8 times smaller.
    const auto wide = [](const Obb<float>& box) -> Obb<double> {
      return {widen(box.center), widen(box.axes), widen(box.half_extents)};
    };
    const double truth = separating_axes(wide(a), wide(b))->depth;
    const float size = a.half_extents.sum() + b.half_extents.sum();
    REQUIRE(separating_axes(a, b));
    const float depth = separating_axes(a, b)->depth;
    worst = std::max(worst, std::abs(depth - static_cast<float>(truth)) / size);
    const auto brief = short_radius_axes(a, b);
    apart += brief ? 0 : 1;
    worst_short = std::max(
        worst_short, brief ? std::abs(brief->depth - static_cast<float>(truth)) / size : 0);
  }
  // The tolerance of ties is 32 ε; the bound O8 of 9 roundings of ε/2 on |t| and on Σh comes on
  // top.
  CHECK(worst <= 41 * std::numeric_limits<float>::epsilon());
  CHECK(apart > 0);
  CHECK(worst_short > 1e-3f);
}
// [near_parallel]

TEST_CASE("leaving out edges whose sine is ε or less keeps the depth to rounding", "[O4]")
{
  const double epsilon = std::numeric_limits<double>::epsilon();
  for (const double sine : {0.0, 0.5 * epsilon, epsilon, 2 * epsilon, 4 * epsilon})
  {
    Matrix3<double> turn;
    turn << 1, 0, sine, 0, 1, 0, -sine, 0, 1;
    const Obb<double> above{{0.3, 1.9, 0.2}, turn, {1, 1, 1}};
    const RelativeBoxes<double> boxes = relative_boxes(cube, above);
    CHECK(from_parallel_edges(edge_axis(boxes, 0, 0)) == (sine <= epsilon));
    CHECK(from_parallel_edges(edge_axis(boxes, 1, 1)));
    CHECK_FALSE(from_parallel_edges(edge_axis(boxes, 0, 1)));
    CHECK(separating_axes(cube, above)->depth == Catch::Approx(0.1).margin(rounding));
    CHECK(separating_axes(cube, above)->axis == 1);
  }
}

// [O6]
TEST_CASE(
    "a cube through a plate overlaps it by 0.6, not by the shorter projection", "[O6][case:G3]")
{
  const Obb<double> plate = upright({0, 0, 0}, {5, 0.1, 5});
  const Obb<double> sunk = upright({0, 0.5, 0}, {1, 1, 1});
  const AxisOverlap<double> up = axis_overlap(relative_boxes(plate, sunk), 1);
  // Projections [−0.1, 0.1] and [−0.5, 1.5]: out upwards by 0.1 + 0.5, down by 1.5 + 0.1.
  CHECK(up.overlap == Catch::Approx(0.6).margin(rounding));
  CHECK(separating_axes(plate, sunk)->depth == Catch::Approx(0.6).margin(rounding));
  CHECK(separating_axes(plate, sunk)->normal == Vector3<double>(0, 1, 0));
}

TEST_CASE(
    "lengths less union says 0.2 for it, and sends the cube through the plate",
    "[O6][case:G3][case:X11][case:X12]")
{
  const auto wrong = union_depth(upright({0, 0, 0}, {5, 0.1, 5}), upright({0, 0.5, 0}, {1, 1, 1}));
  CHECK(wrong->depth == Catch::Approx(0.2).margin(rounding));
  CHECK(wrong->normal == Vector3<double>(0, -1, 0));
}
// [O6]

// [O7]
TEST_CASE("the normal points from A to B, on whichever side B is", "[O7]")
{
  for (const double side : {-1.0, 1.0})
  {
    const auto least = separating_axes(cube, upright({0, 0, side * 1.75}, {1, 1, 1}));
    CHECK(least->normal == Vector3<double>(0, 0, side));
    CHECK(least->depth == 0.25);
    const auto swapped = separating_axes(upright({0, 0, side * 1.75}, {1, 1, 1}), cube);
    CHECK(swapped->normal == Vector3<double>(0, 0, -side));
    CHECK(swapped->depth == 0.25);
  }
}

TEST_CASE("on a slope of 30° the normal is (−1/2, √3/2, 0) and the depth 0.15", "[O7][case:X09]")
{
  const double cosine = std::sqrt(0.75);
  Matrix3<double> slope;
  slope << cosine, -0.5, 0, 0.5, cosine, 0, 0, 0, 1;
  const Obb<double> ground{{0, 0, 0}, slope, {2, 0.5, 1}};
  const Obb<double> on_it{slope * Vector3<double>(0.3, 0.85, 0), slope, {0.5, 0.5, 0.5}};
  const auto least = separating_axes(ground, on_it);
  CHECK((least->normal - Vector3<double>(-0.5, cosine, 0)).norm() <= rounding);
  CHECK(least->depth == Catch::Approx(0.15).margin(rounding));
  CHECK((separating_axes(on_it, ground)->normal + least->normal).norm() <= rounding);
}
// [O7]

// [O8]
TEMPLATE_TEST_CASE(
    "turning both boxes together changes an overlap by less than O8 allows", "[O8]", float, double)
{
  using Real = TestType;
  Draw draw(3);
  for (int i = 0; i < 2000; ++i)
  {
    const Matrix3<double> turn = draw.rotation();
    const Obb<double> b{draw.vector(-1, 1), draw.rotation(), draw.vector(0.5, 2)};
    const auto exact = least_overlap(cube, b, box_axes);
    const Obb<Real> a_turned{{0, 0, 0}, turn.cast<Real>(), {1, 1, 1}};
    const Obb<Real> b_turned{
        (turn * b.center).cast<Real>(), (turn * b.axes).cast<Real>(), b.half_extents.cast<Real>()};
    const RelativeBoxes<Real> boxes = relative_boxes(a_turned, b_turned);
    const auto rounded = separating_axes(a_turned, b_turned);
    REQUIRE(exact.has_value() == rounded.has_value());
    if (exact)
    {
      CHECK(std::abs(double(rounded->depth) - exact->depth) <= double(rounding_tolerance(boxes)));
    }
  }
}

TEMPLATE_TEST_CASE(
    "of 2,000 pairs of plates 1 to 1,000 across, no overlap is off by more than its own terms "
    "allow",
    "[O8]", float, double)
{
  using Real = TestType;
  Draw draw(8);
  const auto plate = [&]() -> Obb<Real>
  {
    const Vector3<double> half(
        std::pow(10, draw.between(0, 3)), std::pow(10, draw.between(0, 3)), draw.between(0.1, 1));
    const Matrix3<double> turn = draw.rotation();
    const Vector3<double> center = turn * draw.vector(-1, 1).cwiseProduct(half);
    return {center.cast<Real>(), turn.cast<Real>(), half.cast<Real>()};
  };
  using Exact = cookbook::Reference;
  for (int i = 0; i < inputs(2000, 100); ++i)
  {
    const Obb<Real> a = plate(), b = plate();
    const RelativeBoxes<Real> boxes = relative_boxes(a, b);
    const RelativeBoxes<Exact> exact = relative_boxes<Exact>(
        {a.center.template cast<Exact>(), a.axes.template cast<Exact>(),
         a.half_extents.template cast<Exact>()},
        {b.center.template cast<Exact>(), b.axes.template cast<Exact>(),
         b.half_extents.template cast<Exact>()});
    const RoundedTerms<Real> terms = rounded_terms(a, b);
    for (int axis = 0; axis < box_axes; ++axis)
    {
      // Along the very direction that was computed, or, for B's faces, the one that was meant.
      const AxisOverlap<Real> along = axis_overlap(boxes, axis);
      const Vector3<Exact> direction = axis_kind(axis) == AxisKind::face_of_b
                                           ? Vector3<Exact>(exact.rotation.col(axis - 3))
                                           : along.axis.template cast<Exact>();
      const Vector3<Exact> in_b = exact.rotation.transpose() * direction;
      const Exact truth = (direction.cwiseAbs().dot(exact.half_a) +
                           in_b.cwiseAbs().dot(exact.half_b) - abs(direction.dot(exact.offset))) /
                          direction.norm();
      const double off = double(along.overlap / std::sqrt(along.squared_length) - truth);
      CHECK(std::abs(off) <= double(overlap_rounding(terms, along, axis)));
    }
  }
}

TEST_CASE(
    "an axis' own terms, by hand: 76/30, 110/30, 132/30 along A's, 17/3 along B's second", "[O8]")
{
  // 30 |C| has the rows (20, 4, 22), (20, 10, 20), (10, 28, 4); A is (1, 2, 3), B a cube of 1.
  const Obb<double> a = upright({0, 0, 0}, {1, 2, 3});
  const Obb<double> b{{0, 0, 0}, rational_rotation<double>(1, 2, 3, 4), {1, 1, 1}};
  const RoundedTerms<double> terms = rounded_terms(a, b);
  const auto separations = [&](int axis)
  {
    const AxisOverlap<double> along = axis_overlap(relative_boxes(a, b), axis);
    return overlap_rounding(terms, along, axis) / std::numeric_limits<double>::epsilon();
  };
  CHECK(separations(0) == Catch::Approx(8 * 76 / 30.0));
  CHECK(separations(1) == Catch::Approx(8 * 110 / 30.0));
  CHECK(separations(2) == Catch::Approx(8 * 132 / 30.0));
  CHECK(separations(4) == Catch::Approx(8 * (4 * 76 + 10 * 110 + 28 * 132) / 900.0));
  // a0 × b0 is (0, −10, 20)/30.
  CHECK(separations(6) == Catch::Approx(8 * (10 * 110 + 20 * 132) / (30 * std::sqrt(500.0))));
}

TEST_CASE("two overlaps are told apart beyond both their roundings: 24 + 24 ε", "[O8][O9]")
{
  // Along each of x and y: 1 of the offset, 1 of either cube.
  const Obb<double> b = upright({1, 1, 0}, {1, 1, 1});
  const double epsilon = std::numeric_limits<double>::epsilon();
  const RelativeBoxes<double> boxes = relative_boxes(cube, b);
  CHECK_FALSE(is_beyond_rounding(47 * epsilon, cube, b, boxes, 0, 1));
  CHECK(is_beyond_rounding(49 * epsilon, cube, b, boxes, 0, 1));
  CHECK_FALSE(is_beyond_rounding(39 * epsilon, cube, b, boxes, 0, 2));
  CHECK(is_beyond_rounding(41 * epsilon, cube, b, boxes, 2, 0));
}
// [O8]

// [O9]
TEMPLATE_TEST_CASE(
    "on the rim of a plate 2 km across, 1 mm up is less than 5 mm aside, in float too", "[O8][O9]",
    float, double)
{
  using Real = TestType;
  const Matrix3<Real> straight = Matrix3<Real>::Identity();
  const Obb<Real> plate{{0, 0, 0}, straight, {1000, 1000, 1}};
  for (const Real side : {Real(-1), Real(1)})
  {
    const Obb<Real> on_rim{{side * Real(1000.995), 0, Real(1.999)}, straight, {1, 1, 1}};
    // A float near 2 is known to 2.4e-7; 32 ε Σh would be 7.6e-3 here.
    CHECK(separating_axes(plate, on_rim)->axis == 2);
    CHECK(separating_axes(plate, on_rim)->depth == Catch::Approx(0.001).margin(3e-7));
    CHECK(separating_axes(on_rim, plate)->axis == 2);
    CHECK(separating_axes(on_rim, plate)->depth == Catch::Approx(0.001).margin(3e-7));
  }
}

TEMPLATE_TEST_CASE(
    "plates of 2 km, one flush on the other and turned anyhow: A's face decides", "[O9]", float,
    double)
{
  using Real = TestType;
  Draw draw(9);
  for (int i = 0; i < 1000; ++i)
  {
    const Matrix3<double> turn = draw.rotation();
    const Vector3<double> place(draw.between(-900, 900), draw.between(-900, 900), 1.99);
    const Obb<Real> a{{0, 0, 0}, turn.cast<Real>(), {1000, 1000, 1}};
    const Obb<Real> b{(turn * place).template cast<Real>(), a.axes, a.half_extents};
    REQUIRE(separating_axes(a, b));
    CHECK(separating_axes(a, b)->axis == 2);
    CHECK(separating_axes(b, a)->axis == 2);
  }
}

TEST_CASE("equal cubes, one turned with the other: a face of A decides, not an edge", "[O9]")
{
  Draw draw(4);
  for (int i = 0; i < 1000; ++i)
  {
    const Matrix3<double> turn = draw.rotation();
    const Obb<double> a{{0, 0, 0}, turn, {1, 1, 1}};
    const Obb<double> b{turn.col(1) * 1.9, turn, {1, 1, 1}};
    CHECK(separating_axes(a, b)->axis == 1);
    CHECK(separating_axes(b, a)->axis == 1);
  }
}

TEST_CASE("turned about the height, the faces above each other tie, and A's wins", "[O9]")
{
  for (const double height : {1.5, 1.9, 1.9999})
  {
    const Obb<double> b{{0, height, 0}, rational_rotation<double>(5, 0, 1, 0), {1, 1, 1}};
    CHECK(separating_axes(cube, b)->axis == 1);
    CHECK(separating_axes(b, cube)->axis == 1);
  }
}

TEST_CASE("a face of B decides only where it is better than A's by more than rounding", "[O9]")
{
  // A turned cube on a cube's edge: B's face has less overlap than any of A's.
  const Obb<double> b = three_four_five({1.5, 1.5, 0}, {1, 1, 1});
  // Along B's axis 0, (0.6, 0.8, 0): 1 + 1.4 less 2.1; along x and y 1 + 1.4 less 1.5.
  CHECK(separating_axes(cube, b)->axis == 3);
  CHECK(separating_axes(cube, b)->depth == Catch::Approx(0.3).margin(rounding));
  CHECK(separating_axes(b, cube)->axis == 0);
}
// [O9]

// [degenerate]
TEST_CASE("equal boxes in one place part along +a0 by 2, each time", "[case:G5]")
{
  CHECK(separating_axes(cube, cube)->normal == Vector3<double>(1, 0, 0));
  CHECK(separating_axes(cube, cube)->depth == 2);
  Draw draw(5);
  for (int i = 0; i < 1000; ++i)
  {
    const Obb<double> box{draw.vector(-9, 9), draw.rotation(), {1, 1, 1}};
    const auto least = separating_axes(box, box);
    CHECK(least->axis == 0);
    CHECK((least->normal - box.axes.col(0)).norm() <= rounding);
    CHECK(least->depth == Catch::Approx(2).margin(rounding));
  }
}

TEMPLATE_TEST_CASE(
    "touching cubes overlap by 0; one unit in the last place farther they do not", "[case:G6]",
    float, double)
{
  using Real = TestType;
  const Obb<Real> a{{0, 0, 0}, Matrix3<Real>::Identity(), {1, 1, 1}};
  Obb<Real> b{{0, 2, 0}, Matrix3<Real>::Identity(), {1, 1, 1}};
  CHECK(separating_axes(a, b)->depth == 0);
  CHECK(separating_axes(b, a)->depth == 0);
  b.center.y() = std::nextafter(Real(2), Real(3));
  CHECK_FALSE(separating_axes(a, b));
}

TEST_CASE("touching is no contact for the published rule", "[case:G6][case:X13]")
{
  CHECK_FALSE(union_depth(cube, upright({0, 2, 0}, {1, 1, 1})));
}

TEMPLATE_TEST_CASE(
    "every finite box up to a hundredth of the largest number gives a finite answer", "[O2]", float,
    double)
{
  using Real = TestType;
  const Real most = std::numeric_limits<Real>::max() / 100,
             least = std::numeric_limits<Real>::min();
  for (const Real size : {least, Real(1), most})
  {
    const Obb<Real> a{{0, 0, 0}, Matrix3<Real>::Identity(), {size, size, size}};
    for (const Real place : {Real(0), least, Real(1), most})
    {
      const Obb<Real> b{
          {place, -place, place}, rational_rotation<Real>(1, 2, 3, 4), {size, size, size}};
      const auto answer = separating_axes(a, b);
      CHECK(answer.has_value() == (place <= size));
      if (answer)
      {
        CHECK(answer->normal.norm() == Catch::Approx(1));
        CHECK(std::isfinite(answer->depth));
        CHECK(answer->depth >= 0);
      }
    }
  }
}
// [degenerate]

// [O16]
TEST_CASE("moved apart by half the depth each, boxes touch: the overlap is 0 to rounding", "[O16]")
{
  Draw draw(6);
  int overlapping = 0;
  for (int i = 0; i < 2000; ++i)
  {
    Obb<double> a{draw.vector(-1, 1), draw.rotation(), draw.vector(0.3, 2)};
    Obb<double> b{draw.vector(-1, 1), draw.rotation(), draw.vector(0.3, 2)};
    const auto least = separating_axes(a, b);
    if (!least)
    {
      continue;
    }
    ++overlapping;
    a.center -= least->depth / 2 * least->normal;
    b.center += least->depth / 2 * least->normal;
    const RelativeBoxes<double> boxes = relative_boxes(a, b);
    const AxisOverlap<double> along = axis_overlap(boxes, least->axis);
    const double left = along.overlap / std::sqrt(along.squared_length);
    CHECK(std::abs(left) <= rounding_tolerance(boxes));
  }
  CHECK(overlapping > 1000);
}
// [O16]

// [needed]
TEST_CASE("boxes turned about one common axis: the nine pairs of edges change nothing", "[case:G1]")
{
  Draw draw(7);
  const auto upright_turned = [&]
  {
    const Matrix3<double> turn =
        Eigen::AngleAxis<double>(draw.between(-3, 3), Vector3<double>::UnitY()).toRotationMatrix();
    return Obb<double>{draw.vector(-2, 2), turn, draw.vector(0.3, 2)};
  };
  int apart = 0;
  for (int i = 0; i < 5000; ++i)
  {
    const Obb<double> a = upright_turned(), b = upright_turned();
    const auto all = separating_axes(a, b), six = six_axes(a, b);
    REQUIRE(all.has_value() == six.has_value());
    apart += all ? 0 : 1;
    if (all)
    {
      CHECK(std::abs(all->depth - six->depth) <= rounding_tolerance(relative_boxes(a, b)));
    }
  }
  CHECK(apart > 500);
  CHECK(apart < 4500);
}

TEST_CASE(
    "cubes edge to edge are 0.0495 apart, and six axes call it an overlap of 0.25",
    "[case:G1][case:X08]")
{
  const double quarter = std::atan(1.0);
  const Matrix3<double> turn =
      Eigen::AngleAxis<double>(quarter, Vector3<double>(-1, 1, 0).normalized()).toRotationMatrix();
  const Obb<double> b{{2.25, 2.25, 0}, turn, {1, 1, 1}};
  CHECK_FALSE(separating_axes(cube, b));
  CHECK(six_axes(cube, b)->depth == Catch::Approx(0.25).margin(rounding));
  // B's axis 0 is (1 + √½, √½ − 1, −1)/2, so L = a2 × b0 is (1 − √½, 1 + √½, 0)/2 and |L|² is 3/4.
  // A reaches 1 along L, B 1/2 + √½, and the centres are 2.25 apart.
  const AxisOverlap<double> edges = edge_axis(relative_boxes(cube, b), 2, 0);
  CHECK(edges.squared_length == Catch::Approx(0.75).margin(rounding));
  CHECK(edges.overlap == Catch::Approx(std::sqrt(0.5) - 0.75).margin(rounding));
  CHECK(edges.overlap / std::sqrt(0.75) == Catch::Approx(-0.0495).margin(5e-5));
}
// [needed]
