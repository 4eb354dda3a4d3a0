/// \file
/// Makes levels of JSON values, and checks each value where it is read.

#include "09_game/game/trial/level_file.hpp"
#include "tools/files/json_object_file.hpp"

#include <fstream>
#include <iterator>

namespace cookbook::game
{
namespace
{

constexpr Limits anything{-1e9, 1e9}; // the level itself says what may be played

std::optional<Vector2<double>> none()
{
  return std::nullopt;
}

Brick read_brick(const JsonObject& object)
{
  object.allow_only({"material", "center", "half_extents"});
  const std::string material = object.text("material");
  if (material != "wood" && material != "stone")
  {
    object.wrong(
        "material", object.need("material"), "\"wood\" or \"stone\"",
        "\"" + material.substr(0, 64) + "\"" + meant(material, {"wood", "stone"}));
  }
  return {
      material == "wood" ? Material::wood : Material::stone,
      object.vector<2>("center", anything, none()),
      object.vector<2>("half_extents", anything, none())};
}

Pig read_pig(const JsonObject& object)
{
  object.allow_only({"center", "radius", "strength"});
  return {
      object.vector<2>("center", anything, none()), object.number("radius", anything),
      object.number("strength", anything)};
}

/// The items of a list of the level, each made by `read`.
template <class Read>
auto read_list(
    const JsonObject& level, const std::string& file, const std::string& name,
    const std::string& item, const Read& read)
{
  const JsonValue& list = level.need(name);
  if (list.kind != JsonValue::Kind::list)
  {
    level.wrong(name, list, "a list", described(list));
  }
  std::vector<decltype(read(std::declval<JsonObject>()))> items;
  for (const JsonValue& value : list.items)
  {
    items.push_back(read(JsonObject(value, file, item + " " + std::to_string(items.size() + 1))));
  }
  return items;
}

} // namespace

Level read_level(const std::string& text, const std::string& file)
{
  const JsonValue value = parse_json(text, file);
  const JsonObject object(value, file, "the level");
  object.allow_only({"name", "birds", "bricks", "pigs"});
  Level level;
  level.name = object.text("name");
  const double birds = object.number("birds", anything);
  level.birds = static_cast<int>(birds);
  if (level.birds != birds)
  {
    object.wrong("birds", object.need("birds"), "a whole number", round_trip(birds));
  }
  level.pigs = read_list(object, file, "pigs", "pig", read_pig);
  level.bricks = read_list(object, file, "bricks", "brick", read_brick);
  try
  {
    check(level);
  }
  catch (const std::invalid_argument& error)
  {
    object.fail(value, error.what());
  }
  return level;
}

Level read_level(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path))
  {
    throw std::runtime_error("cannot read " + path.string());
  }
  return read_level(
      {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()}, path.string());
}

std::filesystem::path levels_folder()
{
  return COOKBOOK_LEVELS;
}

} // namespace cookbook::game
