/// \file
/// What holds for the manifold of two spheres: formulas S1 to S5, S9 and S10, and the cases in
/// which other methods fail.

#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"
#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"
#include "03_sphere_manifolds/sphere_sphere/trial/sphere_lens.hpp"

#include "tests/catch.hpp"

#include <array>
#include <limits>
#include <utility>

using namespace cookbook;

namespace
{

/// The plain function and the hardened one.
const std::array rungs{plain_sphere_sphere<double>, sphere_sphere<double>};

/// Spheres whose centres are (2, 3, 6) apart, a distance of 7: every answer is a short fraction.
const Sphere<double> four_at_origin{{0, 0, 0}, 4};
const Sphere<double> five_seven_away{{2, 3, 6}, 5};

/// A few roundings of numbers of size one: double's unit roundoff is 1.1e-16.
constexpr double rounding = 1e-15;

} // namespace

// [S1]
TEST_CASE("unit spheres 1.5 apart overlap by 0.5, and each moves 0.25", "[S1]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Sphere<double> a{{0, 0, 0}, 1};
  const Sphere<double> b{{1.5, 0, 0}, 1};
  const Manifold<double> manifold = manifold_of(a, b).value();
  CHECK(manifold.depth == 0.5);
  CHECK(penetration_distance(manifold) == 0.25);
}

TEST_CASE("spheres of radius 4 and 5 whose centres are 7 apart overlap by 2", "[S1]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Manifold<double> manifold = manifold_of(four_at_origin, five_seven_away).value();
  CHECK(manifold.depth == Catch::Approx(2).epsilon(rounding));
  CHECK(manifold.points.size() == 1);
  CHECK(manifold.points[0].depth == manifold.depth);
  CHECK(manifold.points[0].feature == 0);
}
// [S1]

TEST_CASE("unit spheres 2.5 apart have no manifold", "[S1]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  CHECK_FALSE(manifold_of({{0, 0, 0}, 1}, {{2.5, 0, 0}, 1}));
}

// [S2]
TEST_CASE("the normal from (0,0,0) to (2,3,6) is (2,3,6)/7, and swapped it turns round", "[S2]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Vector3<double> normal(2.0 / 7, 3.0 / 7, 6.0 / 7);
  const Manifold<double> ab = manifold_of(four_at_origin, five_seven_away).value();
  const Manifold<double> ba = manifold_of(five_seven_away, four_at_origin).value();
  CHECK((ab.normal - normal).norm() <= rounding);
  CHECK((ba.normal + normal).norm() <= rounding);
}
// [S2]

// [S3]
TEST_CASE("the deepest points of radius 4 and 5, 7 apart, are 2 apart along the normal", "[S3]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Manifold<double> manifold = manifold_of(four_at_origin, five_seven_away).value();
  const Vector3<double> deepest_of_a = four_at_origin.center + 4 * manifold.normal;
  const Vector3<double> deepest_of_b = five_seven_away.center - 5 * manifold.normal;
  CHECK((deepest_of_a - Vector3<double>(8, 12, 24) / 7).norm() <= 4 * rounding);
  CHECK((deepest_of_b - Vector3<double>(4, 6, 12) / 7).norm() <= 4 * rounding);
  CHECK((deepest_of_a - deepest_of_b - manifold.depth * manifold.normal).norm() <= 4 * rounding);
}
// [S3]

// [S4]
TEST_CASE("radius 4 and 5, 7 apart, touch at (6,9,18)/7, midway between the surfaces", "[S4]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Manifold<double> manifold = manifold_of(four_at_origin, five_seven_away).value();
  const Vector3<double> contact = manifold.points[0].position;
  CHECK((contact - Vector3<double>(6, 9, 18) / 7).norm() <= 4 * rounding);
}

TEST_CASE("the contact point moves with the spheres", "[S4]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Vector3<double> offset(10, -20, 30);
  const Manifold<double> moved =
      manifold_of({offset, 4}, {offset + five_seven_away.center, 5}).value();
  const Vector3<double> contact = offset + Vector3<double>(6, 9, 18) / 7;
  CHECK((moved.points[0].position - contact).norm() <= 40 * rounding);
}
// [S4]

// [S5]
TEST_CASE("moved apart by the penetration distance, radius 4 and 5 are 9 apart", "[S5]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Manifold<double> manifold = manifold_of(four_at_origin, five_seven_away).value();
  const Vector3<double> move = penetration_distance(manifold) * manifold.normal;
  const Vector3<double> a = four_at_origin.center - move;
  const Vector3<double> b = five_seven_away.center + move;
  CHECK((b - a).norm() == Catch::Approx(9).epsilon(rounding));
}
// [S5]

// [S9]
TEST_CASE("radius 13 and 20, 21 apart, meet in a disc of radius 12, 5 from the first", "[S9]")
{
  const LensDisc<double> disc = lens_disc(21.0, 13.0, 20.0).value();
  CHECK(disc.radius == Catch::Approx(12).epsilon(rounding));
  CHECK(disc.offset == Catch::Approx(5).epsilon(rounding));
}

TEST_CASE("the contact point lies in the plane of the disc only where the radii agree", "[S9]")
{
  const auto contact = [](double r_a, double r_b, double distance)
  {
    return sphere_sphere<double>({{0, 0, 0}, r_a}, {{distance, 0, 0}, r_b})->points[0].position.x();
  };
  CHECK(contact(5, 5, 8) == 4);
  CHECK(lens_disc(8.0, 5.0, 5.0)->offset == 4);
  CHECK(contact(13, 20, 21) == 7); // midway between 13 and 21 - 20
}

