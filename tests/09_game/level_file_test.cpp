/// \file
/// What holds for level files: every value is read as written, every error has its line.

#include "09_game/game/trial/level_file.hpp"
#include "09_game/game/trial/levels.hpp"

#include "tests/catch.hpp"

using namespace cookbook;
using namespace cookbook::game;

namespace
{

/// A level with everything that can be given.
const std::string good = R"({
  "name": "two bricks",
  "birds": 2,
  "bricks": [
    {"material": "wood", "center": [10, 0.5], "half_extents": [0.25, 0.5]},
    {"material": "stone", "center": [10, 1.5], "half_extents": [0.2, 0.5]}
  ],
  "pigs": [{"center": [12, 0.375], "radius": 0.375, "strength": 60}]
}
)";

/// The good level with one text in place of another.
std::string with(const std::string& from, const std::string& to)
{
  std::string text = good;
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

void refused(const std::string& text, const std::string& sentence)
{
  CHECK_THROWS_WITH(read_level(text, "my.json"), Catch::Matchers::Equals(sentence));
}

} // namespace

TEST_CASE("a level is read as it is written")
{
  const Level level = read_level(good, "my.json");
  CHECK(level.name == "two bricks");
  CHECK(level.birds == 2);
  REQUIRE(level.bricks.size() == 2);
  CHECK(level.bricks[0].material == Material::wood);
  CHECK(level.bricks[1].material == Material::stone);
  CHECK(level.bricks[1].center == Vector2<double>(10, 1.5));
  CHECK(level.bricks[0].half_extents == Vector2<double>(0.25, 0.5));
  REQUIRE(level.pigs.size() == 1);
  CHECK(level.pigs[0].center == Vector2<double>(12, 0.375));
  CHECK(level.pigs[0].radius == 0.375);
  CHECK(level.pigs[0].strength == 60);
}

TEST_CASE("a wrong level file is refused with its line and the reason")
{
  refused("", "my.json:1: the file is empty");
  refused(with("\"birds\": 2,", ""), "my.json:1: the level needs a member \"birds\"");
  refused(with("2,", "1.5,"), "my.json:3: birds of the level must be a whole number, got 1.5");
  refused(
      with("stone", "stome"), "my.json:6: material of brick 2 must be \"wood\" or \"stone\", got "
                              "\"stome\"; did you mean stone?");
  refused(
      with("[0.2, 0.5]", "[0.2]"),
      "my.json:6: half_extents of brick 2 must be a list of 2 numbers, got a list of 1");
  refused(
      with("\"radius\"", "\"radios\""),
      "my.json:8: pig 1 has no member \"radios\"; did you mean radius?");
  refused(
      with("[10, 1.5]", "[10, 1]"),
      "my.json:1: brick 1 and brick 2 overlap by 0.450000 m; it must be at most 0.01 m");
  refused(
      with("[{\"center\": [12, 0.375], \"radius\": 0.375, \"strength\": 60}]", "[]"),
      "my.json:1: number of pigs is 0.000000; it must be from 1.000000 to 9.000000");
}

TEST_CASE("the levels in the program are those of the files")
{
  for (std::size_t i = 0; i < built_in_levels().size(); ++i)
  {
    const Level& level = built_in_levels()[i];
    const Level read = read_level(levels_folder() / ("level_" + std::to_string(i + 1) + ".json"));
    CHECK(read.name == level.name);
    CHECK(read.birds == level.birds);
    REQUIRE(read.bricks.size() == level.bricks.size());
    for (std::size_t j = 0; j < level.bricks.size(); ++j)
    {
      CHECK(read.bricks[j].material == level.bricks[j].material);
      CHECK(read.bricks[j].center == level.bricks[j].center);
      CHECK(read.bricks[j].half_extents == level.bricks[j].half_extents);
    }
    REQUIRE(read.pigs.size() == level.pigs.size());
    for (std::size_t j = 0; j < level.pigs.size(); ++j)
    {
      CHECK(read.pigs[j].center == level.pigs[j].center);
      CHECK(read.pigs[j].radius == level.pigs[j].radius);
      CHECK(read.pigs[j].strength == level.pigs[j].strength);
    }
  }
}
