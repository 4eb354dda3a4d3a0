/// \file
/// What holds for scene files: every value is read as written, every error has its line.

#include "06_world/scenes/trial/scene_file.hpp"
#include "06_world/scenes/trial/scene_json_file.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include "tests/catch.hpp"

#include <fstream>
#include <sstream>

#include <unistd.h>

using namespace cookbook;

namespace
{

/// A scene with everything that can be given; each line has what its errors are about.
const std::vector<std::string> good{
    /* 1 */ "{",
    /* 2 */ "  \"gravity\": [0, -1.62, 0],",
    /* 3 */ "  \"step\": 0.01,",
    /* 4 */ "  \"duration\": 5,",
    /* 5 */ "  \"friction\": 0.25,",
    /* 6 */ "  \"restitution\": 0.5,",
    /* 7 */ "  \"bodies\": [",
    /* 8 */
    "    {\"name\": \"floor\", \"shape\": \"plane\", \"normal\": [0, 1, 0], \"offset\": -2},",
    /* 9 */ "    {",
    /* 10 */ "      \"name\": \"crate\",",
    /* 11 */ "      \"shape\": \"box\",",
    /* 12 */ "      \"half_extents\": [1, 0.5, 2],",
    /* 13 */ "      \"mass\": 3,",
    /* 14 */ "      \"position\": [1, 2, 3],",
    /* 15 */ "      \"orientation\": [0.6, 0, 0.8, 0],",
    /* 16 */ "      \"velocity\": [4, 5, 6],",
    /* 17 */ "      \"angular_velocity\": [7, 8, 9],",
    /* 18 */ "      \"friction\": 0.75,",
    /* 19 */ "      \"restitution\": 0",
    /* 20 */ "    },",
    /* 21 */ "    {\"name\": \"ball\", \"shape\": \"sphere\", \"radius\": 0.1, \"mass\": 0}",
    /* 22 */ "  ]",
    /* 23 */ "}"};

std::string joined(const std::vector<std::string>& lines)
{
  std::string text;
  for (const std::string& line : lines)
  {
    text += line + "\n";
  }
  return text;
}

Scene scene_of(const std::string& text)
{
  std::istringstream stream(text);
  return read_scene(stream, "moon.json");
}

/// What the scene is answered with whose line, from one, is replaced; empty: it is read.
std::string answer(std::size_t line, const std::string& instead)
{
  std::vector<std::string> lines = good;
  lines[line - 1] = instead;
  try
  {
    scene_of(joined(lines));
  }
  catch (const SceneError& error)
  {
    return error.what();
  }
  return "";
}

bool same(const SceneBody& a, const SceneBody& b)
{
  return a.name == b.name && shape_json(a) == shape_json(b) && a.mass == b.mass &&
         a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs() &&
         a.velocity == b.velocity && a.angular_velocity == b.angular_velocity &&
         a.friction == b.friction && a.restitution == b.restitution && a.damping == b.damping &&
         a.angular_damping == b.angular_damping && a.motion == b.motion;
}

} // namespace

TEST_CASE("every value of a scene file is read as it is written", "[scene_file]")
{
  const Scene scene = scene_of(joined(good));
  CHECK(scene.name == "moon");
  CHECK(scene.gravity == Vector3<double>(0, -1.62, 0));
  CHECK((scene.step == 0.01 && scene.duration == 5));
  REQUIRE(scene.bodies.size() == 3);
  const auto& floor = std::get<PlaneShape>(scene.bodies[0].shape);
  CHECK((floor.normal == Vector3<double>(0, 1, 0) && floor.offset == -2));
  CHECK((scene.bodies[0].mass == 0 && scene.bodies[0].friction == 0.25));
  const SceneBody& crate = scene.bodies[1];
  CHECK(std::get<BoxShape>(crate.shape).half_extents == Vector3<double>(1, 0.5, 2));
  CHECK((crate.mass == 3 && crate.friction == 0.75 && crate.restitution == 0));
  CHECK(crate.position == Vector3<double>(1, 2, 3));
  CHECK(crate.orientation.coeffs() == Quaternion<double>(0.6, 0, 0.8, 0).coeffs());
  CHECK(crate.velocity == Vector3<double>(4, 5, 6));
  CHECK(crate.angular_velocity == Vector3<double>(7, 8, 9));
  CHECK(std::get<SphereShape>(scene.bodies[2].shape).radius == 0.1);
  CHECK((scene.bodies[2].name == "ball" && scene.bodies[2].restitution == 0.5));
}