TEST_CASE("spheres that are apart, concentric or inside each other have no disc", "[S9]")
{
  CHECK_FALSE(lens_disc(34.0, 13.0, 20.0));
  CHECK_FALSE(lens_disc(6.0, 13.0, 20.0));
  CHECK_FALSE(lens_disc(6.0, 20.0, 13.0));
  CHECK_FALSE(lens_disc(0.0, 1.0, 1.0));
  CHECK(lens_disc(33.0, 13.0, 20.0)->radius == 0);
  CHECK(lens_disc(7.0, 13.0, 20.0)->radius == 0);
}
// [S9]

// [S10]
TEST_CASE("moving a centre by 1e-6 sideways turns the normal by 1e-6 / distance", "[S10]")
{
  for (const double distance : {1.0, 1e-2, 1e-4})
  {
    const double move = 1e-6;
    const Sphere<double> a{{0, 0, 0}, 1};
    const Vector3<double> before = sphere_sphere(a, {{distance, 0, 0}, 1})->normal;
    const Vector3<double> after = sphere_sphere(a, {{distance, move, 0}, 1})->normal;
    // The chord of the angle atan(move / distance); the formula is its first order.
    const double first_order = move / distance;
    CHECK((after - before).norm() == Catch::Approx(first_order).epsilon(first_order));
  }
}
// [S10]

// [touching]
TEST_CASE(
    "touching spheres are in contact with depth 0, whichever comes first", "[case:C8][case:X03]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  const Sphere<double> a{{0, 0, 0}, 1};
  const Sphere<double> b{{2, 0, 0}, 1};
  CHECK(manifold_of(a, b)->depth == 0);
  CHECK(manifold_of(b, a)->depth == 0);
  CHECK_FALSE(manifold_of(a, {{std::nextafter(2.0, 3.0), 0, 0}, 1}));
}
// [touching]

// [concentric]
TEST_CASE("concentric spheres separate along +y by both radii", "[case:C3][case:X02]")
{
  const auto manifold_of = rungs[GENERATE(0u, 1u)];
  for (const double radius : {1.0, 3.0})
  {
    const Manifold<double> manifold = manifold_of({{1, 2, 3}, 1}, {{1, 2, 3}, radius}).value();
    CHECK(manifold.normal == Vector3<double>(0, 1, 0));
    CHECK(manifold.depth == 1 + radius);
  }
}
// [concentric]

TEST_CASE("two points in one place touch with depth 0", "[S1]")
{
  const Manifold<double> manifold = sphere_sphere<double>({{1, 1, 1}, 0}, {{1, 1, 1}, 0}).value();
  CHECK(manifold.depth == 0);
  CHECK(manifold.points[0].position == Vector3<double>(1, 1, 1));
}

// [huge]
TEMPLATE_TEST_CASE(
    "the largest finite numbers give no NaN and the right verdict", "[S1]", float, double)
{
  const TestType most = std::numeric_limits<TestType>::max();
  const Sphere<TestType> left{{-most, 0, 0}, most};
  const Sphere<TestType> right{{most, 0, 0}, most};
  const Sphere<TestType> small{{most, most, most}, 1};
  const Manifold<TestType> touching = sphere_sphere(left, right).value();
  CHECK(touching.normal == Vector3<TestType>(1, 0, 0));
  CHECK(touching.depth == 0);
  CHECK(touching.points[0].position == Vector3<TestType>(0, 0, 0));
  CHECK_FALSE(sphere_sphere(left, small));
  CHECK_FALSE(sphere_sphere<TestType>({{0, 0, 0}, 1}, small));
}
// [huge]

TEMPLATE_TEST_CASE(
    "far apart, or one of them vast, spheres have a finite contact point", "[S4]", float, double)
{
  const TestType most = std::numeric_limits<TestType>::max();
  const Sphere<TestType> one{{0, 0, 0}, 1};
  const Sphere<TestType> distant{{-most, -most, 0}, 1}; // further than the largest number
  const Vector3<TestType> midway(-most / 2, -most / 2, 0);
  const TestType few_roundings = 4 * std::numeric_limits<TestType>::epsilon();
  for (const auto& [a, b] : {std::pair(one, distant), std::pair(distant, one)})
  {
    const Vector3<TestType> position = world_overlap(a, b).position;
    CHECK((position / most - midway / most).norm() <= few_roundings);
  }
  const Vector3<TestType> corner(most, most, most);
  const Vector3<TestType> middle = world_overlap<TestType>({-corner, 1}, {corner, 1}).position;
  CHECK((middle / most).norm() <= few_roundings);
  // From 0 to most and from most / 16 to most / 16 - 1: midway, 17 / 32 of most.
  const SphereOverlap<TestType> vast =
      world_overlap<TestType>({{0, 0, 0}, most}, {{most / 16, 0, 0}, 1});
  CHECK(std::abs(vast.position.x() / most - TestType(17) / 32) <= few_roundings);
  CHECK(std::abs(vast.depth / most - TestType(15) / 16) <= few_roundings);
}

TEMPLATE_TEST_CASE(
    "the smallest spheres in one place are as deep as both radii", "[S1]", float, double)
{
  using Limits = std::numeric_limits<TestType>;
  // A quarter of either would lose its last digit.
  for (const TestType radius : {Limits::denorm_min(), Limits::min() / 8 + Limits::denorm_min()})
  {
    const Sphere<TestType> sphere{{0, 0, 0}, radius};
    CHECK(sphere_sphere(sphere, sphere)->depth == 2 * radius);
  }
}
