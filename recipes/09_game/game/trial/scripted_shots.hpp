#pragma once

/// \file
/// \brief Shots that win each level, and a game played by a list of shots.

#include "09_game/game/game.hpp"

#include <array>
#include <string>
#include <vector>

namespace cookbook::game
{

/// Pulls of the sling [m], one after the other.
using Shots = std::vector<Vector2<double>>;

/// Shots that win the three levels.
inline const std::array<Shots, 3> winning_shots{
    Shots{{-0.8, -0.3}}, Shots{{-1.0, -0.3}}, Shots{{-0.9, -0.4}, {-1.0, -0.1}}};

/// What a shot did.
struct ShotResult
{
  std::size_t broken; ///< how many pigs
  int steps;          ///< until the turn was over
};

/// Shoots the bird on the sling, and steps until the turn is over.
inline ShotResult play(Game& game, const Vector2<double>& pull)
{
  const std::size_t before = game.pigs.size();
  int steps = 0;
  aim(game, pull);
  shoot(game);
  while (game.phase == Phase::flying)
  {
    step(game);
    ++steps;
  }
  return {before - game.pigs.size(), steps};
}

/// A level after these shots, or after those that it took to end the game.
inline Game played(const Level& level, const Shots& shots)
{
  Game game = start(level);
  for (const Vector2<double>& pull : shots)
  {
    play(game, pull);
  }
  return game;
}

/// The hash of a ruin in sixteen hexadecimal digits.
inline std::string ruin_name(const Game& game)
{
  const std::uint64_t hash = ruin_hash(game.world);
  std::string digits;
  for (int place = 60; place >= 0; place -= 4)
  {
    digits += "0123456789abcdef"[hash >> place & 15];
  }
  return digits;
}

} // namespace cookbook::game
