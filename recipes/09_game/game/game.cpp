/// \file
/// \brief Plays shots at levels of the game, and prints what they break and the ruin they leave.

#include "09_game/game/game.hpp"

#include "09_game/game/trial/game_figures.hpp"
#include "09_game/game/trial/level_file.hpp"
#include "09_game/game/trial/levels.hpp"
#include "09_game/game/trial/scripted_shots.hpp"
#include "tools/program/number_option.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>
#include <sstream>

namespace
{

using namespace cookbook;
using namespace cookbook::game;

/// Plays shots at a level, a row each.
void play_level(Table& table, const Level& level, const Shots& shots)
{
  Game game = start(level);
  for (std::size_t i = 0; i < shots.size() && game.phase == Phase::aiming; ++i)
  {
    const ShotResult result = play(game, shots[i]);
    table.row(
        {level.name, number(shots[i].x()), number(shots[i].y()), std::to_string(result.broken),
         std::to_string(game.points), std::to_string(result.steps), name_of(game.phase),
         ruin_name(game)});
  }
}

/// The shots that an option lists: `-1,-0.2 -0.8,-0.3`.
Shots shots_of(const Arguments& given)
{
  Shots shots;
  std::istringstream words(given.value("shots"));
  for (std::string word; words >> word;)
  {
    std::istringstream text(word);
    double x = 0, y = 0;
    char comma = ' ', more = ' ';
    if (!(text >> x >> comma >> y) || comma != ',' || text >> more)
    {
      throw WrongOption("--shots must be pulls such as '-1,-0.2 -0.8,-0.3', got '" + word + "'");
    }
    shots.emplace_back(x, y);
  }
  return shots;
}

void run(const Arguments& given)
{
  Table table({"level", "pull x", "y", "pigs broken", "points", "steps", "then", "ruin"});
  const std::string& file = given.value("scene-file");
  const std::vector<Level>& levels = built_in_levels();
  const int chosen = number_option<int>(given, "level", 0, static_cast<int>(levels.size()));
  const Shots shots = shots_of(given);
  for (std::size_t i = 0; i < levels.size() && file.empty(); ++i)
  {
    if (chosen == 0 || chosen == static_cast<int>(i + 1))
    {
      play_level(table, levels[i], shots.empty() ? winning_shots.at(i) : shots);
    }
  }
  if (!file.empty())
  {
    play_level(table, read_level(std::filesystem::path(file)), shots);
  }
  std::cout << table.text();
  if (chosen == 0 && file.empty() && shots.empty())
  {
    save_figure(given, "game_levels.svg", levels_figure().svg());
    save_figure(given, "game_shot.svg", shot_figure().svg());
  }
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "game",
      .summary = "Shoots birds at the levels of the game: pigs broken, points, steps, and a hash "
                 "of the ruin's bits.",
      .options = {
          {"level", "which level, 1 to 3; 0: all", "0", {}, {}, {"scene-file"}},
          {"scene-file", "a JSON file with your own level", "", {}, {}, {}, FileUse::read},
          {"shots",
           "pulls of the sling [m], such as '-1,-0.2 -0.8,-0.3'; left out: shots that win",
           "",
           {}}}};
  return run_program(argc, argv, arguments, run);
}
