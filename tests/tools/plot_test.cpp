#include "tests/catch.hpp"
#include "tools/plot/charts/bar_chart.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/charts/chart_layout.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/figures/figure3d.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace cookbook::plot;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-12; // a handful of double operations on numbers up to 1000
const View view{{-2, -1}, {2, 1}, 400};

std::size_t count(const std::string& text, const std::string& part)
{
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++found;
  }
  return found;
}

/// What an action is refused with; empty if it is not.
template <class Action>
std::string refusal(Action action)
{
  try
  {
    action();
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return "";
}

std::vector<std::string> ids(const std::string& svg)
{
  std::vector<std::string> found;
  for (std::size_t at = svg.find(" id=\""); at != std::string::npos;
       at = svg.find(" id=\"", at + 1))
  {
    found.push_back(svg.substr(at + 5, svg.find('"', at + 5) - at - 5));
  }
  return found;
}

bool any_overlap(const std::vector<Rect>& boxes)
{
  for (std::size_t p = 0; p < boxes.size(); ++p)
  {
    for (std::size_t q = p + 1; q < boxes.size(); ++q)
    {
      if (overlap(boxes[p], boxes[q]))
      {
        return true;
      }
    }
  }
  return false;
}

/// Twelve methods, five of them within a few pixels of each other.
Chart crowded_chart(const std::string& name)
{
  Chart chart(name, "Cost against error", {"time [ns]", Scale::log}, {"error [m]", Scale::log});
  const std::vector<std::pair<std::string, Vector2d>> points{
      {"float", {11, 2e-7}},        {"double", {14, 3e-16}},      {"normalised", {16, 2.8e-16}},
      {"scaled", {19, 1.2e-16}},    {"fma", {13, 2.2e-16}},       {"pack of 4", {4.1, 2.1e-7}},
      {"pack of 8", {2.9, 2.4e-7}}, {"interval", {55, 1e-16}},    {"8 steps", {180, 1e-6}},
      {"32 steps", {420, 3e-12}},   {"another one", {260, 4e-5}}, {"rational", {9000, 0}}};
  std::vector<Vector2d> front;
  for (const auto& [label, at] : points)
  {
    chart.whisker(label, at.x(), at.y() / 5, at.y());
    front.push_back(at);
  }
  return chart.front(front).fails("naive: NaN", 9).fails("acos: 1 % too deep", 21);
}

Figure3d one_box(const Camera& camera)
{
  return Figure3d("box", "", camera).box({0, 0, 0}, Matrix3d::Identity(), {1, 2, 3}, Ink::a);
}

} // namespace

TEST_CASE("a number has two decimals, rounds halves away from zero and is never -0.00", "[plot]")
{
  CHECK(svg::number(0) == "0.00");
  CHECK(svg::number(-0.001) == "0.00");
  CHECK(svg::number(-0.0) == "0.00");
  CHECK(svg::number(1.5) == "1.50");
  CHECK(svg::number(0.125) == "0.13");
  CHECK(svg::number(-0.125) == "-0.13");
  CHECK(svg::number(-12.349) == "-12.35");
  CHECK(svg::number(1e6) == "1000000.00");
}

TEST_CASE("the last bit of a tie does not change a number", "[plot]")
{
  CHECK(svg::number(std::nextafter(0.125, 0)) == svg::number(0.125));
  CHECK(svg::number(std::nextafter(0.125, 1)) == svg::number(0.125));
}

TEST_CASE("NaN, infinity and numbers beyond 1e9 are refused", "[plot]")
{
  CHECK_THROWS_AS(svg::number(not_a_number), std::invalid_argument);
  CHECK_THROWS_AS(svg::number(-infinite), std::invalid_argument);
  CHECK_THROWS_AS(svg::number(2e9), std::invalid_argument);
}

TEST_CASE("a text that XML reserves is escaped, in texts and in attributes", "[plot]")
{
  CHECK(svg::escaped("a<b & \"c\" > 'd'\n") == "a&lt;b &amp; &quot;c&quot; &gt; &#39;d&#39; ");
  const std::string svg = Figure2d("f", "x < y & z", view).label({0, 0}, "<script>").svg();
  CHECK(count(svg, "<script>") == 0);
  CHECK(count(svg, "&lt;script&gt;") == 1);
  CHECK(count(svg, "<title id=\"f-title\">x &lt; y &amp; z</title>") == 1);
}

