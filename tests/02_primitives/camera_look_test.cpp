/// \file
/// What holds for a camera that looks at something, wherever it stands.

#include "02_primitives/camera/look_at.hpp"
#include "02_primitives/camera/trial/look_cases.hpp"
#include "common/math/rotation.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/random_numbers.hpp"
#include "tests/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace cookbook;

namespace
{

using V = Vector3<double>;

} // namespace

// [look_at_by_hand]
TEST_CASE("from (0,3,4) to the origin: right is +x, up (0,4/5,-3/5), back (0,3/5,4/5)", "[camera]")
{
  const Isometry3<double> pose = look_at<double>({0, 3, 4}, {0, 0, 0}, {0, 1, 0});
  Matrix3<double> axes;
  axes << V(1, 0, 0), V(0, 0.8, -0.6), V(0, 0.6, 0.8);
  CHECK((pose.linear() - axes).cwiseAbs().maxCoeff() <= 4 * 0x1p-53);
  CHECK(pose.translation() == V(0, 3, 4));
  // The target is 5 m ahead, along −z.
  CHECK((to_local<double>(pose, V(0, 0, 0)) - V(0, 0, -5)).norm() <= 1e-14);
}
// [look_at_by_hand]

// [look_at_degenerate]
TEMPLATE_TEST_CASE("a camera without a direction, or without an up", "[camera]", float, double)
{
  using V3 = Vector3<TestType>;
  const auto axes = [](const V3& eye, const V3& target, const V3& up) -> Matrix3<TestType>
  { return look_at<TestType>(eye, target, up).linear(); };
  const V3 eye(1, 2, 3), y(0, 1, 0), zero(0, 0, 0);
  Matrix3<TestType> down;
  down << V3(1, 0, 0), V3(0, 0, -1), V3(0, 1, 0);
  CHECK(axes(eye, eye, y) == Matrix3<TestType>::Identity());
  CHECK(axes(eye, eye, zero) == Matrix3<TestType>::Identity());
  CHECK(axes(eye, V3(1, 0, 3), y) == down);
  CHECK(axes(eye, V3(1, 0, 3), zero) == down);
  CHECK(axes(eye, V3(1, 2, 0), V3(0, 0, 7)) == Matrix3<TestType>::Identity());
}

TEMPLATE_TEST_CASE(
    "every camera has a rotation that looks at its target with up upwards", "[camera]", float,
    double)
{
  using V3 = Vector3<TestType>;
  Random draw(7);
  const TestType u = std::numeric_limits<TestType>::epsilon();
  TestType worst = 0, aside = 0, below = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    // Every size from 1e-30 to 1e30, and ups that are nearly parallel to the view.
    const auto size = [&] { return std::pow(10.0, std::round(draw.between(-30, 30))); };
    const double of_eye = size(), of_up = size(), tilt = std::pow(10.0, draw.between(-12, 0));
    const V3 eye = (draw.in_cube(1) * of_eye).template cast<TestType>();
    const V3 target = (draw.in_cube(1) * of_eye).template cast<TestType>();
    const V ahead = (target.template cast<double>() - eye.template cast<double>()) / of_eye;
    const V3 up = ((ahead + tilt * draw.in_cube(1)) * of_up).template cast<TestType>();
    const Matrix3<TestType> axes = look_at<TestType>(eye, target, up).linear();
    REQUIRE(axes.allFinite());
    worst = std::max(worst, rotation_error(axes));
    const V back = axes.col(2).template cast<double>(), unit = ahead.normalized();
    aside = std::max(aside, static_cast<TestType>((back + unit).cwiseAbs().maxCoeff()));
    const V scaled_up = (up.template cast<double>() / of_up);
    below =
        std::max(below, static_cast<TestType>(-axes.col(1).template cast<double>().dot(scaled_up)));
  }
  CHECK(worst <= 4 * u);
  CHECK(aside <= 4 * u);
  CHECK(below <= 8 * u);
}
// [look_at_degenerate]

TEST_CASE("each way to turn a camera holds or fails as the table says", "[camera]")
{
  const std::string bare = "unguarded", bound = "threshold", best = "recommended";
  check_verdicts(
      look_verdicts(), names_of(look_methods()),
      {{"level, ahead", {bare, bound, best}},
       {"eye at the target", {best}},
       {"straight down", {bound, best}},
       {"nearly straight down", {bare, best}},
       {"nearly parallel, on a slant", {best}},
       {"up is zero", {best}},
       {"1e-25 m from the target", {best}},
       {"1e25 m from the target", {best}}});
}
