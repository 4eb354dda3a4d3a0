/// \file
/// What holds for the point of a box closest to another, and for the signed distance between
/// them: formulas P3 to P5 and P21, and the points that break a way to answer.

#include "02_primitives/closest_point_box/closest_point_box.hpp"
#include "02_primitives/closest_point_box/trial/closest_point_box_cases.hpp"
#include "common/math/rotation.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

using namespace cookbook;

namespace
{

using Exact3 = Vector3<Rational>;

/// Turned about z by the 3-4-5 triangle, c = 4/5 and s = 3/5, away from the origin.
template <class Real>
Obb<Real> oriented_box()
{
  return {{1, 2, 3}, rational_rotation<Real>(3, 0, 0, 1), {2, 1, Real(1) / Real(2)}};
}

/// Turned about no axis in particular.
const Obb<Rational> skew_box{
    {1, 2, 3}, rational_rotation<Rational>(1, 2, 3, 4), {2, 1, Rational(1, 2)}};

/// The eight corners, by their signs.
template <class Real>
std::vector<Vector3<Real>> corners(const Obb<Real>& box)
{
  std::vector<Vector3<Real>> all;
  for (int i = 0; i < 8; ++i)
  {
    const Vector3<Real> signs(Real(i & 1 ? 1 : -1), Real(i & 2 ? 1 : -1), Real(i & 4 ? 1 : -1));
    all.push_back(box.center + box.axes * signs.cwiseProduct(box.half_extents));
  }
  return all;
}

/// Points one half apart, all around a box's centre and beyond its corners.
std::vector<Exact3> lattice(const Obb<Rational>& box)
{
  std::vector<Exact3> points;
  for (int x = -6; x <= 6; ++x)
  {
    for (int y = -6; y <= 6; ++y)
    {
      for (int z = -6; z <= 6; ++z)
      {
        points.push_back(box.center + Exact3(Rational(x, 2), Rational(y, 2), Rational(z, 2)));
      }
    }
  }
  return points;
}

/// How far behind each of the box's six faces a point is, measured from two corners that no
/// coordinate along an axis enters into; the least of the six.
Rational least_inset(const Obb<Rational>& box, const Exact3& point)
{
  const std::vector<Exact3> corner = corners(box);
  Rational least = 1000;
  for (int i = 0; i < 3; ++i)
  {
    const Exact3 normal = box.axes.col(i);
    least = std::min<Rational>(least, normal.dot(Exact3(corner[7] - point)));
    least = std::min<Rational>(least, normal.dot(Exact3(point - corner[0])));
  }
  return least;
}

/// A few roundings of numbers of size one: double's unit roundoff is 1.1e-16.
constexpr double rounding = 1e-15;

} // namespace

// [P3]
TEST_CASE(
    "the box of half extents (2,1,1/2) clamps (5,-3,1/4) to (2,-1,1/4), once and twice", "[P3]")
{
  const Vector3<double> half(2, 1, 0.5);
  const Vector3<double> clamped = clamp_to_box<double>({5, -3, 0.25}, half);
  CHECK(clamped == Vector3<double>(2, -1, 0.25));
  CHECK(clamp_to_box(clamped, half) == clamped);
  CHECK(clamp_to_box<double>({-5, 3, -0.75}, half) == Vector3<double>(-2, 1, -0.5));
}
// [P3]

// [P4]
TEST_CASE(
    "(4.7,5.4,0) is closest to (2.3,3.6,2.5) of a box turned 3-4-5 about (1,2,3)", "[P4][case:D7]")
{
  // 5 along the first axis (4,3,0)/5, 1/2 along the second (-3,4,0)/5, -3 along z.
  const Exact3 point(Rational(47, 10), Rational(54, 10), 0);
  const Exact3 closest(Rational(23, 10), Rational(36, 10), Rational(5, 2));
  CHECK(box_coordinates(oriented_box<Rational>(), point) == Exact3(5, Rational(1, 2), -3));
  CHECK(closest_point(oriented_box<Rational>(), point) == closest);
}

TEST_CASE(
    "seen from the closest point, no corner of the box is on the point's side", "[P4][case:D7]")
{
  for (const Obb<Rational>& box : {oriented_box<Rational>(), skew_box})
  {
    const std::vector<Exact3> corner = corners(box);
    for (const Exact3& p : lattice(box))
    {
      // Fractions: no tolerance. A point of the box with this property is the closest one.
      const Exact3 c = closest_point(box, p);
      CHECK(least_inset(box, c) >= 0);
      for (const Exact3& x : corner)
      {
        CHECK((p - c).dot(Exact3(x - c)) <= 0);
      }
    }
  }
}
// [P4]

