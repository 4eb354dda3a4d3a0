/// \file
/// What holds for the reach of shapes and for three planes: formulas P6, P7 and P15.

#include "02_primitives/shape_bounds/shape_bounds.hpp"
#include "02_primitives/three_planes/three_planes.hpp"
#include "common/math/rotation.hpp"
#include "tools/exact/exact.hpp"

#include "tests/02_primitives/shape_oracle.hpp"
#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

using namespace cookbook;

// [P6]
TEST_CASE("a box reaches along n as far as the farthest of its 8 corners", "[P6]")
{
  ShapeDraw<double> from(1);
  from.use(Draws::any);
  for (int i = 0; i < random_inputs; ++i)
  {
    const Obb<double> box = drawn<Obb<double>>(from);
    const Eigen::Vector3d n = from.turn().col(0);
    const Long least = extent_against(as_oracle(box), exactly(Eigen::Vector3d(-n)));
    REQUIRE(std::abs(n.dot(box.center) + box_radius(box, n) + double(least)) < 1e-14);
    REQUIRE(std::abs(n.dot(support_point(box, n)) + double(least)) < 1e-14);
  }
}
// [P6]

// [P7]
TEST_CASE("a box turned by exact fractions: its bounds are the least and most of 8 corners", "[P7]")
{
  const Obb<Rational> box{
      {1, 2, 3}, rational_rotation<Rational>(1, 2, 3, 4), {2, 1, Rational(1, 2)}};
  const Aabb<Rational> bounds = bounds_of(box);
  for (int axis = 0; axis < 3; ++axis)
  {
    Rational most = box.center[axis];
    for (int i = 0; i < 8; ++i)
    {
      Rational x = box.center[axis];
      for (int k = 0; k < 3; ++k)
      {
        x += box.axes(axis, k) * box.half_extents[k] * (i >> k & 1 ? 1 : -1);
      }
      most = x > most ? x : most;
    }
    CHECK(bounds.max()[axis] == most);
  }
}
// [P7]

// [P15]
TEST_CASE("the point of three planes lies on each of them", "[P15]")
{
  ShapeDraw<double> from(3);
  from.use(Draws::any);
  int found = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const Plane<double> planes[] = {
        drawn<Plane<double>>(from), drawn<Plane<double>>(from), drawn<Plane<double>>(from)};
    const std::optional<Eigen::Vector3d> p = point_of_planes(planes[0], planes[1], planes[2]);
    for (const Plane<double>& plane : planes)
    {
      const double size = p ? std::max(1.0, p->norm()) : 0;
      REQUIRE((!p || std::abs(plane.normal.dot(*p) - plane.distance) < 1e-10 * size * size));
    }
    found += p.has_value();
  }
  CHECK(found > random_inputs * 0.99);
}
// [P15]

TEST_CASE("planes with a common line, or two parallel ones, have no one point", "[P15]")
{
  const Plane<double> x{{1, 0, 0}, 1}, y{{0, 1, 0}, 2}, z{{0, 0, 1}, 3}, across{{0.6, 0.8, 0}, 1};
  CHECK(*point_of_planes(x, y, z) == Eigen::Vector3d(1, 2, 3));
  CHECK_FALSE(point_of_planes(x, y, across));
  CHECK_FALSE(point_of_planes(x, Plane<double>{{-1, 0, 0}, 5}, z));
}

TEST_CASE("bounds, sphere and farthest point of a capsule, and what shapes hold", "[shape_bounds]")
{
  const Capsule<double> capsule{{{0, 0, 0}, {4, 0, 0}}, 1};
  CHECK(bounds_of(capsule).min() == Eigen::Vector3d(-1, -1, -1));
  CHECK(bounds_of(capsule).max() == Eigen::Vector3d(5, 1, 1));
  CHECK(bounding_sphere(capsule).center == Eigen::Vector3d(2, 0, 0));
  CHECK(bounding_sphere(capsule).radius == 3);
  CHECK(support_point(capsule, Eigen::Vector3d(7, 0, 0)) == Eigen::Vector3d(5, 0, 0));
  CHECK(contains(capsule, Eigen::Vector3d(5, 0, 0)));
  CHECK_FALSE(contains(capsule, Eigen::Vector3d(5, 0.1, 0)));
  CHECK(contains(Sphere<double>{{0, 0, 0}, 5}, Eigen::Vector3d(3, 4, 0)));
  CHECK(contains(Plane<double>{{0, 1, 0}, 1}, Eigen::Vector3d(3, 1, 0)));
  CHECK(contains(
      Aabb<double>(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1)), Eigen::Vector3d(1, 1, 1)));
  const Tetrahedron<double> solid{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  CHECK(contains(solid, Eigen::Vector3d(1, 1, 1)));
  CHECK_FALSE(contains(solid, Eigen::Vector3d(2, 2, 1)));
}

