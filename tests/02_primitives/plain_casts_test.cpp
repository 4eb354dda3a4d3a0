/// \file
/// What holds for casts as the formulas stand, and the four cases that they fail.

#include "02_primitives/casts/casts.hpp"
#include "02_primitives/plain_casts/plain_casts.hpp"

#include "tests/catch.hpp"

#include <array>
#include <random>

using namespace cookbook;

// [plain_casts_by_hand]
TEST_CASE(
    "a ray that sinks by 3 and goes on by 4 meets plane, sphere, box and triangle",
    "[P8][P9][P10][P12]")
{
  using V = Vector3<double>;
  const Ray<double> ray{{0, 3, 0}, {4, -3, 0}};
  CHECK(ray_plane(ray, {{0, 1, 0}, 0}) == 1.0);
  CHECK(ray_sphere(ray, {{4, 0, 0}, 2}) == Catch::Approx(0.6)); // 3 of the 5 to its centre
  CHECK(ray_box(ray, {V(2, 0, -1), V(4, 2, 1)}) == 0.5);
  CHECK(ray_triangle(ray, {{2, 0, -1}, {2, 4, -1}, {2, 0, 3}}) == 0.5);
  const Ray<double> away{{0, 3, 0}, {-4, 3, 0}};
  CHECK_FALSE((ray_plane(away, {{0, 1, 0}, 0}) || ray_sphere(away, {{4, 0, 0}, 2})));
  CHECK_FALSE(ray_box(away, {V(2, 0, -1), V(4, 2, 1)}));
  CHECK_FALSE(ray_triangle(away, {{2, 0, -1}, {2, 4, -1}, {2, 0, 3}}));
  CHECK(
      ray_sphere<double>({{1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, 1}) == 0); // along a tangent, from it
}
// [plain_casts_by_hand]

// [plain_casts_fail]
TEST_CASE("from inside a sphere the plain t is negative, that of cast is 0", "[P9]")
{
  const Ray<double> ray{{0, 0, 0}, {1, 0, 0}};
  const Sphere<double> around{{0.5, 0, 0}, 1};
  CHECK(ray_sphere(ray, around) == -0.5);
  CHECK(cast(ray, around)->t == 0);
}

TEST_CASE("a ray along a face of a box is lost by 0/0, and met by cast at t = 1", "[P10][case:E3]")
{
  const Aabb<double> box(Vector3<double>(0, 0, 0), Vector3<double>(1, 1, 1));
  const Ray<double> along{{-1, 1, 0.5}, {1, 0, 0}};
  CHECK_FALSE(ray_box(along, box));
  CHECK(cast(along, box)->t == 1);
}

TEST_CASE(
    "of 100,000 float rays at the diagonal of a quad some get through, by cast none",
    "[P12][case:E7]")
{
  using V = Vector3<float>;
  const V a(-3.1f, 0.2f, -2.7f), b(2.9f, 0.4f, -3.3f), c(3.3f, -0.1f, 2.8f), d(-2.6f, 0.3f, 3.2f);
  std::mt19937 random(1);
  const auto fraction = [&] { return float(random() % 65536) / 65536; };
  int through = 0, through_by_cast = 0;
  for (int i = 0; i < 100'000; ++i)
  {
    const V at = a + (0.1f + 0.8f * fraction()) * (c - a);
    const V origin(fraction() - 0.5f, 5 + fraction(), fraction() - 0.5f);
    const Ray<float> ray{origin, at - origin};
    const std::array<Triangle<float>, 2> quad{{{a, c, b}, {a, d, c}}};
    through += ray_triangle(ray, quad[0]) || ray_triangle(ray, quad[1]) ? 0 : 1;
    through_by_cast += cast(ray, quad[0]) || cast(ray, quad[1]) ? 0 : 1;
  }
  CHECK(through > 1000);
  CHECK(through_by_cast == 0);
}
// [plain_casts_fail]

TEST_CASE(
    "20,000 double rays in a room: where plain and cast both hit, t agrees to 1e-9",
    "[P9][P10][P12]")
{
  std::mt19937 random(6);
  const auto draw = [&] { return double(random()) * 0x1p-31 - 1; };
  const auto point = [&]() -> Vector3<double> {
    return {draw(), draw(), draw()};
  };
  double worst = 0;
  int hits = 0, different = 0;
  const auto compare = [&](const std::optional<double>& plain, const auto& hit)
  {
    different += plain.has_value() == hit.has_value() ? 0 : 1;
    hits += hit ? 1 : 0;
    worst = plain && hit ? std::max(worst, std::abs(*plain - hit->t)) : worst;
  };
  for (int i = 0; i < 20'000; ++i)
  {
    const Ray<double> ray{point() + Vector3<double>(4, 0, 0), point() - Vector3<double>(2, 0, 0)};
    const Sphere<double> sphere{point(), 0.5};
    const Vector3<double> corner = point();
    const Aabb<double> box(corner, Vector3<double>(corner + Vector3<double>(0.5, 1, 1)));
    const Triangle<double> triangle{point(), point(), point()};
    compare(ray_sphere(ray, sphere), cast(ray, sphere));
    compare(ray_box(ray, box), cast(ray, box));
    compare(ray_triangle(ray, triangle), cast(ray, triangle));
  }
  CHECK((worst <= 1e-9 && different == 0 && hits > 3000));
}
