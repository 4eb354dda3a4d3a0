/// \file
/// What holds for the manifold of a sphere and a plane, and when a plane is all that a scene needs.

#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"
#include "03_sphere_manifolds/sphere_plane/sphere_plane.hpp"

#include "tests/catch.hpp"

#include <array>

using namespace cookbook;

namespace
{

/// The plain function and the hardened one.
const std::array rungs{plain_sphere_plane<double>, sphere_plane<double>};

/// A plane along the 3-4-5 triangle: every distance to a whole point is a multiple of 0.2.
const Plane<double> slope{{0.6, 0.8, 0}, 1};

/// A few roundings of numbers of size ten.
constexpr double rounding = 1e-14;

} // namespace

// [sphere_plane]
TEST_CASE("a ball of radius 0.5 whose centre is 0.3 below the ground is 0.8 deep", "[case:C10]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Plane<double> ground{{0, 1, 0}, 0};
  const Manifold<double> manifold = manifold_of({{0, -0.3, 0}, 0.5}, ground).value();
  CHECK(manifold.depth == 0.8);
  CHECK(manifold.normal == Vector3<double>(0, -1, 0));
  // Midway between the ball's lowest point, -0.8, and the surface.
  CHECK(manifold.points[0].position.y() == Catch::Approx(-0.4).epsilon(rounding));
}

TEST_CASE("a ball of radius 5 that is 4 above the slope is 1 deep, midway at 4.5", "[P1]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Manifold<double> manifold = manifold_of({{3, 4, 5}, 5}, slope).value();
  CHECK(manifold.depth == Catch::Approx(1).epsilon(rounding));
  const Vector3<double> midway = Vector3<double>(3, 4, 5) - 4.5 * slope.normal;
  CHECK((manifold.points[0].position - midway).norm() <= rounding);
  CHECK((manifold.normal + slope.normal).norm() == 0);
}
// [sphere_plane]

TEST_CASE("a ball that touches the ground has depth 0, one that does not has no manifold", "[P1]")
{
  const Plane<double> ground{{0, 1, 0}, 0};
  CHECK(sphere_plane<double>({{7, 0.5, 0}, 0.5}, ground)->depth == 0);
  CHECK_FALSE(sphere_plane<double>({{7, 0.51, 0}, 0.5}, ground));
}

// [needs]
namespace
{

/// How much the depth of a ball of radius 0.5 changes, `x` [m] away from where the ground is level
/// with the plane y = 0, if that ground is a planet instead of a plane.
double change_of_depth(double x)
{
  constexpr double planet_radius = 6.371e6; // [m], the Earth's mean radius
  const Sphere<double> sphere{{x, 0, 0}, 0.5};
  const Sphere<double> planet{{0, -planet_radius, 0}, planet_radius};
  const double flat = sphere_plane<double>(sphere, {{0, 1, 0}, 0})->depth;
  const std::optional<Manifold<double>> round = sphere_sphere(sphere, planet);
  return flat - (round ? round->depth : 0);
}

/// What the scene of this chapter allows [m]: a hundredth of a millimetre.
constexpr double tolerance = 1e-5;

} // namespace

TEST_CASE("10 m away the ground may be a plane: a planet changes less than 0.01 mm", "[needs]")
{
  CHECK(std::abs(change_of_depth(10)) < tolerance);
  // The sagitta x² / 2R.
  CHECK(change_of_depth(10) == Catch::Approx(100 / (2 * 6.371e6)).epsilon(1e-3));
}

TEST_CASE("2 km away it may not: the ground falls away by more than 0.3 m", "[needs]")
{
  CHECK(change_of_depth(2000) > 0.3);
}
// [needs]
