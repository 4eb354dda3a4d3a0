#pragma once

/// \file
/// \brief Scenes of many bodies: piles that fall, piles of thin plates, bodies put into one
/// another.

#include "06_world/scenes/trial/stack_scenes.hpp"

#include <cstdint>

namespace cookbook::scenes
{

/// Whole numbers that look random and are the same everywhere: each is made of the one before it.
class Mixer
{
public:
  /// The next one, from `least` to `most`.
  int between(int least, int most)
  {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    const std::uint64_t span = static_cast<std::uint64_t>(most - least + 1);
    return least + static_cast<int>((state_ >> 33) % span);
  }

private:
  std::uint64_t state_ = 5;
};

/// Boxes of 1 kg with sides of 0.5 to 1 m, turned any way, that fall together.
///
/// They start in layers, half as many as there are boxes along a side, too far apart to touch.
inline Scene pile(int count)
{
  const double spacing = 1.75;
  int side = 1;
  while (side * side * ((side + 1) / 2) < count)
  {
    ++side;
  }
  Scene scene = standing(10);
  Mixer mixer;
  const auto half = [&mixer] { return mixer.between(2, 4) / 8.0; };
  const auto turn = [&mixer] { return mixer.between(-3, 3); };
  for (int i = 0; i < count; ++i)
  {
    const int layer = i / (side * side);
    const int row = i / side % side;
    const Vector3<double> cell(i % side - 0.5 * (side - 1), layer + 0.5, row - 0.5 * (side - 1));
    const double x = half(), y = half(), z = half();
    SceneBody body = box_body(numbered("box", i + 1), {x, y, z}, spacing * cell);
    const int a = turn(), b = turn(), c = turn();
    body.orientation = whole_turn(4, a, b, c);
    scene.bodies.push_back(body);
  }
  return scene;
}

/// Plates of 1 m and 4 cm, one on top of the other, shifted by 3 cm to the left and right in turn.
inline Scene plates(int count)
{
  Scene scene = standing();
  for (int i = 0; i < count; ++i)
  {
    const Vector3<double> middle(i % 2 == 0 ? -0.03 : 0.03, 0.04 * i + 0.02, 0);
    scene.bodies.push_back(box_body(numbered("plate", i + 1), {0.5, 0.02, 0.5}, middle));
  }
  return scene;
}

/// Four rows of cubes, each overlapping its neighbours by a quarter, and beside them a cube half a
/// metre deep in the ground: row S18.
inline Scene overlap()
{
  Scene scene = standing(10);
  for (int row = 0; row < 4; ++row)
  {
    for (int i = 0; i < 4 - row; ++i)
    {
      const Vector3<double> middle(0.75 * (i - 0.5 * (3 - row)), 0.5 + 0.75 * row, 0);
      scene.bodies.push_back(cube_body(numbered(numbered("row", row + 1), i + 1), middle));
    }
  }
  scene.bodies.push_back(cube_body("deep", {4, 0, 0}));
  return scene;
}

} // namespace cookbook::scenes
