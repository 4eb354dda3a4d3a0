/// \file
/// \brief The game to be played: the bird is dragged and let go, or aimed by numbers.

#include "09_game/game/game_picture.hpp"
#include "09_game/game/trial/levels.hpp"
#include "09_game/game/trial/scripted_shots.hpp"
#include "tools/live/page.hpp"

namespace cookbook::live
{
namespace
{

/// What is kept from one event to the next.
struct Play
{
  game::Game game;
  Picture picture;
  int steps = 0;                    ///< since the start
  bool drags = false;               ///< the pointer pulls the bird
  Vector2<double> pressed_at{0, 0}; ///< [m], where it went down
  Vector2<double> grip{0, 0};       ///< [m], from the pull to there
};

/// Pulls the bird as the pointer moves, wherever it went down, and lets it go where it is released.
void drag(Play& play, const Page& page, const Camera<double>& camera)
{
  const Pointer& pointer = page.pointer();
  const Vector2<double> at = game::pull_at(camera, pointer.at);
  if (pointer.pressed && play.game.phase == game::Phase::aiming)
  {
    play.drags = true;
    play.pressed_at = at;
    play.grip = at - play.game.pull.head<2>();
  }
  if (play.drags)
  {
    game::aim(play.game, at - play.grip);
  }
  if (play.drags && pointer.released)
  {
    play.drags = false;
    if ((at - play.pressed_at).norm() > 0.1) // not where the reader has only clicked
    {
      game::shoot(play.game);
    }
  }
}

/// What the game's state is, in numbers and words.
void tell(Page& page, const Play& play)
{
  const game::Game& game = play.game;
  page.text("the game is", name_of(game.phase));
  page.number("points", game.points);
  page.number("pigs", static_cast<double>(game.pigs.size()));
  page.number("birds", static_cast<double>(game.birds.size()));
  page.number("speed", game::sling_velocity(game.pull).norm(), "m/s");
  page.number("steps", play.steps);
  page.text("ruin", game::ruin_name(game));
}

} // namespace

void figure(Page& page)
{
  static Play play;
  std::vector<std::string> names;
  for (const game::Level& level : game::built_in_levels())
  {
    names.push_back(level.name);
  }
  const std::size_t level = static_cast<std::size_t>(page.choice("level", names));
  // One after the other: compilers evaluate arguments in orders of their own.
  const double pull_x = page.slider("pull x", -1.2, 0.2, -0.6, "m");
  const double pull_y = page.slider("pull y", -1.2, 0.4, -0.2, "m");
  const Vector2<double> pull(pull_x, pull_y);
  const game::Phase before = play.game.phase;
  page.restarts_with("level");
  if (page.begins())
  {
    play = {game::start(game::built_in_levels()[level]), {}};
    game::aim(play.game, pull);
  }
  if (page.changed("pull x") || page.changed("pull y"))
  {
    game::aim(play.game, pull);
  }
  const Camera<double> camera = game::game_camera(640, 400);
  page.grip(to_pixel<double>(camera, game::sling + play.game.pull)->pixel);
  drag(play, page, camera);
  if (page.button("shoot"))
  {
    game::shoot(play.game);
  }
  for (int i = 0; i < page.steps(); ++i)
  {
    game::step(play.game);
    ++play.steps;
  }
  if (before == game::Phase::flying && play.game.phase == game::Phase::aiming)
  {
    game::aim(play.game, pull);
  }
  if (play.game.phase != game::Phase::flying)
  {
    page.rests();
  }
  tell(page, play);
  play.picture = game::draw(play.game, 640, 400, page.dark());
  page.show(640, 400, play.picture.pixels);
}

} // namespace cookbook::live
