/// \file
/// \brief Where each method for two spheres holds, and where it fails and how.

#include "03_sphere_manifolds/sphere_methods/trial/sphere_methods.hpp"
#include "03_sphere_manifolds/sphere_methods/trial/sphere_methods_truth.hpp"

#include "tests/catch.hpp"

#include <cmath>

using namespace cookbook;
using Catch::Approx;

namespace
{

Sphere<float> at_x(float x, float radius)
{
  return {{x, 0, 0}, radius};
}

/// The largest error of a method on a workload of 200 pairs; wrong verdicts are counted.
struct Worst
{
  int wrong = 0;
  double depth = 0;
  double normal = 0;
};

Worst worst(const std::string& method_name, const std::string& workload_name)
{
  Worst worst;
  for (const SphereMethod& method : sphere_methods())
  {
    for (const Recipe& recipe : sphere_workload_recipes())
    {
      if (method.name != method_name || recipe.name != workload_name)
      {
        continue;
      }
      for (const WorldPair& pair : sphere_workload(recipe, 200).pairs)
      {
        const double larger = std::max(pair.first.radius, pair.second.radius);
        const SphereError error = sphere_error(
            method.run(pair.first, pair.second), exact_sphere_sphere(pair),
            static_cast<float>(larger));
        worst.wrong += error.verdict ? 1 : 0;
        worst.depth = std::max(worst.depth, error.depth);
        worst.normal = std::max(worst.normal, error.normal);
      }
    }
  }
  return worst;
}

} // namespace

// [published]
TEST_CASE("as published: unit spheres 1.9 apart move by 0.5 each where 0.05 is right", "[case:X01]")
{
  const auto published = sphere_sphere_as_published(at_x(0, 1), at_x(1.9f, 1));
  const auto right = sphere_sphere(at_x(0, 1), at_x(1.9f, 1));
  CHECK(penetration_distance(*published) == 0.5f);
  CHECK(penetration_distance(*right) == Catch::Approx(0.05).margin(1e-6)); // 4 ulp of 1, rounded up
}

TEST_CASE("as published: spheres of radius 0.5, 0.6 apart, have depth 0; right is 0.4", "[case:C2]")
{
  CHECK(sphere_sphere_as_published(at_x(0, 0.5f), at_x(0.6f, 0.5f))->depth == 0);
  CHECK(
      sphere_sphere(at_x(0, 0.5f), at_x(0.6f, 0.5f))->depth ==
      Catch::Approx(0.4).margin(1e-6)); // 4 ulp of 1, rounded up
}

TEST_CASE("as published: concentric and nearly concentric spheres do not touch", "[case:X02]")
{
  CHECK_FALSE(sphere_sphere_as_published(at_x(0, 1), at_x(0, 1)));
  CHECK_FALSE(sphere_sphere_as_published(at_x(0, 1), at_x(1e-23f, 1)));
  CHECK(sphere_sphere(at_x(0, 1), at_x(0, 1))->depth == 2);
  CHECK(sphere_sphere(at_x(0, 1), at_x(1e-23f, 1))->normal.x() == 1);
}

TEST_CASE("as published: the manifold counts touching, at distance 2 as here", "[case:X03]")
{
  CHECK(sphere_sphere_as_published(at_x(0, 1), at_x(2, 1)));
  CHECK(sphere_sphere(at_x(0, 1), at_x(2, 1)));
}
// [published]

// [far]
TEST_CASE("a million metres out, coordinates in float are off by thousands of ulps", "[case:C7]")
{
  const Worst world = worst("sphere_sphere, float", "far");
  const Worst relative = worst("relative, float", "far");
  const Worst plain = worst("plain_sphere_sphere, float", "far");
  CHECK((world.wrong > 0 || world.depth > 1e4));
  CHECK((plain.wrong > 0 || plain.depth > 1e4));
  CHECK(relative.wrong == 0);
  CHECK(relative.depth <= 4); // as near the origin
}
// [far]

// [reciprocal]
TEST_CASE("each Newton step squares the error of 1/√x and takes 3/2 of it", "[sphere_methods]")
{
  // Of the estimate, at most 0.0344 where the constant is this one: the step leaves 3/2 e² + ….
  double none = 0;
  double one = 0;
  double two = 0;
  double three = 0;
  for (float x = 1; x < 4; x += 0.001f)
  {
    const double root = std::sqrt(static_cast<double>(x));
    none = std::max(none, std::abs(reciprocal_square_root<0>(x) * root - 1));
    one = std::max(one, std::abs(reciprocal_square_root<1>(x) * root - 1));
    two = std::max(two, std::abs(reciprocal_square_root<2>(x) * root - 1));
    three = std::max(three, std::abs(reciprocal_square_root<3>(x) * root - 1));
  }
  CHECK(none < 0.0345);
  CHECK(one < 1.5 * 0.0345 * 0.0345 * (1 + 0.0345)); // the cubic term of the step's error
  CHECK(two < 6e-6);                                 // 3/2 of one² is 4.8e-6, and rounding
  CHECK(three < 3e-7);                               // rounding alone: a few ulps of 1
}

TEST_CASE(
    "one Newton step is worth 1e3 ulps or more of depth, three are worth 8", "[sphere_methods]")
{
  CHECK(worst("reciprocal, 1 step", "touching").depth > 1e3);
  CHECK(worst("reciprocal, 3 steps", "touching").depth < 8);
}
// [reciprocal]

TEST_CASE("sphere_sphere in float is within 4 ulps on every workload but far", "[S1][S2][S10]")
{
  for (const std::string workload :
       {"mixed", "touching", "apart", "shallow", "deep", "tiny", "huge", "concentric"})
  {
    CAPTURE(workload);
    const Worst found = worst("sphere_sphere, float", workload);
    CHECK(found.wrong == 0);
    CHECK(found.depth <= 4);
    CHECK(found.normal <= 4);
  }
}

TEST_CASE("the workloads are what they are called", "[sphere_methods]")
{
  int touching = 0;
  for (const WorldPair& pair : sphere_workload(sphere_workload_recipes()[0], 1000).pairs)
  {
    touching += sphere_sphere<double>(pair.first, pair.second) ? 1 : 0;
  }
  CHECK(touching > 400);
  CHECK(touching < 600);
  for (const WorldPair& pair : sphere_workload(sphere_workload_recipes()[2], 1000).pairs)
  {
    REQUIRE_FALSE(sphere_sphere<double>(pair.first, pair.second));
  }
}
