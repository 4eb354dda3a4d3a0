#pragma once

/// \file
/// \brief What is shown of a world, and in which colours.

#include "02_primitives/picture/canvas.hpp"
#include "06_world/game_world/game_world.hpp"
#include "06_world/islands/island.hpp"

#include <array>
#include <cstddef>

namespace cookbook::play
{

/// What is shown of a world besides its bodies.
struct Shown
{
  bool contacts = false; ///< contact points
  bool normals = false;  ///< their normals
  bool impulses = false; ///< what each point was given in the last step
  bool islands = false;  ///< a colour for each island
  bool dark = false;     ///< on a dark page
};

/// Six colours for islands, made of the palette's.
inline Colour island_colour(const Palette& palette, int island)
{
  const std::array<Colour, 6> colours{
      palette.a,
      palette.b,
      palette.good,
      mixed(palette.a, palette.overlap, 110),
      mixed(palette.a, palette.good, 130),
      mixed(palette.b, palette.good, 110)};
  return colours[static_cast<std::size_t>(island) % colours.size()];
}

/// The colour of a body of a world: thrown balls orange, all others in three shades of blue, or by
/// island; what sleeps is paler, what is fixed grey.
inline Colour body_colour(
    const Palette& palette, const Shown& shown, const GameWorld& world, std::size_t i,
    const Islands& islands)
{
  const RigidBody& body = world.bodies()[i];
  const bool thrown = world.scene().bodies[i].name.rfind("thrown", 0) == 0;
  Colour colour = thrown ? palette.b : mixed(palette.a, palette.sky, 35 * int(i % 3));
  if (is_fixed(body))
  {
    return palette.muted;
  }
  if (shown.islands)
  {
    colour = island_colour(palette, islands.numbers()[i]);
  }
  return world.is_asleep(world.id(i)) ? mixed(colour, palette.ground, 110) : colour;
}

} // namespace cookbook::play
