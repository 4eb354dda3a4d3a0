/// \file
/// How far float is from the truth over a million random pairs in each of five worlds.

#include "tests/03_sphere_manifolds/accuracy.hpp"

#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

namespace
{

/// Two spheres of radii between `least` and 1, in a quarter of the cases within a few ulp of
/// touching.
std::pair<Sphere<double>, Sphere<double>> random_pair(Random& random, double ratio)
{
  const double radius_a = random.between(0.05, 1);
  const double radius_b = ratio * random.between(0.05, 1);
  const double radii = radius_a + radius_b;
  const double near_touching = 1 + random.between(-1, 1) * 1e-6;
  const double distance = radii * (random.one_in(4) ? near_touching : random.between(0, 1.3));
  const Vector3<double> center = random.in_cube(1);
  return {{center, radius_a}, {center + distance * random.direction(), radius_b}};
}

/// The errors of `sphere_sphere<float>` on pairs `scale` times as large.
Accuracy accuracy_of_float(double scale, double ratio)
{
  Random random(1);
  Accuracy accuracy;
  for (int i = 0; i < pairs_per_world; ++i)
  {
    const auto [a, b] = random_pair(random, ratio);
    const Sphere<float> float_a = rounded(a, scale);
    const Sphere<float> float_b = rounded(b, scale);
    accuracy.compare(
        sphere_sphere(float_a, float_b), std::max(float_a.radius, float_b.radius),
        [&](auto real)
        {
          using Real = decltype(real);
          return true_overlap(exactly<Real>(float_a), exactly<Real>(float_b));
        });
  }
  return accuracy;
}

} // namespace

TEST_CASE("float answers within 4 ulp at the scale of metres", "[S1][S2]")
{
  expect_within_4_ulp(accuracy_of_float(1, 1));
}

TEST_CASE("float answers within 4 ulp at the scale of millimetres", "[S1][S2]")
{
  expect_within_4_ulp(accuracy_of_float(1e-3, 1));
}

TEST_CASE("float answers within 4 ulp at the scale of kilometres", "[S1][S2]")
{
  expect_within_4_ulp(accuracy_of_float(1e3, 1));
}

TEST_CASE("float answers within 4 ulp for a radius a million times the other", "[S1][S2][case:C6]")
{
  expect_within_4_ulp(accuracy_of_float(1e3, 1e-6));
}

TEST_CASE("relative to A, float answers within 4 ulp a million metres away", "[S1][S2][case:C7]")
{
  Random random(1);
  Accuracy accuracy;
  const Vector3<double> distant(1e6, 1e6, 1e6);
  for (int i = 0; i < pairs_per_world; ++i)
  {
    const std::pair<Sphere<double>, Sphere<double>> pair = random_pair(random, 1);
    const Sphere<double> a{pair.first.center + distant, pair.first.radius};
    const Sphere<double> b{pair.second.center + distant, pair.second.radius};
    const float radius_a = rounded(a.radius);
    const float radius_b = rounded(b.radius);
    const Vector3<double> a_to_b = b.center - a.center;
    accuracy.compare(
        sphere_sphere_relative<float>(a_to_b.cast<float>(), radius_a, radius_b),
        std::max(radius_a, radius_b),
        [&](auto real)
        {
          using Real = decltype(real);
          return true_overlap<Real>(
              {exact<Real>(a.center), Real(radius_a)}, {exact<Real>(b.center), Real(radius_b)});
        });
  }
  expect_within_4_ulp(accuracy);
}
