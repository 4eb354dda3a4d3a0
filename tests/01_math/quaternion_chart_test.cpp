/// \file
/// What holds for the rotations that ways from matrix to quaternion are timed on.

#include "01_math/quaternion_chart/trial/quaternion_chart.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

// [quaternion_workloads]
TEST_CASE("of any rotation by w alone and four roots lose digits, quaternion_of is within 2 ulp")
{
  for (const int most : {60, 1})
  {
    const std::vector<KnownRotation> rotations = known_rotations(most);
    CHECK(rotations.size() == 2000);
    const auto ours = [](const Matrix3<float>& r) { return quaternion_of(r); };
    const auto eigens = [](const Matrix3<float>& r) { return Quaternion<float>(r); };
    const auto by_w = [](const Matrix3<float>& r) { return quaternion_by_w(r); };
    CHECK(quaternion_errors(ours, rotations).maximum <= 2);
    CHECK(quaternion_errors(eigens, rotations).maximum <= 3);
    CHECK(std::isinf(quaternion_errors(by_w, rotations).maximum));
    CHECK(quaternion_errors(quaternion_by_roots, rotations).maximum > 1000);
  }
}

TEST_CASE("the second workload is near half turns: w is 1 at most where others go to 60")
{
  int half_turns = 0, largest = 0;
  for (const KnownRotation& one : known_rotations(1))
  {
    CHECK(std::abs(one.whole[0]) <= 1);
    half_turns += one.whole[0] == 0;
    largest = std::max(largest, one.whole.cwiseAbs().maxCoeff());
  }
  CHECK(half_turns > 500);
  CHECK(largest == 60);
}

TEST_CASE("an error is counted in ulps of one, and either sign of the quaternion is right")
{
  const Eigen::Vector4i whole(1, 1, 1, 1);
  const float off = 0.5f + 0x1p-22f;
  CHECK(quaternion_error({0.5f, 0.5f, 0.5f, off}, whole) == 2);
  CHECK(quaternion_error({-0.5f, -0.5f, -0.5f, -off}, whole) == 2);
  CHECK(std::isinf(quaternion_error({0.5f, 0.5f, 0.5f, 0.6f}, whole)));
  CHECK(std::isinf(quaternion_error({NAN, 0.5f, 0.5f, 0.5f}, whole)));
}
// [quaternion_workloads]
