/// \file
/// What holds for the first touch of a moving sphere: formula P20 without spin.

#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "05_resolution/tunnelling/swept_sphere.hpp"
#include "common/math/rotation.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

namespace
{

/// A sweep of lengths below ten is rounded at 16 · 2.2e-16 of their sum, and so is its time.
constexpr double rounding = 2e-13;

const Obb<double> cube{{0, 0, 0}, Matrix3<double>::Identity(), {1, 1, 1}};

Sphere<double> ball_at(double x, double y, double z, double radius = 0.5)
{
  return {{x, y, z}, radius};
}

/// The gap [m] between a sphere and a box.
double gap(const Sphere<double>& sphere, const Obb<double>& box)
{
  const Vector3<double> local = box_coordinates(box, sphere.center);
  return signed_distance_box(local, box.half_extents).length - sphere.radius;
}

Sphere<double> later(const Sphere<double>& sphere, const Vector3<double>& displacement, double time)
{
  return {sphere.center + time * displacement, sphere.radius};
}

/// A box, a sphere, and a way that leads it somewhere near the box; the same ones every time.
struct RandomSweep
{
  Obb<double> box;
  Sphere<double> sphere;
  Vector3<double> displacement;
};

class RandomSweeps
{
public:
  RandomSweep next()
  {
    const Matrix3<double> axes =
        rational_rotation<double>(1 + whole(), whole(), whole(), whole() - 2);
    const Obb<double> box{vector(1), axes, vector(0.5) + Vector3<double>::Constant(0.6)};
    const Sphere<double> sphere{vector(4), 0.01 + draw_.between(0, 0.5)};
    return {box, sphere, 2 * (vector(1.5) - sphere.center)};
  }

private:
  int whole() { return draw_.whole(5); }
  Vector3<double> vector(double size) { return draw_.vector(-size, size); }
  BoxDraw draw_{1};
};

} // namespace

// [P20]
TEST_CASE("a ball of 0.5 m touches a face, an edge and a corner when Pythagoras says", "[P20]")
{
  const Vector3<double> right(6, 0, 0);
  // A face: from x = −3 to −1.5.
  const auto face = swept_sphere_box(ball_at(-3, 0, 0), right, cube);
  REQUIRE(face);
  CHECK(face->time == Catch::Approx(1.5 / 6).epsilon(rounding));
  CHECK(face->normal == Vector3<double>(1, 0, 0));
  // An edge, 0.3 m above it: 0.5² = 0.4² + 0.3², from x = −3 to −1.4.
  const auto edge = swept_sphere_box(ball_at(-3, 1.3, 0), right, cube);
  REQUIRE(edge);
  CHECK(edge->time == Catch::Approx(1.6 / 6).epsilon(rounding));
  CHECK((edge->normal - Vector3<double>(0.8, -0.6, 0)).norm() <= rounding);
  // A corner, 0.3 above and 0.6 behind it: 0.7² = 0.2² + 0.3² + 0.6².
  const auto corner = swept_sphere_box(ball_at(-3, 1.3, 1.6, 0.7), right, cube);
  REQUIRE(corner);
  CHECK(corner->time == Catch::Approx(1.8 / 6).epsilon(rounding));
  CHECK((corner->normal - Vector3<double>(2, -3, -6) / 7).norm() <= rounding);
}

TEST_CASE("two balls 4 m off centre, 5 m of radii: they touch 3 m ahead; a plane at once", "[P20]")
{
  const auto sphere =
      swept_sphere_sphere<double>(ball_at(-13, 4, 0, 2), {20, 0, 0}, Sphere<double>{{0, 0, 0}, 3});
  REQUIRE(sphere);
  CHECK(sphere->time == Catch::Approx(10 / 20.0).epsilon(rounding));
  CHECK((sphere->normal - Vector3<double>(0.6, -0.8, 0)).norm() <= rounding);
  const auto plane =
      swept_sphere_plane<double>(ball_at(7, 3, 0), {5, -10, 2}, Plane<double>{{0, 1, 0}, 0.5});
  REQUIRE(plane);
  CHECK(plane->time == Catch::Approx(2 / 10.0).epsilon(rounding));
  CHECK(plane->normal == Vector3<double>(0, -1, 0));
}

TEST_CASE("of 3,000 sweeps none overlaps before its first touch, and none at all without", "[P20]")
{
  RandomSweeps random;
  int hits = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const auto [box, sphere, displacement] = random.next();
    const auto hit = swept_sphere_box(sphere, displacement, box);
    if (gap(sphere, box) <= rounding)
    {
      REQUIRE((!hit || hit->time == 0));
      continue;
    }
    const double free = hit ? hit->time : 1;
    for (int part = 0; part <= 100; ++part)
    {
      REQUIRE(gap(later(sphere, displacement, free * part / 100), box) >= -rounding);
    }
    if (hit)
    {
      ++hits;
      REQUIRE(std::abs(gap(later(sphere, displacement, hit->time), box)) <= rounding);
      REQUIRE(hit->normal.norm() == Catch::Approx(1).epsilon(1e-14));
      REQUIRE(displacement.dot(hit->normal) > 0);
    }
  }
  CHECK(hits > 1000);
  CHECK(hits < 2500);
}
// [P20]

