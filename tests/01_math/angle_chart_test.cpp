/// \file
/// What holds for the workload that the ways to find an angle are timed on.

#include "01_math/angle_chart/trial/angle_chart.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

TEMPLATE_TEST_CASE(
    "half of the workload's angles are below a tenth, a quarter above 2", "[angles]", float, double)
{
  int small = 0, large = 0;
  for (const VectorPair<TestType>& pair : angle_workload<TestType>(1000))
  {
    const long double angle = true_angle(pair);
    small += angle < 0.1L ? 1 : 0;
    large += angle > 2 ? 1 : 0;
    CHECK(angle > 0);
  }
  CHECK(small > 450);
  CHECK(large > 200);
}

TEMPLATE_TEST_CASE(
    "the arc cosine has no digit right somewhere, the recommended way has all", "[angles]", float,
    double)
{
  const auto pairs = angle_workload<TestType>(1000);
  const double roundoff = static_cast<double>(std::numeric_limits<TestType>::epsilon()) / 2;
  for (const AngleMethod<TestType>& method : angle_methods<TestType>())
  {
    INFO(method.name);
    const bool cosine = method.name == "as published" || method.name == "clamped";
    const double error = angle_errors(method, pairs).maximum;
    CHECK(cosine == !(error < 0.1));
    CHECK((method.name == "recommended") == (error <= allowed_roundings * roundoff));
  }
}
