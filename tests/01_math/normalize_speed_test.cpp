/// \file
/// What holds for the workloads that the ways to normalise are timed on.

#include "01_math/normalize_speed/trial/normalize_speed.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

// [workloads]
TEST_CASE("in a room all four ways to normalise are right within four ulps", "[room]")
{
  for (const NormalizeMethod<float>& method : normalize_methods<float>())
  {
    INFO(method.name);
    CHECK(normalize_errors(method, room_vectors()).maximum <= allowed_ulps);
  }
}

TEST_CASE("over every size of float, two of four ways lose a length", "[galaxy]")
{
  const auto methods = normalize_methods<float>();
  const std::vector<Vector3<float>> vectors = all_vectors();
  CHECK(std::isinf(normalize_errors(methods[0], vectors).maximum));
  CHECK(std::isinf(normalize_errors(methods[1], vectors).maximum));
  CHECK(normalize_errors(methods[2], vectors).maximum <= allowed_ulps);
  CHECK(normalize_errors(methods[3], vectors).maximum <= allowed_ulps);
}

TEST_CASE("a room's workload goes from a millimetre to a kilometre", "[room]")
{
  float least = 1e9f;
  float most = 0;
  for (const Vector3<float>& v : room_vectors())
  {
    least = std::min(least, v.cwiseAbs().maxCoeff());
    most = std::max(most, v.cwiseAbs().maxCoeff());
  }
  CHECK(least <= 1e-3f);
  CHECK(most <= 1e3f);
  CHECK(most >= 500);
}
// [workloads]