TEST_CASE("superscripts and subscripts split a text, a lone underscore does not", "[plot]")
{
  const std::vector<TextRun> runs = text_runs("10^{−3} v_{n} sphere_box");
  REQUIRE(runs.size() == 5);
  CHECK(runs[1].text == "−3");
  CHECK(runs[1].shift == 1);
  CHECK(runs[3].text == "n");
  CHECK(runs[3].shift == -1);
  CHECK(runs[4].text == " sphere_box");
  CHECK(text_runs("open _{brace").size() == 1);
}

TEST_CASE("a wrapped text keeps its words and its width", "[plot]")
{
  const std::vector<std::string> lines = wrapped("one two three four five six", 14, 90);
  std::string joined;
  for (const std::string& line : lines)
  {
    CHECK(text_width(line, 14) <= 90);
    joined += (joined.empty() ? "" : " ") + line;
  }
  CHECK(lines.size() > 1);
  CHECK(joined == "one two three four five six");
  CHECK(wrapped("", 14, 90).empty());
}

TEST_CASE("linear ticks from 0 to 10 in five steps are 0, 2, 4, 6, 8, 10", "[plot]")
{
  std::vector<std::string> texts;
  for (const Tick& tick : linear_ticks(0, 10, 5))
  {
    texts.push_back(tick.text);
  }
  CHECK(texts == std::vector<std::string>{"0", "2", "4", "6", "8", "10"});
  const std::vector<Tick> signed_ticks = linear_ticks(-0.2, 0.2, 4);
  REQUIRE(signed_ticks.size() == 5);
  CHECK(signed_ticks[0].text == "−0.2");
  CHECK(signed_ticks[2].text == "0");
  CHECK(linear_ticks(1, 1, 5).empty());
}

TEST_CASE("log ticks name powers of ten and leave 2 to 9 between them unnamed", "[plot]")
{
  const std::vector<Tick> ticks = log_ticks(1e-8, 1e-6, 5);
  REQUIRE(ticks.size() == 19); // three powers and eight between each two
  CHECK(ticks[0].text == "10^{−8}");
  CHECK(ticks[1].text.empty());
  CHECK(ticks[9].text == "10^{−7}");
  CHECK(ticks[18].text == "10^{−6}");
  CHECK(log_ticks(1, 100, 5)[9].text == "10");
}

TEST_CASE("log ticks over sixteen decades name one in four at most", "[plot]")
{
  int named = 0;
  for (const Tick& tick : log_ticks(1e-16, 1, 5))
  {
    named += tick.text.empty() ? 0 : 1;
  }
  CHECK(named == 5); // 10^-16, -12, -8, -4, 0
}

TEST_CASE("a log axis from 20 to 80 still has two names", "[plot]")
{
  std::vector<std::string> named;
  for (const Tick& tick : log_ticks(20, 80, 5))
  {
    if (!tick.text.empty())
    {
      named.push_back(tick.text);
    }
  }
  CHECK(named == std::vector<std::string>{"20", "50"});
}

TEST_CASE("significant digits come without trailing zeros, -0 or e", "[plot]")
{
  CHECK(significant(0.25, 3) == "0.25");
  CHECK(significant(-0.0, 3) == "0");
  CHECK(significant(-41.96, 3) == "−42");
  CHECK(significant(3e-7, 3) == "3·10^{−7}");
  CHECK(significant(1e9, 3) == "10^{9}");
}

TEST_CASE("labels in a crowded chart do not overlap", "[plot]")
{
  const std::vector<Rect> boxes = crowded_chart("crowd").label_boxes();
  CHECK(boxes.size() == 13); // twelve points and the front
  CHECK_FALSE(any_overlap(boxes));
}

TEST_CASE("twenty labels about one point do not overlap and stay within bounds", "[plot]")
{
  std::vector<Label> labels;
  Obstacles obstacles;
  for (int k = 0; k < 20; ++k)
  {
    const Vector2d at(200 + k % 5, 150 + k / 5);
    labels.push_back({at, 8, "label " + std::to_string(k)});
    obstacles.rects.push_back({at.x() - 4, at.y() - 4, at.x() + 4, at.y() + 4});
  }
  std::vector<Rect> boxes;
  for (const PlacedLabel& place : place_labels(labels, obstacles, {0, 0, 400, 300}))
  {
    boxes.push_back(place.box);
    CHECK(place.box.left >= 0);
    CHECK(place.box.top >= 0);
    CHECK(place.box.right <= 400);
    CHECK(place.box.bottom <= 300);
  }
  CHECK_FALSE(any_overlap(boxes));
}

