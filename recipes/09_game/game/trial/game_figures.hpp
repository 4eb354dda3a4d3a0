#pragma once

/// \file
/// \brief The figures of the game: its levels, a flight, and a ruin.

#include "09_game/game/game_picture.hpp"
#include "09_game/game/trial/levels.hpp"
#include "09_game/game/trial/scripted_shots.hpp"
#include "tools/plot/figures/figure3d.hpp"

namespace cookbook::game
{

/// The bodies of a game from the side: birds red, pigs green, wood orange, stone blue.
inline plot::Figure3d view_of(const Game& game, const std::string& title)
{
  plot::Figure3d figure("game", title, {0, 0.12, 560, 150, 4});
  figure.frame({{6.6, 1.8, 0}, 21});
  figure.segment({-4, 0, 0}, {18, 0, 0}, plot::Ink::muted);
  figure.segment({0, 0, 0}, sling, plot::Ink::muted, plot::Stroke::solid, 3);
  figure.segment(sling, sling + game.pull, plot::Ink::muted);
  for (std::size_t i = 1; i < game.world.bodies.size(); ++i)
  {
    const small_world::RigidBody& body = game.world.bodies[i];
    const Look look = look_of(game, i);
    if (look == Look::wood || look == Look::stone)
    {
      figure.box(
          body.motion.center, body.orientation.toRotationMatrix(), body.half_extents,
          look == Look::wood ? plot::Ink::b : plot::Ink::a);
    }
    else if (look != Look::none)
    {
      figure.sphere(
          body.motion.center, body.half_extents.x(),
          look == Look::bird ? plot::Ink::overlap : plot::Ink::good);
    }
  }
  return figure;
}

/// The three levels before the first shot.
inline plot::Grid levels_figure()
{
  plot::Grid grid("game_levels", "", 1);
  grid.describe("The three levels of the game, seen from the side.");
  for (const Level& level : built_in_levels())
  {
    grid.add(view_of(start(level), level.name));
  }
  return grid;
}

/// The points that the preview shows: where the bird would be, every `spacing` [s].
inline std::vector<Vector3<double>> flight_points(const Game& game, double spacing, double time)
{
  std::vector<Vector3<double>> points;
  for (double now = 0; now < time; now += spacing)
  {
    points.push_back(flight(game, now));
  }
  return points;
}

/// A pull of the first level with the flight that it leads to, and the ruin after the shot.
inline plot::Grid shot_figure()
{
  const Level level = built_in_levels()[0];
  Game game = start(level);
  aim(game, winning_shots[0][0]);
  plot::Figure3d before = view_of(game, "aiming: the flight is known in closed form");
  before.polyline(flight_points(game, 0.02, 0.78), plot::Ink::overlap, plot::Stroke::dotted);
  plot::Grid grid("game_shot", "", 1);
  grid.describe("The sling is pulled, with the parabola of the flight; and what the shot leaves.")
      .add(before)
      .add(view_of(played(level, winning_shots[0]), "the turn is over: all bodies sleep"));
  return grid;
}

} // namespace cookbook::game
