/// \file
/// \brief What holds for the words and tables of the chart; it measures no time.

#include "03_sphere_manifolds/sphere_chart/trial/sphere_chart.hpp"

#include "tests/catch.hpp"

#include <limits>

using namespace cookbook;

namespace
{

const double infinity = std::numeric_limits<double>::infinity();

/// A rough one, a peer, and one that is wrong about touching.
std::vector<MeasuredMethod> methods()
{
  const auto timed = [](const std::string& name, double ns, bool peer) {
    return measure::TimingRow(3, {name, ns, ns, peer});
  };
  return {
      {timed("rough", 1, false), {500, 1000}},
      {timed("peer", 10, true), {1, 2}},
      {timed("broken", 1, false), {0, infinity}}};
}

bool has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("ratios are to the fastest peer, and a wrong verdict is a failure", "[sphere_chart]")
{
  const std::string html = html_table(methods_table(methods()));
  CHECK(has(html, "<td>rough</td><td>1</td><td>10</td><td>1</td><td>10</td><td>1</td><td>10</td>"));
  CHECK(has(html, "<td>500</td><td>1000</td>"));
  CHECK(has(html, "<td>0</td><td>fails</td>"));
}

TEST_CASE("60 bytes in 8 ns are 80 % of a copy that takes 6.4 ns", "[sphere_chart]")
{
  const std::string html = html_table(streams_table({{"batch", 8, 8}, {"copy", 6.4, 6.4}}, 60));
  CHECK(has(html, "<td>8</td><td>7.5</td><td>80 %</td>"));
  CHECK(has(html, "<td>100 %</td>"));
}