TEST_CASE("a label keeps the side it asks for where there is room", "[plot]")
{
  const Rect bounds{0, 0, 400, 300};
  const Label below{{200, 150}, 8, "here", Side::below};
  const Label left{{200, 150}, 8, "here", Side::left};
  CHECK(place_labels({below}, {}, bounds).front().box.top >= 158 - rounding);
  CHECK(place_labels({left}, {}, bounds).front().box.right <= 192 + rounding);
}

TEST_CASE("names of failing methods share no row with a text or point they would cover", "[plot]")
{
  const std::vector<FailureSlot> slots =
      failure_slots({"first method", "second method", "last"}, {100, 120, 300}, 400);
  CHECK(slots[1].row == 0);
  CHECK(slots[0].row == 1);
  CHECK(slots[2].row == 0);
  CHECK(failure_slots({"at the right edge"}, {390}, 400).front().to_left);
}

TEST_CASE("names that want one height come to stand a line apart", "[plot]")
{
  const std::vector<double> heights = spread({100, 100, 300}, 18, 0, 400);
  CHECK(std::abs(heights[1] - heights[0]) >= 18 - 1e-6); // the sweeps converge geometrically
  CHECK(heights[2] == 300);
}

TEST_CASE("no two of the first 64 series share colour and marker", "[plot]")
{
  std::set<std::pair<Ink, Marker>> looks;
  for (std::size_t i = 0; i < 64; ++i)
  {
    looks.insert({series_look(i).ink, series_look(i).marker});
  }
  CHECK(looks.size() == 64);
}

TEST_CASE("of four points, one beaten and one equalled at less cost, two are ringed", "[plot]")
{
  Chart chart("c", "", {"x"}, {"y"});
  chart.front({{1, 2}, {2, 2}, {3, 1}, {4, 3}});
  CHECK(count(chart.svg(), "<circle") == 2);
}

TEST_CASE("two texts that would stand 6 pixels apart in one row do not read as one", "[plot]")
{
  const double width = text_width("text", text_size);
  const Label first{{20, 100}, 4, "text", Side::right};
  const Label second{{20 + 4 + width + 6 + width + 4, 100}, 4, "text", Side::left};
  const auto places = place_labels({first, second}, {}, {0, 0, 200, 200});
  const Rect p = places[0].box, q = places[1].box;
  CHECK((q.left - p.right >= 10 || p.bottom <= q.top || q.bottom <= p.top));
}

TEST_CASE("a circle stays a circle: one world unit is 100 pixels along both axes", "[plot]")
{
  const Figure2d figure("f", "", view);
  CHECK((figure.to_pixels({0, 0}) - Vector2d(200, 100)).norm() <= rounding);
  CHECK((figure.to_pixels({1, 0}) - Vector2d(300, 100)).norm() <= rounding);
  CHECK((figure.to_pixels({0, 1}) - Vector2d(200, 0)).norm() <= rounding);
  const std::string svg = Figure2d(figure).circle({0, 0}, 0.5, Ink::a).svg();
  CHECK(count(svg, "cx=\"200.00\" cy=\"100.00\" r=\"50.00\"") == 1);
}

TEST_CASE("the lens of unit spheres 1 apart has its corners at height sqrt(3)/2", "[plot]")
{
  // Corners at (1/2, ±0.8660): pixels (250, 100 ∓ 86.60).
  const std::string svg = Figure2d("f", "", view).lens({0, 0}, 1, {1, 0}, 1).svg();
  CHECK(count(svg, "M250.00,13.40A100.00 100.00 0 0 1 250.00,186.60") == 1);
  const std::string apart = Figure2d("f", "", view).lens({-1, 0}, 0.5, {1, 0}, 0.5).svg();
  CHECK(apart == Figure2d("f", "", view).svg());
}

