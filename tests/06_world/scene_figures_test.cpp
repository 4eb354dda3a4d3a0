/// \file
/// What holds for pictures of scenes: outlines by hand, motion only where something moves.

#include "06_world/scene_figures/trial/scene_figures.hpp"
#include "06_world/scene_figures/trial/scene_outline_figures.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include "tests/catch.hpp"

#include <limits>
#include <sstream>

using namespace cookbook;

namespace
{

/// A picture from (−1, −1) to (1, 1), a hundred pixels a metre.
Projection hundred(double yaw = 0, double pitch = 0)
{
  return {picture_axes(yaw, pitch), {-1, 1}, 100, 0};
}

BodyState at(const Vector3<double>& position, const Quaternion<double>& turn = {1, 0, 0, 0})
{
  return {position, turn, {0, 0, 0}, {0, 0, 0}};
}

SceneBody small_box()
{
  return box_body("box", {0.25, 0.5, 0.125}, {0, 0, 0});
}

/// Frames at 60 Hz in which the last body of a scene rises at 1 m/s.
std::vector<Frame> rising(const Scene& scene, int count)
{
  std::vector<Frame> frames;
  for (int i = 0; i < count; ++i)
  {
    frames.push_back(first_frame(scene));
    frames.back().time = i / 60.0;
    frames.back().bodies.back().position.y() += i / 60.0;
  }
  return frames;
}

std::size_t count_of(const std::string& part, const std::string& text)
{
  std::size_t count = 0;
  for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1))
  {
    ++count;
  }
  return count;
}

/// What stands between `before` and the next quotation mark, behind `from`; empty: nothing.
std::string quoted_after(const std::string& before, const std::string& text, std::size_t& from)
{
  const std::size_t at = text.find(before, from);
  from = at == std::string::npos ? at : text.find('"', at + before.size());
  return from == std::string::npos ? ""
                                   : text.substr(at + before.size(), from - at - before.size());
}

/// Whether every element that is opened is closed, in order.
bool is_nested(const std::string& svg)
{
  std::vector<std::string> open;
  for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1))
  {
    const std::size_t end = svg.find('>', at);
    const bool closes = svg[at + 1] == '/';
    const std::size_t begin = at + (closes ? 2 : 1);
    const std::string name = svg.substr(begin, svg.find_first_of(" />", begin) - begin);
    if (closes && (open.empty() || open.back() != name))
    {
      return false;
    }
    if (closes)
    {
      open.pop_back();
    }
    else if (svg[end - 1] != '/')
    {
      open.push_back(name);
    }
  }
  return open.empty();
}

} // namespace

TEST_CASE("the picture's axes are right-handed, and yaw looks from the right", "[scene_figures]")
{
  CHECK(picture_axes(0, 0) == Matrix3<double>::Identity());
  const Matrix3<double> axes = picture_axes(0.6, 0.35);
  CHECK((axes * axes.transpose()).isIdentity(1e-15));
  CHECK(axes.determinant() == Catch::Approx(1));
  CHECK((axes(2, 0) > 0 && axes(2, 1) > 0));
}

TEST_CASE("a box from the front is one face, turned by 45 degrees about y two", "[scene_figures]")
{
  const Outline front = body_outline(small_box(), at({0, 0, 0}), hundred());
  CHECK(front == Outline{750, 1500, 1250, 1500, 1250, 500, 750, 500});
  CHECK(outline_data(front, 0) == "M75,150l50,0,0,-100,-50,0z");
  const double half = std::atan(1.0) / 2;
  const Quaternion<double> turn(std::cos(half), 0, std::sin(half), 0);
  CHECK(body_outline(small_box(), at({0, 0, 0}, turn), hundred()).size() == 16);
  CHECK(body_outline(small_box(), at({0, 0, 0}), hundred(0.6, 0.35)).size() == 24);
}

TEST_CASE("a ball is a circle with a spoke that shows its turn", "[scene_figures]")
{
  const SceneBody sphere = ball_body("ball", 0.5, {0, 0, 0});
  const Outline outline = body_outline(sphere, at({0, 0, 0}, {0, 0, 0, 1}), hundred());
  CHECK(outline == Outline{1000, 1000, 500, 1000}); // turned by 180 degrees
  CHECK(
      outline_data(outline, 500) == "M50,100a50,50 0 1 0 100,0a50,50 0 1 0 -100,0M100,100L50,100");
}

TEST_CASE("a body that is nowhere is not drawn, and does not stop the others", "[scene_figures]")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(body_outline(small_box(), at({nan, 0, 0}), hundred()).empty());
  CHECK(body_outline(small_box(), at({1e300, 0, 0}), hundred()).empty());
  CHECK(outline_data({}, 0) == "M-9,-9");
  const Scene scene = named_scene("tower_3");
  std::vector<Frame> frames = rising(scene, 60);
  frames.back().bodies.back().position.x() = nan;
  const SceneView view = view_of(scene, frames);
  CHECK((view.min.allFinite() && view.max.allFinite()));
  CHECK(is_nested(scene_animation("lost", "", scene, frames, view).svg()));
}

