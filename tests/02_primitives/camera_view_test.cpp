/// \file
/// What is in view of a camera: formula P18, and which boxes and spheres are left out.

#include "02_primitives/camera/camera.hpp"
#include "02_primitives/camera/trial/camera_cases.hpp"
#include "02_primitives/camera/trial/view_truth.hpp"
#include "02_primitives/shape_bounds/corner_arm.hpp"
#include "02_primitives/shape_bounds/obb_bounds.hpp"

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

} // namespace

// [P18]
TEST_CASE("a right angle from the origin: the planes are |x| = -z, |y| = -z, z = -1, -9", "[P18]")
{
  const Matrix4<double> m = *perspective(std::numbers::pi / 2, 1.0, 1.0, 9.0);
  const Frustum<double> f = frustum_planes<double>(m, DepthRange::minus_one_to_one);
  const double h = std::sqrt(0.5);
  const std::array<Plane<double>, 6> expected{
      {{{-h, 0, h}, 0},
       {{h, 0, h}, 0},
       {{0, -h, h}, 0},
       {{0, h, h}, 0},
       {{0, 0, 1}, -1},
       {{0, 0, -1}, 9}}};
  for (unsigned i = 0; i < 6; ++i)
  {
    INFO(i);
    CHECK((f.planes[i].normal - expected[i].normal).norm() <= 1e-15);
    CHECK(std::abs(f.planes[i].distance - expected[i].distance) <= 1e-14);
  }
}
// [P18]

// [P18_any]
TEST_CASE("a point is behind all six planes exactly where its pixel and depth say so", "[P18]")
{
  Random draw(7);
  int inside = 0, wrong = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const bool flat = i % 2 == 0, reversed = i % 3 == 0;
    const double near_plane = draw.between(0.1, 2), far_plane = near_plane + draw.between(1, 20);
    const Matrix4<double> lens =
        flat       ? *orthographic(draw.between(1, 9), draw.between(1, 9), near_plane, far_plane)
        : reversed ? *perspective_reversed(draw.between(0.2, 2), 1.5, near_plane)
                   : *perspective(draw.between(0.2, 2), 1.5, near_plane, far_plane);
    const Camera<double> camera{
        look_at<double>(draw.in_cube(5), draw.in_cube(5), draw.in_cube(1)), lens, {640, 480}};
    const bool whole = flat || !reversed;
    const Frustum<double> f = frustum_planes<double>(
        clip_from_world(camera), whole ? DepthRange::minus_one_to_one : DepthRange::zero_to_one);
    const V point = draw.in_cube(9);
    const std::optional<PixelDepth<double>> seen = to_pixel(camera, point);
    // How far inside of the picture and the depths the point is, at the least.
    const double least = whole ? -1 : 0;
    const double margin = !seen
                              ? -1
                              : std::min(
                                    {seen->pixel.x(), 640 - seen->pixel.x(), seen->pixel.y(),
                                     480 - seen->pixel.y(), seen->depth - least, 1 - seen->depth});
    if (std::abs(margin) < 1e-6)
    {
      continue; // within rounding of an edge
    }
    inside += margin > 0;
    wrong += may_see(f, Sphere<double>{point, 0}) != (margin > 0);
    wrong += may_see(f, Eigen::AlignedBox<double, 3>(point, point)) != (margin > 0);
  }
  CHECK(wrong == 0);
  CHECK(inside > random_inputs / 50);
}

TEST_CASE("the far plane of a reversed perspective is infinitely far and keeps all", "[P18]")
{
  const Matrix4<float> m = *perspective_reversed(1.0f, 1.0f, 0.1f);
  const Frustum<float> f = frustum_planes<float>(m, DepthRange::zero_to_one);
  CHECK(f.planes[4].distance == std::numeric_limits<float>::max());
  // Row 4 less row 3 is (0, 0, -1, -near): depths up to 1 are those from near on.
  CHECK(std::abs(f.planes[5].distance + 0.1f) <= 0x1p-24f);
  CHECK(may_see(f, Sphere<float>{{0, 0, -1e30f}, 0}));
  CHECK_FALSE(may_see(f, Sphere<float>{{0, 0, 1}, 0.5f}));
  // A matrix of zeros and one that keeps nothing.
  const Matrix4<float> nothing = Matrix4<float>::Zero();
  CHECK(may_see(
      frustum_planes<float>(nothing, DepthRange::zero_to_one), Sphere<float>{{1, 2, 3}, 0}));
  Matrix4<float> negative = nothing;
  negative(3, 3) = -1;
  CHECK_FALSE(may_see(
      frustum_planes<float>(negative, DepthRange::zero_to_one), Sphere<float>{{1, 2, 3}, 9}));
}
// [P18_any]