TEST_CASE("the camera turns known points as by hand", "[plot]")
{
  const double right_angle = std::acos(-1.0) / 2;
  const Figure3d front("f", "", {0, 0, 480, 360});
  CHECK((front.to_camera({1, 2, 3}) - Vector3d(1, 2, 3)).norm() <= rounding);
  // From +x: z runs to the left, x towards the viewer.
  const Figure3d side("f", "", {right_angle, 0, 480, 360});
  CHECK((side.to_camera({1, 2, 3}) - Vector3d(-3, 2, 1)).norm() <= rounding);
  // From above: z runs down the picture, y towards the viewer.
  const Figure3d above("f", "", {0, right_angle, 480, 360});
  CHECK((above.to_camera({1, 2, 3}) - Vector3d(1, -3, 2)).norm() <= rounding);
  // Yaw 45°: (1, 0, 1) lies straight ahead, sqrt(2) near.
  const Figure3d corner("f", "", {right_angle / 2, 0, 480, 360});
  CHECK((corner.to_camera({1, 0, 1}) - Vector3d(0, 0, std::sqrt(2.0))).norm() <= rounding);
}

TEST_CASE("a box in general view hides 3 of its 12 edges and shows 3 of its 6 faces", "[plot]")
{
  const Panel panel = one_box({0.6, 0.35, 480, 360}).panel("box");
  CHECK(count(panel.body, "stroke-dasharray") == 3);
  CHECK(count(panel.body, "cb-line cb-a") == 12);
  CHECK(count(panel.body, "cb-fill cb-a") == 3);
}

TEST_CASE("a box seen face-on shows one face", "[plot]")
{
  const Panel panel = one_box({0, 0, 480, 360}).panel("box");
  CHECK(count(panel.body, "cb-fill cb-a") == 1);
}

TEST_CASE("a small box on a large one is drawn after it, wherever it stands", "[plot]")
{
  // At the far end its centre is farther away than the large box's.
  const Matrix3d upright = Matrix3d::Identity();
  for (const double z : {-4.0, 0.0, 4.0})
  {
    const Object large = box_object({0, -0.5, 0}, upright, {5, 0.5, 5}, Ink::a);
    const Object small = box_object({0, 0.5, z}, upright, {0.5, 0.5, 0.5}, Ink::b);
    // Seen from above in front: turn about x by 0.4.
    const Figure3d camera("f", "", {0, 0.4, 480, 360});
    const auto turned = [&camera](Object object)
    {
      for (Vector3d& point : object.hull)
      {
        point = camera.to_camera(point);
      }
      for (FacePlane& plane : object.planes)
      {
        plane.normal = camera.to_camera(plane.normal);
      }
      return object;
    };
    CHECK(far_to_near({turned(small), turned(large)}) == std::vector<std::size_t>{1, 0});
  }
}

TEST_CASE("the same calls give the same bytes", "[plot]")
{
  CHECK(crowded_chart("c").svg() == crowded_chart("c").svg());
  CHECK(
      one_box({}).sphere({1, 1, 1}, 1, Ink::b).svg() ==
      one_box({}).sphere({1, 1, 1}, 1, Ink::b).svg());
}

TEST_CASE("ids are unique in a grid and differ between figures", "[plot]")
{
  const Figure3d ball = Figure3d("ball", "").sphere({0, 0, 0}, 1, Ink::a);
  Grid grid("grid", "Two of each", 2);
  grid.add(ball).add(ball).add(crowded_chart("c")).add(crowded_chart("c"));
  std::vector<std::string> all = ids(grid.svg());
  for (const std::string& id : ids(crowded_chart("chart").svg() + Figure2d("f", "", view).svg()))
  {
    all.push_back(id);
  }
  CHECK(all.size() > 8);
  CHECK(std::set<std::string>(all.begin(), all.end()).size() == all.size());
}

TEST_CASE("every reference to an id leads to one", "[plot]")
{
  const std::string svg = Figure3d("ball", "").sphere({0, 0, 0}, 1, Ink::a).svg();
  const std::vector<std::string> known = ids(svg);
  CHECK(count(svg, "url(#ball-shade-a)") == 1);
  CHECK(std::count(known.begin(), known.end(), "ball-shade-a") == 1);
  CHECK(std::count(known.begin(), known.end(), "ball-clip") == 1);
}

