/// \file
/// What holds for the manifold of a sphere and an oriented box: outside, on, and inside.

#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"
#include "03_sphere_manifolds/sphere_box/sphere_box.hpp"
#include "tools/exact/exact.hpp"

#include "tests/catch.hpp"

#include <array>

using namespace cookbook;

namespace
{

/// The plain function and the hardened one.
const std::array rungs{plain_sphere_box<double>, sphere_box<double>};

constexpr double rounding = 1e-14;

const Matrix3<double> upright = Matrix3<double>::Identity();

/// A plate 20 wide and 1 thick, its top at y = 0.5.
const Obb<double> plate{{0, 0, 0}, upright, {10, 0.5, 10}};

const Obb<double> cube{{0, 0, 0}, upright, {1, 1, 1}};

/// A box turned about z by the angle of the 3-4-5 triangle: x axis (0.8, 0.6, 0).
Obb<double> oriented_box()
{
  Matrix3<double> axes;
  axes << 0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1;
  return {{1, 2, 3}, axes, {2, 1, 1}};
}

} // namespace

// [S7]
TEST_CASE(
    "a ball of radius 3 above the corner of a cube, (2,2,1) away, meets it at distance 3", "[S7]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Vector3<double> corner(1, 1, 1);
  const Vector3<double> away(2, 2, 1); // of length 3
  const Sphere<double> sphere{corner + away, 3.5};
  const Manifold<double> manifold = manifold_of(sphere, cube).value();
  CHECK(manifold.depth == Catch::Approx(0.5).epsilon(rounding));
  CHECK((manifold.normal + away / 3).norm() <= rounding);
  // Midway between the corner and the ball's point 0.5 beyond it.
  CHECK((manifold.points[0].position - (corner - away / 12)).norm() <= rounding);
}
// [S7]

// [S7_more]
TEST_CASE("a ball 1.5 beyond the face of an oriented box, with radius 2, is 0.5 deep", "[S7]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Obb<double> box = oriented_box();
  const Vector3<double> face_normal(0.8, 0.6, 0);
  const Vector3<double> center = box.center + 3.5 * face_normal + Vector3<double>(0, 0, 0.25);
  const Manifold<double> manifold = manifold_of({center, 2}, box).value();
  CHECK(manifold.depth == Catch::Approx(0.5).epsilon(rounding));
  CHECK((manifold.normal + face_normal).norm() <= rounding);
  CHECK((manifold.points[0].position - (center - 1.75 * face_normal)).norm() <= rounding);
}

TEST_CASE("a ball too far from the box has no manifold", "[S7]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  CHECK_FALSE(manifold_of({{0, 2.6, 0}, 1.5}, cube));
  CHECK(manifold_of({{0, 2.5, 0}, 1.5}, cube)->depth == 0);
}
// [S7_more]

// [S8]
TEST_CASE(
    "a ball 0.05 under the top of a plate leaves upwards by its radius and 0.05",
    "[S8][case:D1][case:X05]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Manifold<double> manifold = manifold_of({{9, 0.45, 0}, 0.1}, plate).value();
  CHECK(manifold.depth == Catch::Approx(0.15).epsilon(rounding));
  CHECK(manifold.normal == Vector3<double>(0, -1, 0)); // from the ball into the plate
  // Midway between the ball's lowest point, 0.35, and the top, 0.5.
  CHECK((manifold.points[0].position - Vector3<double>(9, 0.425, 0)).norm() <= rounding);
}
// [S8]

// [S8_more]
TEST_CASE("inside an oriented box the nearest face is one of the box's own", "[S8]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Obb<double> box = oriented_box();
  const Vector3<double> face_normal(0.6, -0.8, 0); // minus the box's y axis
  const Vector3<double> center = box.center + 0.75 * face_normal;
  const Manifold<double> manifold = manifold_of({center, 1}, box).value();
  CHECK(manifold.depth == Catch::Approx(1.25).epsilon(rounding));
  CHECK((manifold.normal + face_normal).norm() <= rounding);
}

TEST_CASE(
    "across a face the normal stays and the depth grows as the centre sinks",
    "[S8][case:D3][case:X06]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  for (int i = -100; i <= 100; ++i)
  {
    const double height = 0.5 + 1e-5 * i;
    const Manifold<double> manifold = manifold_of({{9, height, 0}, 0.1}, plate).value();
    // The normal is a difference times the inverse of its length: two roundings.
    CHECK((manifold.normal - Vector3<double>(0, -1, 0)).norm() <= 2.3e-16);
    CHECK(manifold.depth == Catch::Approx(0.1 - 1e-5 * i).epsilon(rounding));
  }
}
// [S8_more]

// [degenerate]
TEST_CASE(
    "a ball in the very centre leaves through the nearest face, the positive one",
    "[case:D2][case:X07]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Manifold<double> manifold = manifold_of({{0, 0, 0}, 0.1}, plate).value();
  CHECK(manifold.depth == 0.6);
  CHECK(manifold.normal == Vector3<double>(0, -1, 0));
  CHECK(manifold_of({{0, 0, 0}, 0.1}, cube)->normal == Vector3<double>(-1, 0, 0));
}

TEST_CASE("a ball centred on a corner is as deep as its radius, with a unit normal", "[case:D4]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Manifold<double> manifold = manifold_of({{1, 1, 1}, 1}, cube).value();
  CHECK(manifold.depth == 1);
  CHECK(manifold.normal == Vector3<double>(-1, 0, 0));
}
// [degenerate]

TEST_CASE("a ball sinking into a large box answers as it does in a half-space", "[case:D5]")
{
  const Obb<double> ground{{0, -50, 0}, upright, {50, 50, 50}};
  for (int i = 0; i <= 200; ++i)
  {
    const double height = -0.5 + i / 200.0;
    const Manifold<double> manifold = sphere_box<double>({{0, height, 0}, 0.5}, ground).value();
    CHECK(manifold.depth == Catch::Approx(0.5 - height).epsilon(rounding).margin(rounding));
    CHECK((manifold.normal - Vector3<double>(0, -1, 0)).norm() <= 2.3e-16);
  }
}

TEST_CASE("a ball 4 above a long low box misses it", "[case:D8][case:X28]")
{
  const Obb<double> beam{{0, 0, 0}, upright, {10, 1, 1}};
  CHECK_FALSE(sphere_box<double>({{0, 5, 0}, 0.5}, beam));
  CHECK(sphere_box<double>({{0, 5, 0}, 4.5}, beam)->depth == 0.5);
}

TEST_CASE("a small ball far inside sinks one to one, to 1e-9", "[case:D9]")
{
  // The top is at z = -0.005, where a ball of radius 0.005 touches it from z = 0 on.
  const Obb<double> box{{0, 0, -0.255}, upright, {0.5, 0.5, 0.25}};
  for (int i = 0; i <= 100; ++i)
  {
    const double z = -1e-6 - i * 1e-4;
    CHECK(sphere_box<double>({{0, 0, z}, 0.005}, box)->depth == Catch::Approx(-z).margin(1e-9));
  }
}