TEMPLATE_TEST_CASE("the closest point is the exact one to rounding", "[P4][case:D7]", float, double)
{
  // Axes, coordinates and the result are rounded once each, at sizes up to 10.
  const Rational bound = Rational(30 * std::numeric_limits<TestType>::epsilon());
  for (const Exact3& p : lattice(oriented_box<Rational>()))
  {
    const Vector3<TestType> rounded = p.cast<TestType>();
    const Exact3 answer = exact<Rational>(closest_point(oriented_box<TestType>(), rounded));
    const Exact3 error = answer - closest_point(oriented_box<Rational>(), p);
    CHECK(error.cwiseAbs().maxCoeff() <= bound);
  }
}

TEMPLATE_TEST_CASE("a point inside is its own closest point, to the bit", "[P4]", float, double)
{
  const Obb<TestType> box = oriented_box<TestType>();
  for (int tenths = 1; tenths <= 9; ++tenths)
  {
    const TestType fraction = TestType(tenths) / TestType(10);
    const Vector3<TestType> inside = box.center + box.axes * box.half_extents * fraction;
    CHECK(closest_point(box, inside) == inside);
  }
}

// [P5]
TEST_CASE("(1.5,-0.25,0) leaves the box (2,1,1) along +x after 0.5, (-1.5,0.25,0) along -x", "[P5]")
{
  const Vector3<double> half(2, 1, 1);
  const Direction<double> right = nearest_face<double>({1.5, -0.25, 0}, half);
  const Direction<double> left = nearest_face<double>({-1.5, 0.25, 0}, half);
  CHECK(right.unit == Vector3<double>(1, 0, 0));
  CHECK(left.unit == Vector3<double>(-1, 0, 0));
  CHECK(right.length == -0.5);
  CHECK(left.length == -0.5);
}

TEST_CASE("inside, the distance is that of the nearest of six planes, exactly", "[P5]")
{
  for (const Obb<Rational>& box : {oriented_box<Rational>(), skew_box})
  {
    for (const Exact3& p : lattice(box))
    {
      if (contains(box, p))
      {
        const Direction<Rational> out = nearest_face(box_coordinates(box, p), box.half_extents);
        const Exact3 surface = p - box.axes * out.unit * out.length;
        CHECK(out.length == -least_inset(box, p));
        CHECK(out.unit.dot(out.unit) == 1);
        CHECK(contains(box, surface));
        CHECK(least_inset(box, surface) == 0);
      }
    }
  }
}

TEST_CASE("at the centre, and where faces tie, the first axis wins, on its positive side", "[P5]")
{
  CHECK(nearest_face<double>({0, 0, 0}, {1, 1, 1}).unit == Vector3<double>(1, 0, 0));
  CHECK(nearest_face<double>({0, 0, 0}, {2, 1, 1}).unit == Vector3<double>(0, 1, 0));
  CHECK(nearest_face<double>({0, -0.5, -0.5}, {2, 1, 1}).unit == Vector3<double>(0, -1, 0));
}
// [P5]

// [P21]
TEST_CASE("a box holds exactly the points that are behind all six of its planes", "[P21]")
{
  for (const Obb<Rational>& box : {oriented_box<Rational>(), skew_box})
  {
    int inside = 0;
    for (const Exact3& p : lattice(box))
    {
      CHECK(contains(box, p) == (least_inset(box, p) >= 0));
      CHECK(contains(box, p) == (closest_point(box, p) == p));
      inside += contains(box, p) ? 1 : 0;
    }
    CHECK(inside > 0);
  }
}

TEST_CASE("a box holds its corners, and nothing a millimetre beyond them", "[P21]")
{
  const Obb<Rational> box = oriented_box<Rational>();
  for (const Exact3& corner : corners(box))
  {
    const Exact3 beyond = box.center + (corner - box.center) * Rational(1001, 1000);
    CHECK(contains(box, corner));
    CHECK_FALSE(contains(box, beyond));
  }
}
// [P21]

// [signed_distance]
TEST_CASE("before a face, an edge and a corner the distance is 3, 5 and 13", "[P4]")
{
  const Vector3<double> half(2, 1, 0.5);
  const Direction<double> face = signed_distance_box<double>({5, 0.5, 0}, half);
  const Direction<double> edge = signed_distance_box<double>({5, -5, 0}, half);
  const Direction<double> corner = signed_distance_box<double>({5, -5, 12.5}, half);
  CHECK(face.length == 3);
  CHECK(face.unit == Vector3<double>(1, 0, 0));
  CHECK(edge.length == Catch::Approx(5).epsilon(rounding));
  CHECK((edge.unit - Vector3<double>(3, -4, 0) / 5).norm() <= rounding);
  CHECK(corner.length == Catch::Approx(13).epsilon(rounding));
  CHECK((corner.unit - Vector3<double>(3, -4, 12) / 13).norm() <= rounding);
}

TEST_CASE(
    "through a face the distance falls as fast as the point, and the normal stays",
    "[case:D3][case:D9]")
{
  const Vector3<double> half(0.5, 0.5, 0.25);
  for (double z = 0.01; z >= -0.01; z -= 1e-4)
  {
    const Direction<double> out = signed_distance_box<double>({0.1, 0.2, 0.25 + z}, half);
    CHECK((out.unit - Vector3<double>(0, 0, 1)).norm() <= rounding);
    CHECK(std::abs(out.length - z) <= rounding);
  }
}