TEST_CASE("a figure says what it shows and scales with its page", "[plot]")
{
  const std::string svg = Figure2d("f", "Title", view).describe("Two spheres.").svg();
  CHECK(count(svg, "role=\"img\" aria-labelledby=\"f-title f-desc\"") == 1);
  CHECK(count(svg, "<desc id=\"f-desc\">Two spheres.</desc>") == 1);
  CHECK(count(svg, "viewBox=\"0 0 424.00") == 1);
  CHECK(count(svg, "max-width:100%") == 1);
}

TEST_CASE("NaN is refused by every element, which the message names", "[plot]")
{
  Figure2d plane("plane", "", view);
  CHECK(count(refusal([&] { plane.circle({not_a_number, 0}, 1, Ink::a); }), "plane circle") == 1);
  CHECK(count(refusal([&] { plane.circle({0, 0}, not_a_number, Ink::a); }), "plane circle") == 1);
  CHECK(count(refusal([&] { plane.box({0, 0}, 0, {infinite, 1}, Ink::a); }), "plane box") == 1);
  CHECK(count(refusal([&] { plane.arrow({0, 0}, {not_a_number, 1}); }), "plane arrow") == 1);
  CHECK(count(refusal([&] { plane.label({0, not_a_number}, "x"); }), "plane label") == 1);
  CHECK(count(refusal([&] { plane.polygon({{0, not_a_number}}, Ink::a); }), "plane polygon") == 1);
  CHECK(count(refusal([&] { plane.grid(not_a_number); }), "plane grid") == 1);
  Figure3d space("space", "");
  CHECK(
      count(
          refusal(
              [&] {
                space.sphere({0, 0, not_a_number}, 1, Ink::a);
              }),
          "space sphere") == 1);
  CHECK(count(refusal([&] { space.point({0, infinite, 0}); }), "space point") == 1);
  CHECK(
      count(
          refusal(
              [&] {
                space.box({0, 0, 0}, Matrix3d::Constant(not_a_number), {1, 1, 1}, Ink::a);
              }),
          "space box") == 1);
  Chart chart("chart", "", {"x"}, {"y"});
  CHECK(count(refusal([&] { chart.point("p", {0, not_a_number}); }), "chart point p") == 1);
  CHECK(count(refusal([&] { chart.line("l", {{0, 1}, {infinite, 1}}); }), "chart line l") == 1);
  CHECK(
      count(refusal([&] { BarChart("bars", "", {"v"}).bar("b", not_a_number); }), "bars bar b") ==
      1);
}

TEST_CASE(
    "a negative value has no place on a logarithmic axis, a zero stands on its floor", "[plot]")
{
  Chart chart("c", "", {"x", Scale::log}, {"y", Scale::log});
  CHECK_THROWS_AS(chart.point("p", {1, -1e-9}), std::invalid_argument);
  CHECK_THROWS_AS(chart.point("p", {0, 1}), std::invalid_argument);
  CHECK_NOTHROW(chart.point("exact", {1, 0}).point("other", {2, 1e-3}).svg());
}

TEST_CASE("a name that cannot be an id and a view without area are refused", "[plot]")
{
  CHECK_THROWS_AS(Figure2d("two words", "", view), std::invalid_argument);
  CHECK_THROWS_AS(Figure3d("", ""), std::invalid_argument);
  CHECK_THROWS_AS(Figure2d("f", "", {{1, 0}, {1, 1}, 400}), std::invalid_argument);
  CHECK_THROWS_AS(Grid("g", "", 0), std::invalid_argument);
}

TEST_CASE("empty figures and charts are drawn, too", "[plot]")
{
  CHECK_NOTHROW(Figure2d("f", "", view).svg());
  CHECK_NOTHROW(Figure3d("f", "").svg());
  CHECK_NOTHROW(Chart("c", "", {"x", Scale::log}, {"y"}).svg());
  CHECK_NOTHROW(BarChart("b", "", {"v"}).svg());
  CHECK_NOTHROW(Grid("g", "", 2).svg());
}

TEST_CASE("a figure that stands alone takes no colour from a CSS variable", "[plot]")
{
  std::istringstream rules{std::string(style_sheet())};
  int coloured = 0;
  for (std::string rule; std::getline(rules, rule);)
  {
    coloured += rule.rfind(".cookbook-figure .cb-overlap{color:#", 0) == 0 ? 1 : 0;
    CHECK((rule.find("var(") == std::string::npos || rule.rfind("html.", 0) == 0));
  }
  CHECK(coloured == 2); // light and dark
}
