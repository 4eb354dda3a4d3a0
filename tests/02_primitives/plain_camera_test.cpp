/// \file
/// What holds for a pixel and for culling, as the formulas stand, and the two cases that they fail.

#include "02_primitives/camera/camera.hpp"
#include "02_primitives/plain_camera/plain_camera.hpp"
#include "02_primitives/shape_bounds/obb_bounds.hpp"

#include "tests/catch.hpp"

#include <numbers>

using namespace cookbook;

namespace
{

/// A camera at (x, 0, 0) that looks along −z, with a right angle high and 2,000 by 2,000 pixels.
template <class Real>
Camera<Real> camera_at(Real x)
{
  const Real right_angle = std::numbers::pi_v<Real> / 2;
  return {
      look_at<Real>({x, 0, 0}, {x, 0, -1}, {0, 1, 0}),
      perspective<Real>(right_angle, 1, 1, 100).value(),
      {2000, 2000}};
}

} // namespace

// [plain_pixel]
TEST_CASE(
    "10 m ahead, 1 m up and 2 m right is at pixel (1200, 900), what is behind at none", "[plain]")
{
  const Camera<double> camera = camera_at<double>(0);
  const Matrix4<double> matrix = clip_from_world(camera);
  // At 10 m the 2,000 pixels see 20 m.
  const auto pixel = pixel_of<double>(matrix, camera.size, {2, 1, -10});
  REQUIRE(pixel);
  CHECK((*pixel - Vector2<double>(1200, 900)).norm() <= 1e-9);
  CHECK_FALSE(pixel_of<double>(matrix, camera.size, {2, 1, 10}));
}

TEST_CASE(
    "to_pixel and the plain pixel agree in a room; in float at 100 km plain is off by a pixel",
    "[plain]")
{
  const auto off_at = [](float x)
  {
    Camera<float> camera = camera_at<float>(x);
    camera.pose.linear() = Matrix3<float>{{0.8f, 0, -0.6f}, {0, 1, 0}, {0.6f, 0, 0.8f}};
    const Vector3<float> p = camera.pose * Vector3<float>(2, 1, -10);
    const auto plain = pixel_of<float>(clip_from_world(camera), camera.size, p);
    return (*plain - to_pixel(camera, p)->pixel).norm();
  };
  CHECK(off_at(3) <= 0.01);
  CHECK(off_at(100'000) >= 0.5);
}
// [plain_pixel]

// [plain_culling]
TEST_CASE(
    "ahead nothing is culled, behind and 9 m beside at 5 m a sphere and a box of 1 m are", "[P18]")
{
  const Frustum<double> view =
      frustum_planes<double>(clip_from_world(camera_at<double>(0)), DepthRange::minus_one_to_one);
  const auto culled = [&](const Vector3<double>& at)
  {
    const Obb<double> box{at, Matrix3<double>::Identity(), {0.5, 0.5, 0.5}};
    const bool sphere = is_culled(view, Sphere<double>{at, 0.5});
    CHECK(is_culled(view, box) == sphere);
    return sphere;
  };
  CHECK_FALSE(culled({0, 0, -5}));
  CHECK_FALSE(culled({5.5, 0, -5})); // the plane x = -z passes 0.35 from the centre
  CHECK(culled({9, 0, -5}));
  CHECK(culled({0, 0, 5}));
}
// [plain_culling]

// [plain_wall]
TEST_CASE("a long wall beside the view is culled by no plane, but by the view's corners", "[P18]")
{
  const Camera<double> camera = camera_at<double>(0);
  const Frustum<double> view =
      frustum_planes<double>(clip_from_world(camera), DepthRange::minus_one_to_one);
  const Obb<double> wall{{205, 0, -85}, Matrix3<double>::Identity(), {100, 1, 65}};
  CHECK_FALSE(is_culled(view, wall)); // wrong: it begins at x = 105, the view ends at x = 100
  CHECK_FALSE(may_see(view, view_corners<double>(camera, -1, 1).value(), bounds_of(wall)));
}
// [plain_wall]