TEST_CASE("1e-300 before a corner there is still a direction", "[case:D4]")
{
  const Direction<double> out = signed_distance_box<double>({1e-300, 1e-300, 1}, {0, 0, 1});
  CHECK(out.length == Catch::Approx(1.4142e-300).epsilon(1e-4));
  CHECK(out.unit.x() == Catch::Approx(std::sqrt(0.5)).epsilon(rounding));
}
// [signed_distance]

// [cases]
TEST_CASE(
    "each way to answer for a point and a box holds or fails as the table says",
    "[case:D1][case:D2][case:D3][case:D4][case:D8]")
{
  check_verdicts(
      point_box_verdicts(), names_of(point_box_methods()),
      {{"D1", {"recommended"}},
       {"D2", {"recommended"}},
       {"D3", {"recommended"}},
       {"D4", {"mixed bounds", "shell", "recommended"}},
       {"D8", {"unguarded", "shell", "recommended"}},
       {"cube, 4 m above", {"mixed bounds", "unguarded", "shell", "recommended"}},
       {"cube, inside its edge", {"recommended"}},
       {"4 mm, 0.2 mm off", {"mixed bounds", "unguarded", "recommended"}}});
}

TEST_CASE("the table tells a wrong direction and a wrong distance from a right answer", "[case:D1]")
{
  const Vector3<double> floor(10, 0.5, 10);
  const PointTruth truth{{9, 0.45, 0}, -0.05};
  CHECK(point_box_verdict({{0, 1, 0}, -0.05}, floor, truth).holds);
  CHECK(point_box_verdict({{1, 0, 0}, -0.05}, floor, truth).what == "wrong direction");
  CHECK(point_box_verdict({{0, -1, 0}, -0.05}, floor, truth).what == "wrong direction");
  CHECK(point_box_verdict({{0, 1, 0}, 0.05}, floor, truth).what == "distance 0.05, not -0.05");
  CHECK(point_box_verdict({{0, 2, 0}, -0.05}, floor, truth).what == "no direction");
  // Right to 1e-12 m, a few roundings of numbers up to 10.
  CHECK(point_box_verdict({{0, 1, 0}, -0.05 + 5e-13}, floor, truth).holds);
  CHECK_FALSE(point_box_verdict({{0, 1, 0}, -0.05 + 2e-12}, floor, truth).holds);
  CHECK_FALSE(point_box_verdict({{0, 1 + 1e-12, 0}, -0.05}, floor, truth).holds);
}
// [cases]

// [X28]
TEST_CASE(
    "4 m above a beam, mixed bounds see contact and the clamp a distance of 4",
    "[case:X28][case:D8]")
{
  const Vector3<double> long_box(10, 1, 1);
  CHECK(distance_mixed_bounds<double>({0, 5, 0}, long_box).length == 0);
  CHECK(signed_distance_box<double>({0, 5, 0}, long_box).length == 4);
  // Beyond the bounds of x, both agree.
  CHECK(clamp_mixed_bounds<double>({11, -11, 11}, long_box) == Vector3<double>(10, -1, 1));
}
// [X28]

// [X06]
TEST_CASE(
    "0.2 mm above a floor the shell turns the normal by 87°, the clamp does not",
    "[case:X05][case:X06]")
{
  const Vector3<double> floor(10, 0.5, 10);
  const Direction<double> shell = distance_shell<double>({9, 0.5002, 0}, floor);
  const Direction<double> ours = signed_distance_box<double>({9, 0.5002, 0}, floor);
  CHECK((ours.unit - Vector3<double>(0, 1, 0)).norm() <= rounding);
  // The angle from +y to (9, 0.5002, 0) is atan(9 / 0.5002) = 86.8°.
  CHECK(std::acos(shell.unit.y()) * 180 / 3.14159265 == Catch::Approx(86.8).epsilon(1e-3));
}

TEST_CASE(
    "at the centre of a floor the shell has no direction, the clamp has +y and -0.5", "[case:X07]")
{
  const Vector3<double> floor(10, 0.5, 10);
  CHECK(distance_shell<double>({0, 0, 0}, floor).unit.hasNaN());
  CHECK(signed_distance_box<double>({0, 0, 0}, floor).unit == Vector3<double>(0, 1, 0));
  CHECK(signed_distance_box<double>({0, 0, 0}, floor).length == -0.5);
}
// [X06]

// [room]
TEST_CASE("7.5 m from a box, axes rounded to float cost less than 10 µm", "[room]")
{
  CHECK(axes_error<float>(0.5) <= 1e-5);
}
// [room]

// [planet]
TEST_CASE(
    "1500 km from a box, axes rounded to float cost 1 cm, in double less than 10 µm", "[planet]")
{
  CHECK(axes_error<float>(1e5) >= 1e-2);
  CHECK(axes_error<double>(1e5) <= 1e-5);
}
// [planet]
