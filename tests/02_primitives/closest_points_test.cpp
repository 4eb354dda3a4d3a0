/// \file
/// What holds for the closest points of any two shapes, judged by what lies in the shapes and on
/// which side of a plane they lie.

#include "02_primitives/closest_points/closest_points.hpp"

#include "tests/02_primitives/shape_pairs.hpp"
#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

using namespace cookbook;

// [all_pairs]
TEST_CASE("45 pairs of shapes: closest points are in them, and no others are closer", "[P1][P2]")
{
  const std::vector<Kinds<double>> all = all_kinds<double>();
  CHECK(all.size() == 45);
  for (const Kinds<double>& kinds : all)
  {
    for (const Draws draws : all_draws)
    {
      const Wrongs wrongs = check_pairs(kinds, draws, inputs(14'285, 70));
      INFO(kinds.names << ", draws " << int(draws) << ", overlapping " << wrongs.overlapping);
      CHECK(wrongs.fault < 4e-12L);
      CHECK(wrongs.contradictions == 0);
      CHECK(wrongs.moved_wrongly == 0);
      CHECK(wrongs.touch < (draws == Draws::thin ? 1e-8L : 4e-12L));
    }
  }
}
// [all_pairs]

TEST_CASE(
    "the order of the shapes does not matter but for the order of the points", "[closest_points]")
{
  const Plane<double> floor{{0, 1, 0}, 0};
  const Capsule<double> capsule{{{0, 3, 0}, {4, 3, 0}}, 1};
  const ClosestPoints<double, 3> one = closest_points(floor, capsule);
  CHECK(one.distance == 2);
  CHECK(one.a == Eigen::Vector3d(0, 0, 0));
  CHECK(one.b == Eigen::Vector3d(0, 2, 0));
  const ClosestPoints<double, 3> other = closest_points(capsule, floor);
  CHECK(other.a == one.b);
  CHECK(other.b == one.a);
}

TEST_CASE("half-spaces are apart only if they look at each other across a gap", "[closest_points]")
{
  const Plane<double> floor{{0, 1, 0}, 0}, ceiling{{0, -1, 0}, -3}, wall{{1, 0, 0}, -2};
  const ClosestPoints<double, 3> between = closest_points(floor, ceiling);
  CHECK(between.distance == 3);
  CHECK(between.a == Eigen::Vector3d(0, 0, 0));
  CHECK(between.b == Eigen::Vector3d(0, 3, 0));
  CHECK(closest_points(floor, Plane<double>{{0, -1, 0}, 0}).distance == 0);
  const ClosestPoints<double, 3> both = closest_points(floor, wall);
  CHECK(both.distance == 0);
  CHECK(both.a == Eigen::Vector3d(-2, 0, 0));
  CHECK(closest_points(floor, floor).distance == 0);
}

TEST_CASE("shapes of 1e-300 and 1e300 m are answered as those of 1 m", "[closest_points]")
{
  for (const int power : {-1000, -300, 0, 300, 1000})
  {
    const double m = std::ldexp(1.0, power);
    const Tetrahedron<double> solid{{m, m, m}, {5 * m, m, m}, {m, 5 * m, m}, {m, m, 5 * m}};
    const Aabb<double> box(Eigen::Vector3d(-4 * m, -4 * m, -4 * m), Eigen::Vector3d(m, m, -m));
    CHECK(closest_points(box, solid).distance == Catch::Approx(2 * m).epsilon(1e-14).margin(0));
    const Sphere<double> ball{{-2 * m, 2 * m, 2 * m}, 2 * m};
    CHECK(closest_points(ball, solid).distance == Catch::Approx(m).epsilon(1e-14).margin(0));
    const Segment<double> rod{{0, 0, 8 * m}, {8 * m, 0, 8 * m}};
    const Segment<double> pole{{2 * m, -3 * m, 5 * m}, {2 * m, 3 * m, 5 * m}};
    CHECK(closest_points(rod, pole).distance == Catch::Approx(3 * m).epsilon(1e-14).margin(0));
    const Plane<double> floor{{0, 1, 0}, -m};
    CHECK(closest_points(floor, solid).distance == Catch::Approx(2 * m).epsilon(1e-14).margin(0));
  }
}

TEST_CASE("what is not a number ends, too", "[closest_points]")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Tetrahedron<double> solid{{nan, 1, 1}, {5, 1, 1}, {1, 5, 1}, {1, 1, 5}};
  const Obb<double> box{{0, 0, nan}, Matrix3<double>::Identity(), {1, 1, 1}};
  CHECK_NOTHROW(closest_points(box, solid));
}

TEST_CASE("a triangle of -1e300 m is answered as one of -1 m, in either order", "[closest_points]")
{
  const Eigen::Vector3d origin(0, 0, 0);
  for (const int power : {-1000, 0, 1000})
  {
    const double m = std::ldexp(-1.0, power); // the closest point is the middle, (m, m, m)
    const Triangle<double> triangle{{3 * m, 0, 0}, {0, 3 * m, 0}, {0, 0, 3 * m}};
    const ClosestPoints<double, 3> found = closest_points(origin, triangle);
    CHECK(found.distance == Catch::Approx(-m * std::sqrt(3.0)).epsilon(1e-14).margin(0));
    CHECK((found.b / m - Eigen::Vector3d(1, 1, 1)).norm() < 1e-14);
    CHECK((closest_points(triangle, origin).a / m - Eigen::Vector3d(1, 1, 1)).norm() < 1e-14);
  }
}
