#pragma once

/// \file
/// \brief Scenes in which bodies stand on one another: towers, pyramids, a house of cards.

#include "06_world/scenes/trial/scene_bodies.hpp"

#include <array>

namespace cookbook::scenes
{

/// A scene with the ground in it and nothing else yet.
inline Scene standing(double duration = 20)
{
  return {.duration = duration, .bodies = {ground()}};
}

/// Cubes one on top of the other, touching.
inline Scene tower(int count)
{
  Scene scene = standing();
  for (int i = 0; i < count; ++i)
  {
    scene.bodies.push_back(cube_body(numbered("box", i + 1), {0, i + 0.5, 0}));
  }
  return scene;
}

/// The tower with its cubes 3 cm to the left and to the right in turn.
inline Scene tower_shifted(int count)
{
  Scene scene = tower(count);
  for (std::size_t i = 1; i < scene.bodies.size(); ++i)
  {
    scene.bodies[i].position.x() = i % 2 == 0 ? 0.03 : -0.03;
  }
  return scene;
}

/// The shifted tower with its cubes turned about the vertical, by 0°, 25.4° and 45.2° in turn.
inline Scene tower_turned(int count)
{
  const std::array<Quaternion<double>, 3> turns{
      whole_turn(1, 0, 0, 0), whole_turn(40, 0, 9, 0), whole_turn(12, 0, 5, 0)};
  Scene scene = tower_shifted(count);
  for (std::size_t i = 1; i < scene.bodies.size(); ++i)
  {
    scene.bodies[i].orientation = turns[(i - 1) % turns.size()];
  }
  return scene;
}

/// Cubes let fall 10 cm apart, each 1 cm beside the one below, with little friction: row S3.
inline Scene tower_dropped(int count)
{
  Scene scene = tower(count);
  for (std::size_t i = 1; i < scene.bodies.size(); ++i)
  {
    scene.bodies[i].position.x() = i % 2 == 0 ? 0.01 : -0.01;
    scene.bodies[i].position.y() += 0.1 * static_cast<double>(i);
    scene.bodies[i].friction = 0.3;
  }
  scene.bodies.front().friction = 0.3;
  return scene;
}

/// Rows of cubes, each with one less than the row below, with gaps of 12.5 cm beside them.
inline Scene pyramid(int rows)
{
  Scene scene = standing();
  for (int row = 0; row < rows; ++row)
  {
    for (int i = 0; i < rows - row; ++i)
    {
      const double x = 1.125 * (i - 0.5 * (rows - row - 1));
      const std::string name = numbered(numbered("row", row + 1), i + 1);
      scene.bodies.push_back(cube_body(name, {x, row + 0.5, 0}));
    }
  }
  return scene;
}

/// The pyramid of ten rows whose topmost cube has another mass [kg]: row S7.
inline Scene pyramid_heavy_top(int mass)
{
  Scene scene = pyramid(10);
  scene.bodies.back().mass = mass;
  return scene;
}

/// A cube of 1 kg under one of another mass [kg]: row S5.
inline Scene heavy_on_light(int mass)
{
  Scene scene = standing();
  scene.bodies.push_back(cube_body("light", {0, 0.5, 0}));
  scene.bodies.push_back(cube_body("heavy", {0, 1.5, 0}, mass));
  return scene;
}

/// A card of 0.1 kg, 1 m long, 2 cm thick and 0.7 m deep, that leans to the right (side 1) or to
/// the left (side −1) by the angle with the sine 7/25, and touches an apex with its upper edge.
inline SceneBody
leaning_card(const std::string& name, double apex, double floor_height, double side)
{
  const double sine = 7.0 / 25;
  const double cosine = 24.0 / 25;
  const double x = apex - side * (0.5 * sine + 0.01 * cosine);
  const double y = floor_height + 0.5 * cosine + 0.01 * sine;
  SceneBody card = box_body(name, {0.01, 0.5, 0.35}, {x, y, 0}, 0.1);
  card.orientation = turn_about_z(-side * sine, cosine);
  return card;
}

/// A house of cards: on each level pairs that lean on each other, one less than below, and cards
/// laid over their tops for the next level to stand on.
inline Scene card_house(int levels)
{
  const double height = 24.0 / 25 + 0.02 * 7.0 / 25;
  Scene scene = standing();
  for (int level = 0; level < levels; ++level)
  {
    const double floor_height = level * (height + 0.02);
    for (int i = 0; i < levels - level; ++i)
    {
      const double apex = i - 0.5 * (levels - level - 1);
      const std::string name = numbered(numbered("level", level + 1), i + 1);
      scene.bodies.push_back(leaning_card(name + "_left", apex, floor_height, 1));
      scene.bodies.push_back(leaning_card(name + "_right", apex, floor_height, -1));
      if (i > 0)
      {
        const Vector3<double> middle(apex - 0.5, floor_height + height + 0.01, 0);
        scene.bodies.push_back(box_body(name + "_flat", {0.495, 0.01, 0.35}, middle, 0.1));
      }
    }
  }
  return scene;
}

} // namespace cookbook::scenes