TEST_CASE("the smallest sphere: around a cube, a flat and a regular solid, a line", "[P22]")
{
  using V = Eigen::Vector3d;
  const auto around = [](std::vector<V> points) { return minimal_sphere<double>(points); };
  const Sphere<double> of_one = around({{1, 2, 3}, {1, 2, 3}});
  CHECK(of_one.center == V(1, 2, 3));
  CHECK(of_one.radius == 0);
  const Sphere<double> of_line = around({{0, 0, 0}, {1, 0, 0}, {6, 0, 0}, {5, 0, 0}});
  CHECK(of_line.center == V(3, 0, 0));
  CHECK(of_line.radius == Catch::Approx(3).epsilon(1e-14));
  const Sphere<double> of_flat = around({{3, 0, 1}, {-3, 0, 1}, {0, 3, 1}, {0, -1, 1}, {1, 1, 1}});
  CHECK((of_flat.center - V(0, 0, 1)).norm() < 1e-15);
  CHECK(of_flat.radius == Catch::Approx(3).epsilon(1e-14));
  const Sphere<double> of_regular = around({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
  CHECK(of_regular.center.norm() < 1e-15);
  CHECK(of_regular.radius == Catch::Approx(std::sqrt(3)).epsilon(1e-14));
  const Sphere<double> of_box = bounding_sphere(Aabb<double>(V(-1, -2, -3), V(3, 4, 6)));
  CHECK(of_box.center == V(1, 1, 1.5));
  CHECK(of_box.radius == Catch::Approx(std::sqrt(4 + 9 + 20.25)).epsilon(1e-14));
  // A right angle's longest side is the diameter; the box around these corners is centred
  // elsewhere.
  const Sphere<double> of_triangle =
      bounding_sphere(Triangle<double>{{0, 0, 0}, {8, 0, 0}, {1.6, 3.2, 0}});
  CHECK((of_triangle.center - V(4, 0, 0)).norm() < 1e-14);
  CHECK(of_triangle.radius == Catch::Approx(4).epsilon(1e-14));
}

TEMPLATE_TEST_CASE(
    "the smallest sphere holds all points and rests on some around it", "[P22]", float, double)
{
  using V = Vector3<TestType>;
  const bool is_float = std::is_same_v<TestType, float>;
  ShapeDraw<TestType> from(5);
  double excess = 0;
  for (int i = 0; i < random_inputs / 10; ++i)
  {
    from.use(i % 3 == 0 ? Draws::lattice : i % 3 == 1 ? Draws::any : Draws::distant);
    std::vector<V> points;
    for (int k = 0; k < 2 + i % 9; ++k)
    {
      points.push_back(drawn<V>(from));
    }
    const Sphere<TestType> sphere = minimal_sphere<TestType>(points);
    std::vector<Vector3<double>> on;
    for (const V& point : points)
    {
      const Vector3<double> arm =
          point.template cast<double>() - sphere.center.template cast<double>();
      const double u = double(std::numeric_limits<TestType>::epsilon());
      const double rounding = 4 * u * double(sphere.center.norm() + sphere.radius);
      REQUIRE(arm.norm() <= double(sphere.radius) + (is_float ? 0 : rounding));
      if (arm.norm() >= double(sphere.radius) - 8 * rounding)
      {
        on.push_back(arm);
      }
    }
    // No smaller one does: in every direction some point that it rests on lies ahead of the centre.
    for (int k = 0; k < 20; ++k)
    {
      const Vector3<double> n = ShapeDraw<double>(unsigned(20 * i + k)).turn().col(0);
      double ahead = -1;
      for (const Vector3<double>& arm : on)
      {
        ahead = std::max(ahead, n.dot(arm) / double(sphere.radius));
      }
      excess = std::max(excess, sphere.radius > 0 ? -ahead : 0);
    }
  }
  CHECK(excess < 1e-2);
}

TEST_CASE("planes whose normals have lengths 1, 1 and 1e-20 meet at (1, 2, 3)", "[P15]")
{
  const Plane<double> x{{1, 0, 0}, 1}, y{{0, 1, 0}, 2}, z{{0, 0, 1e-20}, 3e-20};
  const auto p = point_of_planes(x, y, z);
  REQUIRE(p);
  CHECK((*p - Eigen::Vector3d(1, 2, 3)).norm() < 1e-14);
}