TEST_CASE(
    "the example has a pivot turned by 45 degrees, and on it a plank and a crate", "[scene_file]")
{
  const std::filesystem::path here = std::filesystem::path(__FILE__).parent_path();
  const Scene scene = read_scene(here / "../../recipes/06_world/game_world/seesaw.json");
  CHECK((scene.name == "seesaw" && scene.duration == 4));
  REQUIRE(scene.bodies.size() == 5);
  CHECK(
      std::acos(scene.bodies[1].orientation.w()) == Catch::Approx(std::atan(1) / 2).epsilon(1e-3));
  // The plank lies on the pivot's upper edge, 0.2 √2 m above its centre, and the crate on the
  // plank.
  const double edge = 0.2 + 0.2 * std::sqrt(2.0);
  CHECK(scene.bodies[2].position.y() - 0.05 == Catch::Approx(edge).margin(1e-4));
  CHECK(scene.bodies[3].position.y() - scene.bodies[2].position.y() == Catch::Approx(0.25));
  CHECK((scene.bodies[4].name == "ball" && scene.bodies[4].restitution == 0.2));
}

TEST_CASE(
    "what a file leaves out is as scene.hpp has it: 60 Hz, 10 s, friction 0.6", "[scene_file]")
{
  const Scene scene = scene_of(
      "{\"bodies\": [{\"name\": \"b\", \"shape\": \"sphere\", \"radius\": 1, \"mass\": 1}]}");
  CHECK(scene.gravity == Vector3<double>(0, -9.81, 0));
  CHECK((scene.step == 1.0 / 60 && scene.duration == 10));
  CHECK((scene.bodies[0].friction == 0.6 && scene.bodies[0].restitution == 0));
  CHECK(scene.bodies[0].position.isZero(0));
}

TEST_CASE("a scene written as JSON reads back as the same scene, bit by bit", "[scene_file]")
{
  for (const std::string& name : scene_names())
  {
    const Scene scene = named_scene(name);
    const Scene again = scene_of(scene_json(scene));
    INFO(name);
    CHECK((again.gravity == scene.gravity && again.step == scene.step));
    CHECK(again.duration == scene.duration);
    CHECK(std::equal(
        again.bodies.begin(), again.bodies.end(), scene.bodies.begin(), scene.bodies.end(), same));
  }
}

TEST_CASE("a unit quaternion or normal may be rounded, but not of another length", "[scene_file]")
{
  std::vector<std::string> lines = good;
  lines[14] = "\"orientation\": [0.7071, 0, 0.7071, 0],";
  CHECK(std::abs(scene_of(joined(lines)).bodies[1].orientation.norm() - 1) < 1e-15);
  CHECK(
      answer(15, "\"orientation\": [1, 1, 0, 0],") ==
      "moon.json:15: orientation of box \"crate\" must be of length 1, got length "
      "1.4142135623730951");
  CHECK(
      answer(15, "\"orientation\": [0, 0, 0, 0],") ==
      "moon.json:15: orientation of box \"crate\" must be of length 1, got length 0");
  CHECK(
      answer(
          8, "{\"name\": \"floor\", \"shape\": \"plane\", \"normal\": [0, 2, 0], "
             "\"offset\": 0},") ==
      "moon.json:8: normal of plane \"floor\" must be of length 1, got length 2");
}

TEST_CASE("a text that is not JSON is answered with the line and what to do", "[scene_file]")
{
  CHECK(answer(3, "\"step\": 0.01") == "moon.json:4: a comma is missing before \"duration\"");
  CHECK(answer(4, "\"duration\" 5,") == "moon.json:4: a colon is missing before 5");
  CHECK(
      answer(19, "\"restitution\": 0,") ==
      "moon.json:20: a value is missing before }, or there is a comma too many");
  CHECK(answer(20, "],") == "moon.json:20: a bracket of the wrong kind: ]");
  CHECK(answer(23, "}}") == "moon.json:23: nothing may follow the last bracket, but there is }");
  CHECK(answer(23, "") == "moon.json:23: the file ends too early");
  CHECK(
      answer(10, "\"name\": \"crate,") ==
      "moon.json:10: a text lacks its closing quotation mark on its line");
  CHECK(
      answer(13, "mass: 3,") ==
      "moon.json:13: mass is not JSON, which has numbers, \"texts\", true, false and null");
  CHECK(answer(10, "\"name\": \"\xff\",") == "moon.json:10: a text is not UTF-8");
}

TEST_CASE("numbers that are none, or beyond double, are named on their line", "[scene_file]")
{
  CHECK(
      answer(13, "\"mass\": NaN,") ==
      "moon.json:13: NaN is not JSON, which has numbers, \"texts\", true, false and null");
  CHECK(answer(13, "\"mass\": 1e999,") == "moon.json:13: 1e999 is beyond the range of double");
  CHECK(answer(13, "\"mass\": -1e999\n,") == "moon.json:13: -1e999 is beyond the range of double");
}

