/// \file
/// Pairs of convex shapes by GJK and EPA alone, against the closed forms of spheres, boxes and
/// planes that are wrapped as if nothing was known of them but their six functions.

#include "02_primitives/closest_points/closest_points.hpp"
#include "06_world/contacts/near_shapes.hpp"
#include "06_world/cylinder/cylinder.hpp"
#include "06_world/shapes/gap_between.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/random_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace cookbook;

namespace
{

using V = Vector3<double>;

Pose pose(Random& draw, double reach)
{
  const Quaternion<double> turn(
      draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1));
  return {draw.in_cube(reach), turn.normalized().toRotationMatrix()};
}

BoxShape box(Random& draw)
{
  return {draw.in_box(0.2, 1)};
}

/// How far the projections of two shapes are apart along a direction.
double separation(
    const ConvexShape& a, const Pose& at_a, const ConvexShape& b, const Pose& at_b, const V& unit)
{
  const V on_a = support_arm(placed(at_a, a), unit), on_b = support_arm(placed(at_b, b), -unit);
  return unit.dot(at_b.center + on_b - at_a.center - on_a);
}

} // namespace

TEST_CASE(
    "the gap of 10,000 pairs of boxes by support points is that of the fifteen axes where they "
    "overlap, and that of their closest points where they do not")
{
  Random draw(1);
  int overlapping = 0;
  for (int i = 0; i < inputs(10'000, 300); ++i)
  {
    const BoxShape a = box(draw), b = box(draw);
    const Pose at_a = pose(draw, 1), at_b = pose(draw, 1);
    const Direction<double> found = gap_between(ConvexShape(a), at_a, ConvexShape(b), at_b);
    const Direction<double> axes = gap_between(a, at_a, b, at_b);
    const Direction<double> half = gap_between(a, at_a, ConvexShape(b), at_b);
    REQUIRE(std::abs(found.unit.norm() - 1) < 1e-12);
    REQUIRE(std::abs(half.length - found.length) < 1e-7);
    if (axes.length <= 0)
    {
      ++overlapping;
      REQUIRE(std::abs(found.length - axes.length) < 1e-7);
    }
    else
    {
      const double distance = closest_points(placed(at_a, a), placed(at_b, b)).distance;
      REQUIRE(std::abs(found.length - distance) < 1e-7);
      REQUIRE(found.length >= axes.length - 1e-7);
    }
    REQUIRE(std::abs(separation(a, at_a, b, at_b, found.unit) - found.length) < 1e-12);
  }
  CHECK(overlapping > inputs(3'000, 90));
}

TEST_CASE("spheres that are known by six functions have the gaps of spheres, to 1e-9 where they "
          "overlap by a tenth or less")
{
  Random draw(2);
  for (int i = 0; i < inputs(10'000, 300); ++i)
  {
    const SphereShape a{draw.between(0.2, 1)}, b{draw.between(0.2, 1)};
    const BoxShape other = box(draw);
    const Pose at_a = pose(draw, 1), at_b = pose(draw, 1);
    const PlaneShape plane{draw.direction(), draw.between(-1, 1)};
    const auto same = [&](const Shape& shape, const Pose& at)
    {
      const Direction<double> known = gap_between(a, at_a, shape, at);
      const Direction<double> found = gap_between(ConvexShape(a), at_a, shape, at);
      const Direction<double> swapped = gap_between(shape, at, ConvexShape(a), at_a);
      const bool shallow = known.length > -0.1;
      REQUIRE(std::abs(found.length - known.length) < (shallow ? 1e-9 : 1e-4));
      REQUIRE(std::abs(swapped.length - known.length) < (shallow ? 1e-9 : 1e-4));
      REQUIRE((!shallow || (found.unit - known.unit).norm() < 1e-3));
    };
    same(b, at_b);
    same(ConvexShape(b), at_b);
    same(plane, at_b);
    if (gap_between(a, at_a, other, at_b).length > -a.radius) // its centre is outside
    {
      same(other, at_b);
    }
  }
}

TEST_CASE("no direction separates 2,000 pairs of cylinders by more than their gap says")
{
  Random draw(3);
  for (int i = 0; i < inputs(2'000, 100); ++i)
  {
    const ConvexShape a = Cylinder{draw.between(0.2, 0.6), draw.between(0.2, 0.6)};
    const ConvexShape b = Cylinder{draw.between(0.2, 0.6), draw.between(0.2, 0.6)};
    const Pose at_a = pose(draw, 0.7), at_b = pose(draw, 0.7);
    const Direction<double> found = gap_between(a, at_a, b, at_b);
    REQUIRE(std::abs(separation(a, at_a, b, at_b, found.unit) - found.length) < 1e-12);
    for (int k = 0; k < 300; ++k)
    {
      const double size = std::ldexp(1, -draw.whole(0, 30)); // near it, and everywhere
      const V unit = (found.unit + size * draw.direction()).normalized();
      REQUIRE(separation(a, at_a, b, at_b, unit) < found.length + (found.length > 0 ? 2e-8 : 1e-5));
    }
  }
}

TEST_CASE("shapes with one centre, and flush faces, have a finite gap and manifold")
{
  const ConvexShape drum = Cylinder{0.5, 0.5};
  const Pose here{V::Zero(), Matrix3<double>::Identity()};
  const Direction<double> gap = gap_between(drum, here, drum, here);
  CHECK(std::abs(gap.length + 1) < 1e-9);
  const Pose above{{0, 1, 0}, Matrix3<double>::Identity()};
  const auto flush = manifold_within(placed(here, drum), placed(above, drum), 0.01);
  REQUIRE(flush);
  CHECK((flush->normal - V::UnitY()).norm() < 1e-15);
  CHECK(std::abs(flush->depth) < 1e-9);
  CHECK(flush->points.size() == 8);
}

TEST_CASE("a drum on a box or a plane touches at eight points of its rim, a log at its two ends")
{
  Random draw(4);
  const Cylinder cylinder{0.4, 0.7};
  const ConvexShape shape = cylinder;
  for (int i = 0; i < inputs(1'000, 50); ++i)
  {
    const double sunk = draw.between(-4e-3, 4e-3), turn = draw.between(0, 7);
    const Matrix3<double> frame = pose(draw, 1).axes;
    const V up = frame.col(1), place = draw.in_cube(3);
    const Eigen::AngleAxis<double> spin(turn, V::UnitY());
    const Matrix3<double> standing = frame * spin.toRotationMatrix();
    const Eigen::AngleAxis<double> quarter(std::numbers::pi / 2, V::UnitX());
    const Matrix3<double> lying = frame * quarter.toRotationMatrix() * spin.toRotationMatrix();
    const Obb<double> floor{place - up, frame, {3, 1, 3}};
    const Plane<double> plane{up, up.dot(place)};
    const auto holds = [&](const auto& below, const Matrix3<double>& axes, double height)
    {
      const Pose at{place + (height - sunk) * up, axes};
      const auto manifold = manifold_within(below, placed(at, shape), 5e-3);
      REQUIRE(manifold);
      REQUIRE((manifold->normal - up).norm() < 1e-12);
      REQUIRE(manifold->points.size() == (height == 0.7 ? 8 : 2));
      V middle = V::Zero();
      for (const ContactPoint<double>& point : manifold->points)
      {
        REQUIRE(std::abs(point.depth - sunk) < 1e-6);
        const V arm = at.axes.transpose() * (point.position - sunk / 2 * up - at.center);
        REQUIRE(std::abs(distance(cylinder, arm).length) < 1e-5);
        REQUIRE(std::abs(arm.norm() - std::hypot(0.4, 0.7)) < 1e-5);
        middle += (point.position - place) / double(manifold->points.size());
      }
      REQUIRE((middle - up.dot(middle) * up).norm() < 1e-5);
    };
    holds(floor, standing, 0.7);
    holds(plane, standing, 0.7);
    holds(floor, lying, 0.4);
    holds(plane, lying, 0.4);
  }
}

TEST_CASE("a log across a log touches at one point, and at two ends of what they share beside it")
{
  const ConvexShape log = Cylinder{0.3, 1};
  const auto turned = [](double angle, const V& about)
  { return Eigen::AngleAxis<double>(angle, about).toRotationMatrix(); };
  const Matrix3<double> along = turned(std::numbers::pi / 2, V::UnitX()); // along z
  const Pose below{{0, 0, 0}, along};
  const Pose across{{0.2, 0.599, 0.1}, turned(std::numbers::pi / 2, V::UnitY()) * along};
  const auto crossed = manifold_within(placed(below, log), placed(across, log), 0);
  REQUIRE(crossed);
  CHECK(crossed->points.size() == 1);
  CHECK((crossed->normal - V::UnitY()).norm() < 1e-6);
  CHECK(std::abs(crossed->depth - 1e-3) < 1e-7);
  CHECK((crossed->points[0].position - V(0, 0.2995, 0.1)).norm() < 1e-6);
  const Pose beside{{0, 0.599, 0.5}, along};
  const auto shared = manifold_within(placed(below, log), placed(beside, log), 0);
  REQUIRE(shared);
  REQUIRE(shared->points.size() == 2);
  const double z_0 = shared->points[0].position.z(), z_1 = shared->points[1].position.z();
  CHECK(std::abs(std::min(z_0, z_1) + 0.5) < 1e-4);
  CHECK(std::abs(std::max(z_0, z_1) - 1) < 1e-4);
}

TEST_CASE("moving B by the depth along the normal ends the overlap, in either order of the shapes")
{
  Random draw(5);
  int overlapping = 0;
  for (int i = 0; i < inputs(2'000, 100); ++i)
  {
    const ConvexShape a = Cylinder{draw.between(0.2, 0.6), draw.between(0.2, 0.6)};
    const Pose at_a = pose(draw, 0.5), at_b = pose(draw, 0.5);
    const BoxShape b = box(draw);
    const auto found = manifold_within(placed(at_a, a), placed(at_b, b), 0);
    const auto other = manifold_within(placed(at_b, b), placed(at_a, a), 0);
    REQUIRE(found.has_value() == other.has_value());
    if (found)
    {
      ++overlapping;
      REQUIRE(std::abs(found->depth - other->depth) < 1e-8);
      REQUIRE((!found->points.empty() && found->depth >= 0));
      const Pose moved{at_b.center + found->depth * found->normal, at_b.axes};
      REQUIRE(std::abs(gap_between(a, at_a, b, moved).length) < 1e-6);
    }
  }
  CHECK(overlapping > inputs(500, 20));
}