TEST_CASE("the view holds the bodies and 8 % around them, and is not too high", "[scene_figures]")
{
  const Scene scene = named_scene("tower_2");
  const SceneView view = view_of(scene, {first_frame(scene)});
  CHECK(view.min.y() == Catch::Approx(-0.16));
  CHECK(view.max.y() == Catch::Approx(2.16));
  CHECK(view.max.x() - view.min.x() == Catch::Approx(2.32 / 1.2));
  CHECK(view.max.x() == Catch::Approx(-view.min.x()));
}

TEST_CASE("a body that flies away is followed for 6 m", "[scene_figures]")
{
  Scene scene = named_scene("tower_1");
  std::vector<Frame> frames = rising(scene, 2);
  frames[1].bodies[1].position = {1000, 0.5, 0};
  const SceneView view = view_of(scene, frames);
  CHECK(view.max.x() == Catch::Approx(6.5 + 0.08 * 7));
}

TEST_CASE("only what moves is animated, over the time it took", "[scene_figures]")
{
  const Scene scene = named_scene("tower_3");
  const std::vector<Frame> frames = rising(scene, 121);
  const SceneView view = view_of(scene, frames);
  const std::string svg = scene_animation("tower", "a tower", scene, frames, view).svg();
  CHECK(count_of("attributeName=\"d\"", svg) == 1);
  CHECK(count_of("dur=\"2.00s\"", svg) == 2); // the cube, and the dot on the axis of time
  CHECK(
      count_of(
          "dur=\"20.00s\"",
          scene_animation("t", "", scene, frames, view, {.slowness = 10}).svg()) == 2);
  CHECK(is_nested(svg));
}

TEST_CASE("changes come in order, from the first at 0 on", "[scene_figures]")
{
  const Scene scene = named_scene("tower_1");
  const std::vector<Frame> frames = rising(scene, 601);
  const std::string svg = scene_animation("t", "", scene, frames, view_of(scene, frames)).svg();
  std::size_t at = 0;
  std::string times = quoted_after("keyTimes=\"", svg, at);
  const std::string values = quoted_after("values=\"", svg, at);
  CHECK(count_of(";", times) > 100);
  CHECK(count_of(";", times) == count_of(";", values));
  std::replace(times.begin(), times.end(), ';', ' ');
  std::istringstream stream(times);
  double last = -1;
  for (double time = 0; stream >> time; last = time)
  {
    CHECK((last < 0 ? time == 0 : time > last));
  }
  CHECK((stream.eof() && last <= 1));
}

TEST_CASE("a picture that would be too large leaves out frames", "[scene_figures][long]")
{
  const Scene scene = named_scene("pile_50");
  std::vector<Frame> frames;
  for (int i = 0; i < 300; ++i)
  {
    frames.push_back(first_frame(scene));
    frames.back().time = i / 60.0;
    for (BodyState& state : frames.back().bodies)
    {
      state.position.x() += 0.1 * i;
    }
  }
  const SceneView view = view_of(scene, frames, 480, 0.6, 0.35);
  const auto size = [&](std::size_t most)
  { return scene_animation("pile", "", scene, frames, view, {.most_bytes = most}).svg().size(); };
  CHECK(size(100'000) < 110'000);
  CHECK(size(100'000) > 50'000);
  CHECK(size(400'000) > 200'000);
}

TEST_CASE("pictures stand side by side in strips and galleries, with unlike ids", "[scene_figures]")
{
  const Scene scene = named_scene("heavy_on_light");
  const std::vector<Frame> frames = rising(scene, 121);
  const SceneView view = view_of(scene, frames, 200);
  const std::string strip = scene_strip("strip", scene, frames, {0, 1, 2}, view, 3).svg();
  CHECK((is_nested(strip) && count_of("cb-wash", strip) > 6));
  CHECK((count_of(">0 s<", strip) == 1 && count_of(">2 s<", strip) == 1));
  const std::string gallery =
      scene_gallery("gallery", scene, {{"one", frames[0]}, {"two", frames[60]}}, view, 2).svg();
  CHECK((is_nested(gallery) && count_of(">two<", gallery) == 1));
  for (const std::string& svg : {strip, gallery})
  {
    std::vector<std::string> ids;
    for (std::size_t at = 0; at != std::string::npos;)
    {
      ids.push_back(quoted_after(" id=\"", svg, at));
    }
    const std::size_t count = ids.size();
    std::sort(ids.begin(), ids.end());
    CHECK(std::unique(ids.begin(), ids.end()) == ids.begin() + std::ptrdiff_t(count));
  }
}

TEST_CASE("frames of another scene, or none, are refused", "[scene_figures]")
{
  const Scene scene = named_scene("tower_3");
  const std::vector<Frame> other{first_frame(named_scene("tower_4"))};
  CHECK_THROWS_AS(view_of(scene, other), std::invalid_argument);
  CHECK_THROWS_AS(view_of(scene, {}), std::invalid_argument);
  CHECK_THROWS_AS(
      scene_picture("t", "", scene, other[0], view_of(scene, {first_frame(scene)})),
      std::invalid_argument);
}

TEST_CASE("every named scene can be drawn, from the front and from above", "[scene_figures]")
{
  for (const std::string& name : scene_names())
  {
    const Scene scene = named_scene(name);
    const std::vector<Frame> frames{first_frame(scene)};
    INFO(name);
    for (const double angle : {0.0, 0.4})
    {
      const SceneView view = view_of(scene, frames, 480, angle, angle);
      CHECK(is_nested(scene_picture(name, name, scene, frames[0], view).svg()));
    }
  }
}
