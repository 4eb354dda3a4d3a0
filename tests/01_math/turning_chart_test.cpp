/// \file
/// What holds for the spin that ways to turn are timed on.

#include "01_math/turning_chart/trial/turning_chart.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

// [million]
TEST_CASE("after a million frames turned_by is within 0.01 rad, and length one to 1e-6")
{
  const std::vector<Vector3<float>> spins = changing_spin();
  const Quaternion<double> right = true_end(spins, 15625);
  const auto end = [&](auto way)
  { return spin_end(after_rounds(Quaternion<float>(1, 0, 0, 0), spins, 15625, way)); };
  const SpinEnd ours = end(turned_by<float>);
  CHECK(drift(ours, right) <= 0.01);
  CHECK(std::abs(ours.length - 1) <= 1e-6);
  CHECK(drift(end(quaternion_added_and_normalised<float>), right) > 0.1);
  CHECK_FALSE(drift(end(quaternion_added<float>), right) <= 4);
}
// [million]

TEST_CASE("a steady quarter turn in 64 frames is where the truth ends, and drift is its angle")
{
  const float quarter = 60 * 1.5707964f / 64;
  const std::vector<Vector3<float>> spins(64, Vector3<float>(0, quarter, 0));
  const double root = std::sqrt(0.5);
  const Quaternion<double> right = true_end(spins, 1), half = true_end(spins, 2);
  CHECK(std::abs(right.w() - root) <= 1e-6);
  CHECK(std::abs(right.y() - root) <= 1e-6);
  CHECK(std::abs(half.y() - 1) <= 1e-6);
  CHECK(std::abs(drift({right, 1}, half) - 1.570796) <= 1e-6);
  CHECK(drift({half, 1.25}, half) == 0.25);
  CHECK(changing_spin().size() == 64);
}
