/// \file
/// The plain manifolds agree with the hardened ones in a room, and fail where those hold.

#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"
#include "03_sphere_manifolds/sphere_box/sphere_box.hpp"
#include "03_sphere_manifolds/sphere_capsule/sphere_capsule.hpp"
#include "03_sphere_manifolds/sphere_plane/sphere_plane.hpp"
#include "common/math/rotation.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/random_numbers.hpp"

using namespace cookbook;

namespace
{

/// How far the answers of two functions are apart, in units of the pairs' sizes.
struct Agreement
{
  int touching = 0;
  int other_verdicts = 0; ///< where the depth is more than 1e-12 of the size
  double depth = 0;
  double normal = 0; ///< where the sphere's centre is not within 1e-3 of the other shape's core
  double point = 0;  ///< likewise

  void compare(
      const std::optional<Manifold<double>>& plain, const std::optional<Manifold<double>>& hardened,
      double size, double radii)
  {
    if (plain.has_value() != hardened.has_value())
    {
      other_verdicts += (plain ? plain : hardened)->depth > 1e-12 * size ? 1 : 0;
      return;
    }
    if (!plain)
    {
      return;
    }
    ++touching;
    depth = std::max(depth, std::abs(plain->depth - hardened->depth) / size);
    if (std::abs(radii - hardened->depth) > 1e-3 * size)
    {
      normal = std::max(normal, (plain->normal - hardened->normal).norm());
      const Vector3<double> off = plain->points[0].position - hardened->points[0].position;
      point = std::max(point, off.norm() / size);
    }
  }

  void check() const
  {
    CHECK(other_verdicts == 0);
    CHECK(depth <= 1e-12);
    CHECK(normal <= 1e-12);
    CHECK(point <= 1e-12);
    CHECK(touching > random_inputs / 10);
    CHECK(touching < random_inputs * 9 / 10);
  }
};

} // namespace

// [agree]
TEST_CASE(
    "in a room plain and hardened manifolds agree to 1e-12 of the size, on 100,000 pairs of each",
    "[S1][S2][S4][S7][S8][P1][P2]")
{
  Random random(1);
  Agreement spheres, planes, capsules, boxes;
  for (int i = 0; i < random_inputs; ++i)
  {
    const double size = std::ldexp(1, random.whole(-10, 10)); // from a millimetre to a kilometre
    const Sphere<double> a{size * random.in_cube(1), size * random.between(0.01, 1)};
    const Sphere<double> b{size * random.in_cube(1), size * random.between(0.01, 1)};
    const Plane<double> plane{random.direction(), size * random.between(-1, 1)};
    const Vector3<double> start = size * random.in_cube(1);
    const Capsule<double> capsule{{start, size * random.in_cube(1)}, b.radius / 4};
    const int w = random.whole(1, 9), x = random.whole(-9, 9), y = random.whole(-9, 9);
    const Matrix3<double> axes = rational_rotation<double>(w, x, y, random.whole(-9, 9));
    const Obb<double> box{b.center, axes, size * random.in_box(0.1, 1)};
    spheres.compare(plain_sphere_sphere(a, b), sphere_sphere(a, b), size, a.radius + b.radius);
    planes.compare(plain_sphere_plane(a, plane), sphere_plane(a, plane), size, 2 * size);
    capsules.compare(
        plain_sphere_capsule(a, capsule), sphere_capsule(a, capsule), size,
        a.radius + capsule.radius);
    boxes.compare(plain_sphere_box(a, box), sphere_box(a, box), size, a.radius);
  }
  spheres.check();
  planes.check();
  capsules.check();
  boxes.check();
}
// [agree]

// [any_size]
TEST_CASE("beyond float's squares plain spheres of 1e25 m miss, hardened ones overlap", "[S1]")
{
  const Sphere<float> a{{0, 0, 0}, 1e25f}, b{{1e25f, 0, 0}, 1e25f};
  CHECK_FALSE(plain_sphere_sphere(a, b));
  CHECK(sphere_sphere(a, b)->depth == 1e25f);
}

TEST_CASE("centres 1e-23 m apart: the plain normal is up, the hardened one along them", "[case:C4]")
{
  const Sphere<float> a{{0, 0, 0}, 1}, b{{1e-23f, 0, 0}, 1};
  CHECK(plain_sphere_sphere(a, b)->normal == Vector3<float>(0, 1, 0));
  CHECK(sphere_sphere(a, b)->normal == Vector3<float>(1, 0, 0));
  CHECK(sphere_sphere(a, b)->depth == 2.0f);
}
// [any_size]

// [slope]
TEST_CASE("100 km along a slope the plain float depth is 1 mm off, the hardened one 1e-7 m", "[P1]")
{
  const Plane<float> slope{{0.6f, 0.8f, 0}, 0};
  const Sphere<float> ball{{80'000, -60'000, 0}, 0.5f};
  const Rational distance = Rational(0.6f) * 80'000 - Rational(0.8f) * 60'000;
  const double depth = static_cast<double>(Rational(0.5) - distance);
  CHECK(std::abs(plain_sphere_plane(ball, slope)->depth - depth) > 1e-3);
  CHECK(std::abs(sphere_plane(ball, slope)->depth - depth) < 1e-7);
}
// [slope]

// [upright_capsule]
TEST_CASE("from the axis of an upright capsule the plain normal does not lead out", "[case:C3]")
{
  const Capsule<double> upright{{{0, -1, 0}, {0, 1, 0}}, 0.5};
  const Sphere<double> ball{{0, 0, 0}, 0.25};
  const auto moved = [&](const Manifold<double>& manifold) {
    return Sphere<double>{ball.center - 1.01 * manifold.depth * manifold.normal, ball.radius};
  };
  CHECK(plain_sphere_capsule(moved(plain_sphere_capsule(ball, upright).value()), upright));
  CHECK_FALSE(sphere_capsule(moved(sphere_capsule(ball, upright).value()), upright));
}
// [upright_capsule]

// [on_a_face]
TEST_CASE("on an oriented box's face but for rounding the plain normal is off in 4 of 10", "[S7]")
{
  Matrix3<double> axes;
  axes << 0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1;
  const Obb<double> box{{10, 2, 3}, axes, {2, 1, 1}};
  const Vector3<double> into(0.6, -0.8, 0); // against the box's y axis
  Random random(1);
  int plain_off = 0, hardened_off = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3<double> local(random.between(-2, 2), 1, 0);
    const Sphere<double> ball{box.center + axes * local, 0.5};
    plain_off += (plain_sphere_box(ball, box)->normal - into).norm() > 0.1 ? 1 : 0;
    hardened_off += (sphere_box(ball, box)->normal - into).norm() > 0.1 ? 1 : 0;
  }
  CHECK(plain_off > 300);
  CHECK(hardened_off == 0);
}
// [on_a_face]