TEST_CASE("a mass must be zero or more, and a plane's zero", "[scene_file]")
{
  CHECK(
      answer(13, "\"mass\": -1,") == "moon.json:13: mass of box \"crate\" must be 0 (fixed) or "
                                     "1e-09 to 1e+30, got -1");
  CHECK(
      answer(13, "\"mass\": \"3 kg\",") ==
      "moon.json:13: mass of box \"crate\" must be a number, got the text \"3 kg\"");
  CHECK(answer(13, "") == "moon.json:9: box \"crate\" needs a member \"mass\"");
  CHECK(
      answer(
          8, "{\"name\": \"floor\", \"shape\": \"plane\", \"normal\": [0, 1, 0],\n"
             "\"offset\": 0, \"mass\": 5},") ==
      "moon.json:9: mass of plane \"floor\" must be 0, for a plane is fixed, got 5");
  CHECK(
      answer(13, "\"mass\": 0,") ==
      "moon.json:16: velocity of box \"crate\" must be zero, for mass 0 means fixed, got "
      "another one");
}

TEST_CASE("a body may be said to be fixed, kinematic or dynamic; only the last needs a mass")
{
  const auto motion = [](const std::string& line)
  {
    std::vector<std::string> lines = good;
    lines[12] = line;
    const Scene scene = scene_of(joined(lines));
    CHECK(scene_of(scene_json(scene)).bodies[1].motion == scene.bodies[1].motion);
    CHECK(scene.bodies[1].velocity == Vector3<double>(4, 5, 6));
    return motion_type(scene.bodies[1]);
  };
  CHECK(motion("\"motion\": \"kinematic\",") == MotionType::kinematic);
  CHECK(motion("\"motion\": \"kinematic\", \"mass\": 5,") == MotionType::kinematic);
  CHECK(motion("\"motion\": \"dynamic\", \"mass\": 5,") == MotionType::dynamic);
  CHECK(
      answer(13, "\"motion\": \"dynamic\",") ==
      "moon.json:9: box \"crate\" needs a member \"mass\"");
  CHECK(
      answer(13, "\"mass\": 3, \"motion\": \"kinetic\",") ==
      "moon.json:13: motion of box \"crate\" must be \"fixed\", \"kinematic\" or \"dynamic\", got "
      "\"kinetic\"; did you mean kinematic?");
  CHECK(
      answer(13, "\"mass\": 3, \"motion\": \"fixed\",") ==
      "moon.json:16: velocity of box \"crate\" must be zero, for the body is fixed, got another "
      "one");
}

TEST_CASE("a shape must be whole: its own members, three half extents above zero", "[scene_file]")
{
  CHECK(answer(12, "") == "moon.json:9: box \"crate\" needs a member \"half_extents\"");
  CHECK(
      answer(12, "\"half_extents\": [1, 0, 2],") ==
      "moon.json:12: half_extents of box \"crate\" must be 1e-09 to 1e+09, got 0");
  CHECK(
      answer(12, "\"half_extents\": [\n1,\n2,\n-3],") ==
      "moon.json:15: half_extents of box \"crate\" must be 1e-09 to 1e+09, got -3");
  CHECK(
      answer(12, "\"half_extents\": [1, 2],") ==
      "moon.json:12: half_extents of box \"crate\" must be a list of 3 numbers, got a list of 2");
  CHECK(
      answer(12, "\"half_extents\": 1,") ==
      "moon.json:12: half_extents of box \"crate\" must be a list of 3 numbers, got the number 1");
  CHECK(answer(12, "\"radius\": 1,") == "moon.json:12: box \"crate\" has no member \"radius\"");
  CHECK(
      answer(11, "\"shape\": \"bax\",") ==
      "moon.json:11: shape of body \"crate\" must be \"box\", \"sphere\" or \"plane\", got "
      "\"bax\"; did you mean box?");
  CHECK(
      answer(11, "\"shape\": 4,") == "moon.json:11: shape of body \"crate\" must be a text in "
                                     "quotation marks, got the number 4");
}

TEST_CASE("an unknown member is named, with the one that was meant", "[scene_file]")
{
  CHECK(
      answer(2, "\"gravty\": [0, 0, 0],") ==
      "moon.json:2: the scene has no member \"gravty\"; did you mean gravity?");
  CHECK(
      answer(12, "\"half_extent\": [1, 1, 1],") ==
      "moon.json:12: body number 2 has no member \"half_extent\"; did you mean half_extents?");
  CHECK(
      answer(18, "\"colour\": \"red\",") == "moon.json:18: body number 2 has no member \"colour\"");
  CHECK(answer(18, "\"mass\": 4,") == "moon.json:18: \"mass\" is given twice, first on line 13");
}

