/// \file
/// What holds for a camera: its clip space by hand, and to pixels and back.

#include "02_primitives/camera/camera.hpp"
#include "02_primitives/camera/trial/camera_cases.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/random_numbers.hpp"
#include "tests/verdicts.hpp"

#include <cmath>
#include <limits>
#include <numbers>

using namespace cookbook;

namespace
{

using V = Vector3<double>;

/// Where a point of the camera's coordinates is in clip space, after the division by w.
template <class Real>
Vector3<Real> ndc_of(const Matrix4<Real>& matrix, const Vector3<Real>& point)
{
  const Vector<Real, 4> clip = matrix * point.homogeneous();
  return clip.template head<3>() / clip[3];
}

} // namespace

// [clip_by_hand]
TEST_CASE("a right angle, 2 wide: near is -1, far 1, the edges at plus and minus 1", "[camera]")
{
  const Matrix4<double> m = *perspective(std::numbers::pi / 2, 2.0, 1.0, 9.0);
  const auto at = [&](double x, double y, double z) { return ndc_of<double>(m, V(x, y, z)); };
  CHECK((at(0, 0, -1) - V(0, 0, -1)).norm() <= 1e-15);
  CHECK((at(0, 0, -9) - V(0, 0, 1)).norm() <= 1e-15);
  CHECK((at(-2, 1, -1) - V(-1, 1, -1)).norm() <= 1e-15);
  CHECK((at(18, -9, -9) - V(1, -1, 1)).norm() <= 1e-15);
  // Half of all depths are used up at 2fn / (f + n) = 1.8 m.
  CHECK(std::abs(at(0, 0, -1.8).z()) <= 1e-15);
}

TEST_CASE("reversed depth is near / distance", "[camera]")
{
  const Matrix4<double> m = *perspective_reversed(std::numbers::pi / 2, 2.0, 0.5);
  CHECK(ndc_of<double>(m, V(0, 0, -0.5)).z() == 1);
  CHECK(ndc_of<double>(m, V(0, 0, -8)).z() == 0.0625);
  CHECK((ndc_of<double>(m, V(-2, 1, -1)) - V(-1, 1, 0.5)).norm() <= 1e-15);
}

TEST_CASE("without perspective: a block 4 wide, 2 high, from 1 behind to 3 ahead", "[camera]")
{
  const Matrix4<double> m = *orthographic(4.0, 2.0, -1.0, 3.0);
  CHECK(ndc_of<double>(m, V(2, 1, 1)) == V(1, 1, -1));
  CHECK(ndc_of<double>(m, V(-2, -1, -3)) == V(-1, -1, 1));
  CHECK(ndc_of<double>(m, V(0, 0, -1)) == V(0, 0, 0));
}
// [clip_by_hand]

// [no_projection]
TEMPLATE_TEST_CASE(
    "no projection: a near plane at 0 or behind far, an angle of 0 or π", "[camera]", float, double)
{
  using T = TestType;
  const T infinite = std::numeric_limits<T>::infinity(), none = infinite - infinite;
  CHECK(perspective<T>(1, 1, T(0.1), 100));
  CHECK_FALSE(perspective<T>(1, 1, 0, 100));
  CHECK_FALSE(perspective<T>(1, 1, -1, 100));
  CHECK_FALSE(perspective<T>(1, 1, 2, 2));
  CHECK_FALSE(perspective<T>(1, 1, 1, infinite));
  CHECK_FALSE(perspective<T>(0, 1, 1, 2));
  CHECK_FALSE(perspective<T>(T(3.2), 1, 1, 2));
  CHECK_FALSE(perspective<T>(std::numbers::pi_v<T> + T(1e-6), 1, 1, 2));
  CHECK_FALSE(perspective<T>(1, 0, 1, 2));
  CHECK_FALSE(perspective<T>(none, 1, 1, 2));
  CHECK_FALSE(perspective<T>(1, none, 1, 2));
  CHECK_FALSE(perspective<T>(1, 1, none, 2));
  CHECK(perspective<T>(1, 1, T(1e-30), T(1e30)));
  CHECK(perspective_reversed<T>(1, 1, T(1e-30)));
  CHECK_FALSE(perspective_reversed<T>(1, 1, 0));
  CHECK_FALSE(perspective_reversed<T>(1, infinite, 1));
  CHECK_FALSE(perspective_reversed<T>(4, 1, 1));
  CHECK_FALSE(perspective_reversed<T>(1, 1, infinite));
  CHECK(orthographic<T>(1, 1, -1, 1));
  CHECK_FALSE(orthographic<T>(0, 1, -1, 1));
  CHECK_FALSE(orthographic<T>(1, -1, -1, 1));
  CHECK_FALSE(orthographic<T>(1, 1, 1, 1));
  CHECK_FALSE(orthographic<T>(1, 1, -infinite, 1));
  CHECK_FALSE(orthographic<T>(1, 1, 0, infinite));
  CHECK_FALSE(orthographic<T>(T(1e-30) * T(1e-9), 1, 0, none));
}
// [no_projection]