// [few_advances]
TEST_CASE("a face takes 2 looks, 3,000 sweeps at most 32, and 4 on average", "[P20]")
{
  const auto looks = [](const RandomSweep& sweep)
  {
    int count = 0;
    first_touch<double>(
        sweep.displacement, rounding,
        [&](const Vector3<double>& offset)
        {
          ++count;
          const Vector3<double> local =
              box_coordinates<double>(sweep.box, sweep.sphere.center + offset);
          const Direction<double> out = signed_distance_box(local, sweep.box.half_extents);
          return Direction<double>{-(sweep.box.axes * out.unit), out.length - sweep.sphere.radius};
        });
    return count;
  };
  CHECK(looks({cube, ball_at(-3, 0, 0), {6, 0, 0}}) == 2);
  RandomSweeps random;
  int most = 0, sum = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const int count = looks(random.next());
    most = std::max(most, count);
    sum += count;
  }
  INFO(most << " " << sum / 3000.0);
  CHECK(most <= 32);
  CHECK(sum <= 4 * 3000);
}

TEST_CASE("after 64 looks an advance stops short of the wall, never behind it", "[P20]")
{
  // A gap that is understated tenfold leaves 0.9 of the way each time: 0.9⁶⁴ is 0.0012.
  const auto understated = [](const Vector3<double>& offset) {
    return Direction<double>{{1, 0, 0}, (1 - offset.x()) / 10};
  };
  const auto hit = first_touch<double>({2, 0, 0}, rounding, understated);
  REQUIRE(hit);
  CHECK(hit->time == Catch::Approx(0.5 * (1 - std::pow(0.9, 64))));
  CHECK(hit->time < 0.5);
}
// [few_advances]

TEST_CASE("a ball that arrives with the end of its way touches, one 1 nm short does not")
{
  const auto hit = swept_sphere_box<double>(ball_at(-3, 0, 0), {1.5, 0, 0}, cube);
  REQUIRE(hit);
  CHECK(hit->time == 1);
  CHECK(!swept_sphere_box<double>(ball_at(-3, 0, 0), {1.5 - 1e-9, 0, 0}, cube));
}

TEST_CASE("a ball 1 nm beside the edge flies by, 1 nm inside it touches")
{
  const Vector3<double> down(0, -1000, 0);
  CHECK(!swept_sphere_box<double>(ball_at(1.5 + 1e-9, 500, 0), down, cube));
  CHECK(swept_sphere_box<double>(ball_at(1.5 - 1e-9, 500, 0), down, cube));
}

TEST_CASE("a ball that overlaps at the start may leave and not go in")
{
  const Sphere<double> inside = ball_at(1.25, 0, 0), within = ball_at(0.5, 0, 0);
  for (const Sphere<double>& sphere : {inside, within})
  {
    CHECK(!swept_sphere_box<double>(sphere, {1, 0, 0}, cube));
    const auto in = swept_sphere_box<double>(sphere, {-1, 0.5, 0}, cube);
    REQUIRE(in);
    CHECK(in->time == 0);
    CHECK(in->normal == Vector3<double>(-1, 0, 0));
  }
}

TEST_CASE("a ball that stands still, slides along or has just bounced touches nothing")
{
  const Sphere<double> tolerance = ball_at(1.5, 0, 0);
  CHECK(!swept_sphere_box<double>(tolerance, {0, 0, 0}, cube));
  CHECK(!swept_sphere_box<double>(tolerance, {0, 3, 1}, cube));
  CHECK(!swept_sphere_box<double>(tolerance, {1e-9, 3, 1}, cube));
  CHECK(swept_sphere_box<double>(tolerance, {-1e-9, 3, 1}, cube)->time == 0);
  CHECK(!swept_sphere_box<double>(ball_at(0, 0, 0), {0, 0, 0}, cube));
}

TEST_CASE("from a thousand kilometres a ball hits a 2 cm wall to 1e-8 m")
{
  const Obb<double> wall{{0, 0, 0}, Matrix3<double>::Identity(), {0.01, 1, 1}};
  const auto hit = swept_sphere_box<double>(ball_at(-1e6, 0, 0, 0.05), {2e6, 0, 0}, wall);
  REQUIRE(hit);
  CHECK(std::abs(hit->time * 2e6 - (1e6 - 0.06)) <= 1e-8);
  CHECK(!swept_sphere_box<double>(ball_at(-1e6, 0, 0, 0.05), {0.9e6, 0, 0}, wall));
  const Vector3<double> distant(1e6, -1e6, 1e6);
  const auto there = swept_sphere_box<double>(
      {distant + Vector3<double>(-3, 0, 0), 0.5}, {6, 0, 0},
      {distant, cube.axes, cube.half_extents});
  CHECK(there->time == Catch::Approx(0.25).epsilon(rounding));
}

TEST_CASE("numbers that are none touch nothing, and the answer is the same in float")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(!swept_sphere_box<double>(ball_at(nan, 0, 0), {6, 0, 0}, cube));
  CHECK(!swept_sphere_box<double>(ball_at(-3, 0, 0), {6, nan, 0}, cube));
  CHECK(!swept_sphere_plane<double>(ball_at(nan, 3, 0), {0, -9, 0}, {{0, 1, 0}, 0}));
  CHECK(!swept_sphere_sphere<double>(ball_at(0, 3, 0), {0, nan, 0}, {{0, 0, 0}, 1}));
  const Obb<float> box{{0, 0, 0}, Matrix3<float>::Identity(), {1, 1, 1}};
  const auto hit = swept_sphere_box<float>({{-3, 0, 0}, 0.5f}, {6, 0, 0}, box);
  CHECK(hit->time == 0.25f);
  CHECK(hit->normal == Vector3<float>(1, 0, 0));
}