TEST_CASE("bodies have names of their own, and there is at least one", "[scene_file]")
{
  CHECK(
      answer(10, "\"name\": \"floor\",") ==
      "moon.json:10: there is a body \"floor\" already, on line 8");
  CHECK(answer(10, "") == "moon.json:9: body number 2 needs a member \"name\"");
  CHECK(
      answer(10, "\"name\": \"\",") ==
      "moon.json:10: name of body number 2 must be 1 to 100 letters on a line, got another text");
  CHECK(answer(8, "7,") == "moon.json:8: body number 1 must be an object in { }, got the number 7");
  const auto whole = [](const std::string& text)
  {
    try
    {
      scene_of(text);
    }
    catch (const SceneError& error)
    {
      return std::to_string(error.line()) + " " + error.what();
    }
    return std::string();
  };
  CHECK(whole("") == "1 moon.json:1: the file is empty");
  CHECK(whole(" \n\n") == "1 moon.json:1: the file is empty");
  CHECK(whole("[]") == "1 moon.json:1: the scene must be an object in { }, got a list");
  CHECK(whole("{\n}") == "1 moon.json:1: the scene needs a member \"bodies\"");
  CHECK(
      whole("{\n\"bodies\": []}") ==
      "2 moon.json:2: bodies of the scene must be a list of bodies, got an empty one");
  CHECK(
      whole("{\n\"bodies\": null}") ==
      "2 moon.json:2: bodies of the scene must be a list of bodies, got null");
}

TEST_CASE("step, duration, friction and restitution have their limits", "[scene_file]")
{
  CHECK(answer(3, "\"step\": 0,") == "moon.json:3: step of the scene must be 1e-06 to 1, got 0");
  CHECK(
      answer(4, "\"duration\": 1e9,") ==
      "moon.json:4: duration of the scene must be 0.01 to 1e+05, got 1e+09");
  CHECK(
      answer(5, "\"friction\": -0.1,") ==
      "moon.json:5: friction of the scene must be 0 to 1000, got -0.1");
  CHECK(
      answer(19, "\"restitution\": 1.5") ==
      "moon.json:19: restitution of box \"crate\" must be 0 to 1, got 1.5");
  CHECK(
      answer(14, "\"position\": [1e10, 0, 0],") ==
      "moon.json:14: position of box \"crate\" must be -1e+09 to 1e+09, got 1e+10");
}

TEST_CASE(
    "a file that is cut off or has one wrong byte is a scene, or an error with its line",
    "[scene_file]")
{
  const std::string text = joined(good);
  std::size_t scenes = 0;
  const auto feed = [&](const std::string& broken)
  {
    try
    {
      scenes += scene_of(broken).bodies.empty() ? 0 : 1;
    }
    catch (const SceneError& error)
    {
      REQUIRE((error.line() >= 1 && error.line() <= good.size() + 1));
    }
  };
  for (std::size_t i = 0; i + 2 < text.size(); ++i)
  {
    feed(text.substr(0, i));
  }
  CHECK(scenes == 0);
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    for (const char byte : {'\0', '\n', '"', '{', ']', ',', '-', '9', 'e', '\x80', '\xff'})
    {
      std::string broken = text;
      broken[i] = byte;
      feed(broken);
    }
  }
  CHECK(scenes > 100); // a wrong digit is still a digit
}

TEST_CASE("brackets without end are refused, not followed", "[scene_file]")
{
  const auto nested = [](const std::string& text) { return scene_of(text); };
  CHECK_THROWS_AS(nested(std::string(1'000'000, '[')), SceneError);
  std::string objects;
  for (int i = 0; i < 100'000; ++i)
  {
    objects += "{\"a\":";
  }
  CHECK_THROWS_AS(nested(objects), SceneError);
}

TEST_CASE("a scene is read from a file and named after it; no file is an error", "[scene_file]")
{
  const std::filesystem::path path = std::filesystem::temp_directory_path() /
                                     ("cookbook_scene_" + std::to_string(getpid()) + ".json");
  std::ofstream(path) << "\xEF\xBB\xBF" << joined(good);
  CHECK(read_scene(path).name == path.stem().string());
  std::filesystem::remove(path);
  CHECK_THROWS_WITH(read_scene(path), "cannot read " + path.string());
  CHECK_THROWS_AS(read_scene(std::filesystem::temp_directory_path()), std::runtime_error);
}