// [conservative]
TEST_CASE("a box or sphere of which anything is in view is never left out", "[P18]")
{
  Random draw(7);
  const Camera<double> camera = scene_camera();
  const Frustum<double> f =
      frustum_planes<double>(clip_from_world(camera), DepthRange::minus_one_to_one);
  const std::array<V, 8> corners = *view_corners<double>(camera, -1, 1);
  int lost = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    // A point in view, and shapes that hold it.
    const Vector<double, 2> pixel(draw.between(1, 599), draw.between(1, 399));
    const V in_view = *unproject<double>(camera, {pixel, draw.between(-0.99, 0.99)});
    const V less = draw.in_cube(9).cwiseAbs(), more = draw.in_cube(9).cwiseAbs();
    const Eigen::AlignedBox<double, 3> box(in_view - less, in_view + more);
    const V center = in_view + draw.in_cube(9);
    const Sphere<double> sphere{center, (center - in_view).norm() * (1 + 1e-12)};
    lost += !may_see(f, box) + !may_see(f, corners, box) + !may_see(f, sphere);
  }
  CHECK(lost == 0);
}

TEST_CASE("touching the view's edge is in view, and an empty box is not", "[P18]")
{
  const Camera<double> camera = square_camera();
  const Frustum<double> f =
      frustum_planes<double>(clip_from_world(camera), DepthRange::zero_to_one);
  const Frustum<double> exact{
      {{{{0, 0, 1}, -1},
        {{0, 0, -1}, 9},
        {{1, 0, 0}, 2},
        {{-1, 0, 0}, 2},
        {{0, 1, 0}, 2},
        {{0, -1, 0}, 2}}}};
  CHECK(may_see(exact, Sphere<double>{{0, 3, -4}, 1}));
  CHECK_FALSE(may_see(exact, Sphere<double>{{0, 3, -4}, 0.999}));
  CHECK(may_see(exact, Eigen::AlignedBox<double, 3>(V(2, 0, -4), V(3, 1, -3))));
  CHECK_FALSE(may_see(exact, Eigen::AlignedBox<double, 3>(V(2.001, 0, -4), V(3, 1, -3))));
  CHECK_FALSE(may_see(f, Eigen::AlignedBox<double, 3>()));
  CHECK_FALSE(may_see(exact, Eigen::AlignedBox<double, 3>()));
}

TEST_CASE("corners leave out boxes that the planes keep, and lose none", "[P18]")
{
  const DrawnBoxes large = drawn_boxes(random_inputs / 10, 32);
  CHECK(large.lost == 0);
  CHECK(large.seen < large.by_corners);
  CHECK(large.by_corners < large.by_planes);
}
// [conservative]

TEST_CASE("an oriented box is left out exactly if all of its corners are beyond one plane", "[P18]")
{
  Random draw(9);
  const Frustum<double> f =
      frustum_planes<double>(clip_from_world(scene_camera()), DepthRange::minus_one_to_one);
  int wrong = 0, out = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    const V half = draw.in_cube(3).cwiseAbs();
    const Eigen::Quaterniond turn(draw.between(-1, 1), draw.between(-1, 1), 0.5, half.x());
    const Obb<double> box{draw.in_cube(12), turn.normalized().toRotationMatrix(), half};
    double worst = -1e300;
    for (const Plane<double>& plane : f.planes)
    {
      double least = 1e300;
      for (unsigned k = 0; k < 8; ++k)
      {
        least = std::min(least, plane.normal.dot(box.center + corner_arm(box, k)) - plane.distance);
      }
      worst = std::max(worst, least);
    }
    wrong += std::abs(worst) > 1e-12 && may_see(f, box) != (worst < 0);
    out += worst > 0;
  }
  CHECK(wrong == 0);
  CHECK(out > random_inputs / 4);
  CHECK(out < random_inputs);
}

TEST_CASE("depths from 0 to 1: 0 at the near plane, 1 at the far one, refused as −1…1 is", "[P18]")
{
  const Matrix4<double> m = *perspective_zero_to_one(1.0, 1.5, 0.5, 20.0);
  const auto depth = [&](double distance)
  {
    const Eigen::Vector4d clip = m * Eigen::Vector4d(0, 0, -distance, 1);
    return clip[2] / clip[3];
  };
  CHECK(std::abs(depth(0.5)) < 1e-15);
  CHECK(depth(20) == Catch::Approx(1).epsilon(1e-15));
  CHECK(depth(1) == Catch::Approx(20 / 19.5 * 0.5).epsilon(1e-15)); // f (1 - n / z) / (f - n)
  const Frustum<double> f = frustum_planes<double>(m, DepthRange::zero_to_one);
  CHECK(std::abs(f.planes[4].distance + 0.5) < 1e-15);
  CHECK(f.planes[5].distance == Catch::Approx(20).epsilon(1e-14));
  CHECK_FALSE(perspective_zero_to_one(1.0, 1.5, 0.0, 20.0));
  CHECK_FALSE(perspective_zero_to_one(1.0, 1.5, 2.0, 1.0));
}

TEST_CASE("each way to leave out boxes holds or fails as the table says", "[P18]")
{
  const std::string planes = "six planes", both = "planes and corners";
  check_verdicts(
      view_verdicts(), view_method_names(),
      {{"a box ahead", {planes, both}},
       {"the camera is in the box", {planes, both}},
       {"a floor under all of it", {planes, both}},
       {"behind the camera", {planes, both}},
       {"to the left, as far back as ahead", {planes, both}},
       {"a wall just beyond a far corner", {both}},
       {"across a slanted edge", {planes, both}}});
}
