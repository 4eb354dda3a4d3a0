#pragma once

/// \file
/// \brief The scenes that `world` knows by name.

#include "06_world/scenes/trial/crowd_scenes.hpp"
#include "06_world/scenes/trial/motion_scenes.hpp"
#include "tools/files/closest_name.hpp"

#include <charconv>
#include <stdexcept>

namespace cookbook
{

/// Scenes that differ in one number: how many bodies, which mass, which speed.
struct SceneFamily
{
  std::string name;    ///< alone, or with a number behind it: `tower`, `tower_20`
  std::string what;    ///< in a few words
  int number;          ///< the one meant by the name alone; 0: there is no number to choose
  int most;            ///< the largest number; the least is 1
  Scene (*scene)(int); ///< with a number
};

/// All of them.
inline const std::vector<SceneFamily>& scene_families()
{
  using namespace scenes;
  static const std::vector<SceneFamily> families{
      {"tower", "cubes one on top of the other", 10, 1000, tower},
      {"tower_shifted", "the same, 3 cm to the left and right", 10, 1000, tower_shifted},
      {"tower_turned", "the same, turned as well", 10, 1000, tower_turned},
      {"tower_dropped", "cubes let fall 10 cm apart", 15, 1000, tower_dropped},
      {"pyramid", "rows of cubes", 10, 100, pyramid},
      {"pyramid_heavy_top", "ten rows, the top cube of N kg", 100, 1'000'000, pyramid_heavy_top},
      {"heavy_on_light", "N kg on 1 kg", 100, 1'000'000, heavy_on_light},
      {"card_house", "thin cards that lean on each other, N levels", 2, 20, card_house},
      {"plates", "thin plates one on top of the other", 20, 1000, plates},
      {"pile", "boxes that fall in a heap", 200, 100'000, pile},
      {"wall", "N courses of bricks in bond", 10, 100, wall},
      {"wall_hit", "the same, hit by a heavy ball", 10, 100, wall_hit},
      {"table_on", "a table top on N legs", 4, 1000, table_on},
      {"cubes", "cubes that fall together", 100, 100'000, cubes},
      {"floor", "cubes side by side on the ground", 100, 100'000, floor_of_cubes},
      {"pit", "balls that fall into a pit", 100, 10'000, pit},
      {"swarm", "balls in flight without gravity", 100, 100'000, swarm},
      {"overlap", "cubes that begin inside each other", 0, 0, [](int) { return overlap(); }},
      {"incline", "a cube that slides down 30°", 0, 0, [](int) { return incline(0.5, 0.5); }},
      {"rolling", "a ball that slides until it rolls", 0, 0, [](int) { return rolling(); }},
      {"tiles", "a cube that slides over flush tiles", 0, 0, [](int) { return tiles(); }},
      {"bounce", "a ball and a cube that bounce", 0, 0, [](int) { return bounce(); }},
      {"thin_wall", "a ball at a wall of 2 cm at N m/s", 100, 100'000, thin_wall},
      {"spinning_top", "a free box that flips", 0, 0, [](int) { return spinning_top(); }},
      {"domino", "upright tiles, the first one falls", 20, 1000, domino}};
  return families;
}

/// The names of the families, in order.
inline std::vector<std::string> scene_names()
{
  std::vector<std::string> names;
  for (const SceneFamily& family : scene_families())
  {
    names.push_back(family.name);
  }
  return names;
}

/// What a reader can write for --scene, a line each.
inline std::string scene_list()
{
  std::string text;
  for (const SceneFamily& family : scene_families())
  {
    text.append(family.name);
    if (family.number > 0)
    {
      text.append("_").append(std::to_string(family.number));
    }
    text.append(": ").append(family.what).append("\n");
  }
  return text;
}

/// The family that a name such as `tower_20` begins with, and what is behind it: `20`.
///
/// std::invalid_argument, with the names there are, where there is none.
inline std::pair<SceneFamily, std::string> family_and_number(const std::string& name)
{
  const std::size_t last = name.find_last_not_of("0123456789");
  const bool numbered = last != std::string::npos && last + 1 < name.size() && name[last] == '_';
  const std::string stem = numbered ? name.substr(0, last) : name;
  for (const SceneFamily& family : scene_families())
  {
    if (family.name == stem && (family.number > 0 || !numbered))
    {
      return {family, numbered ? name.substr(last + 1) : ""};
    }
  }
  throw std::invalid_argument(std::string("there is no scene \"")
                                  .append(name)
                                  .append("\"")
                                  .append(meant(stem, scene_names()))
                                  .append("; there are\n")
                                  .append(scene_list()));
}

/// The scene of a name such as `tower`, or of a name and a number such as `tower_20`.
///
/// std::invalid_argument, with what there is, for any other.
inline Scene named_scene(const std::string& name)
{
  const auto [family, digits] = family_and_number(name);
  int number = family.number;
  const char* const end = digits.data() + digits.size();
  const bool readable =
      digits.empty() || std::from_chars(digits.data(), end, number).ec == std::errc{};
  if (!readable || (!digits.empty() && (number < 1 || number > family.most)))
  {
    throw std::invalid_argument(std::string("the number of scene ")
                                    .append(family.name)
                                    .append(" must be 1 to ")
                                    .append(std::to_string(family.most))
                                    .append(", got ")
                                    .append(digits));
  }
  Scene scene = family.scene(number);
  scene.name = name;
  return scene;
}

} // namespace cookbook
