/// \file
/// \brief What holds for the words and tables of the chart; it measures no time.

#include "03_sphere_manifolds/sphere_chart/trial/sphere_chart.hpp"

#include "tests/catch.hpp"

#include <limits>

using namespace cookbook;

namespace
{

const double infinity = std::numeric_limits<double>::infinity();

/// A rough one, the knee, a fine one, one that fails, and a peer.
std::vector<MeasuredMethod> methods()
{
  return {
      {"rough", false, {1, 1, 1}, {500, 1000}},
      {"knee", false, {2, 2, 2}, {1, 1.5}},
      {"fine", false, {8, 8, 8}, {0.01, 0.02}},
      {"broken", false, {1, 1, 1}, {0, infinity}},
      {"peer", true, {10, 20, 30}, {1, 2}}};
}

bool has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("a tenth of a radius off, or a wrong verdict, is a failure", "[sphere_chart]")
{
  CHECK_FALSE(method_fails(methods()[0]));
  CHECK(method_fails(methods()[3]));
  CHECK(method_fails({"far off", false, {}, {1, 1e6}}));
}

TEST_CASE("the sentence names the knee and what the finest method costs more", "[sphere_chart]")
{
  CHECK(
      knee_sentence(methods()) ==
      "The knee is at knee: 2 ns a pair, at most 1.5 ulp of the larger radius off; the most "
      "accurate, fine, takes 4 times as long.");
}

TEST_CASE("ratios are to the fastest peer, and a failure is called one", "[sphere_chart]")
{
  CHECK(measure::fastest_peer(methods(), 1) == 20);
  const std::string html = times_html(methods());
  CHECK(has(html, "<tr><td>knee</td><td>2</td><td>5</td><td>2</td><td>10</td><td>2</td><td>15<"));
  CHECK(has(html, "fails"));
}

TEST_CASE("without a peer the ratio is a dash", "[sphere_chart]")
{
  const std::string html = times_html({{"alone", false, {1, 1, 1}, {1, 1}}});
  CHECK(has(html, "<td>1</td><td>–</td>"));
}

TEST_CASE("60 bytes in 8 ns are 80 % of a copy that takes 6.4 ns", "[sphere_chart]")
{
  const std::string html = streams_html({{"batch", 8, 60}, {"copy", 6.4, 60}});
  CHECK(has(html, "<td>8</td><td>7.5</td><td>80 %</td>"));
  CHECK(has(html, "<td>100 %</td>"));
}