// [there_and_back]
TEMPLATE_TEST_CASE(
    "to a pixel and back, and the ray of the pixel passes the point", "[camera]", float, double)
{
  using V3 = Vector3<TestType>;
  Random draw(7);
  double worst = 0, off_ray = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const bool flat = i % 2 == 0;
    Matrix4<TestType> lens = flat ? *orthographic<TestType>(9, 6, TestType(0.5), 20)
                                  : *perspective<TestType>(1, TestType(1.5), TestType(0.5), 20);
    lens(0, 2) = lens(1, 2) = TestType(i % 3) / 8; // the middle of the picture is elsewhere
    const V3 eye = draw.in_cube(5).template cast<TestType>();
    const Camera<TestType> camera{
        look_at<TestType>(eye, draw.in_cube(5).template cast<TestType>(), V3(0, 1, 0)),
        lens,
        {600, 400}};
    const V3 point = draw.in_cube(9).template cast<TestType>();
    const auto seen = to_pixel(camera, point);
    const V inside =
        to_local<double>(camera.pose.template cast<double>(), point.template cast<double>());
    REQUIRE(seen.has_value() == (flat || inside.z() < 0));
    if (!seen || inside.z() > -0.5 || inside.z() < -20)
    {
      continue;
    }
    const double distance = inside.norm();
    const auto back = unproject(camera, *seen);
    REQUIRE(back.has_value());
    worst = std::max(worst, static_cast<double>((*back - point).norm()) / (distance * distance));
    const Ray<TestType> ray = picking_ray(camera, seen->pixel);
    const V difference = (point - ray.origin).template cast<double>();
    const V direction = ray.direction.template cast<double>();
    off_ray = std::max(off_ray, difference.cross(direction).norm() / distance);
    REQUIRE(difference.dot(direction) > 0);
  }
  // The depth is rounded once, which moves a point by about u · distance² / near.
  const double u = static_cast<double>(std::numeric_limits<TestType>::epsilon());
  CHECK(worst <= 16 * u);
  CHECK(off_ray <= 16 * u);
}

TEST_CASE("the middle of the picture, its corners, and what is behind", "[camera]")
{
  const Camera<double> camera = scene_camera();
  const PixelDepth<double> middle = *to_pixel<double>(camera, {0, 0, 0});
  CHECK((middle.pixel - Vector<double, 2>(300, 200)).norm() <= 1e-12);
  // 5 m ahead of near 1 and far 9: (f + n - 2fn / 5) / (f - n) = (10 - 3.6) / 8.
  CHECK(std::abs(middle.depth - 0.8) <= 1e-15);
  CHECK_FALSE(to_pixel<double>(camera, {0, 3, 4}));
  CHECK_FALSE(to_pixel<double>(camera, {0, 6, 8}));
  // The ray of the upper left corner: 1.5 to the left, 1 up, 1 ahead.
  const Ray<double> ray = picking_ray<double>(camera, {0, 0});
  const V expected = (V(-1.5, 0, 0) + V(0, 0.8, -0.6) - V(0, 0.6, 0.8)).normalized();
  CHECK((ray.direction - expected).norm() <= 1e-15);
  CHECK(ray.origin == V(0, 3, 4));
  // Depths that nothing ahead has.
  const Camera<double> reversed{camera.pose, *perspective_reversed(1.0, 1.5, 0.5), camera.size};
  CHECK_FALSE(unproject<double>(reversed, {{1, 1}, 0}));
  CHECK_FALSE(unproject<double>(reversed, {{1, 1}, -1}));
  CHECK_FALSE(view_corners<double>(reversed, 1, 0));
  CHECK(view_corners<double>(reversed, 1, 0.1).has_value());
  CHECK_FALSE(unproject<double>(camera, {{1, 1}, 5}));
}

TEST_CASE("4,000 km away a pixel of a float camera is where it would be near by", "[camera]")
{
  const Matrix4<float> lens = *perspective(1.0f, 1.5f, 0.5f, 20.0f);
  const Vector3<float> shift(4'194'304, 0, 0), up(0, 1, 0);
  const Camera<float> near_by{look_at<float>({0, 3, 4}, {0, 0, 0}, up), lens, {600, 400}};
  const Camera<float> away{
      look_at<float>(shift + Vector3<float>(0, 3, 4), shift, up), lens, {600, 400}};
  const Vector3<float> point(1, 0.5f, 0);
  CHECK(to_pixel<float>(near_by, point)->pixel == to_pixel<float>(away, shift + point)->pixel);
  // The same through one matrix is off by whole pixels, for its move is rounded to a quarter metre.
  const Vector<float, 4> clip = clip_from_world(away) * Vector3<float>(shift + point).homogeneous();
  const float x = 300 + 300 * clip[0] / clip[3];
  CHECK(std::abs(x - to_pixel<float>(near_by, point)->pixel.x()) > 1);
}
// [there_and_back]

TEST_CASE("each way to keep depths holds or fails as the table says", "[camera]")
{
  const std::string zero = "0…1, unasked", whole = "−1…1", best = "reversed";
  check_verdicts(
      depth_verdicts(), names_of(depth_methods()),
      {{"1 cm apart at 10 m", {zero, whole, best}},
       {"1 m apart at 1 km", {zero, whole, best}},
       {"100 m apart at 50 km", {best}},
       {"the same, near plane at 10 m", {zero, whole, best}},
       {"1 m apart at 1 km, near plane at 0", {whole, best}}});
}
