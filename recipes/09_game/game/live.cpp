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
  bool drags = false; ///< the bird is held by the pointer
};

/// The pull that the pointer asks for while it holds the bird; lets the bird go where it is
/// released.
void drag(Play& play, const Page& page, const Camera<double>& camera)
{
  const Pointer& pointer = page.pointer();
  const Vector2<double> pull = game::pull_at(camera, pointer.at);
  if (pointer.pressed && play.game.phase == game::Phase::aiming)
  {
    play.drags = (pull - play.game.pull.head<2>()).norm() < 3 * game::bird_radius;
  }
  if (play.drags)
  {
    game::aim(play.game, pull);
  }
  if (play.drags && pointer.released)
  {
    game::shoot(play.game);
    play.drags = false;
  }
}

/// What the game's state is, in numbers and words.
void tell(Page& page, const game::Game& game)
{
  page.text("the game is", name_of(game.phase));
  page.number("points", game.points);
  page.number("pigs", static_cast<double>(game.pigs.size()));
  page.number("birds", static_cast<double>(game.birds.size()));
  page.number("speed of the bird on the sling", game::sling_velocity(game.pull).norm(), "m/s");
  page.number("time since the shot", game.turn_time, "s");
  page.text("bits of all places", game::ruin_name(game));
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
  if (page.begins() || page.changed("level"))
  {
    play = {game::start(game::built_in_levels()[level]), {}};
    game::aim(play.game, pull);
  }
  if (page.changed("pull x") || page.changed("pull y"))
  {
    game::aim(play.game, pull);
  }
  drag(play, page, game::game_camera(640, 400));
  if (page.button("shoot"))
  {
    game::shoot(play.game);
  }
  for (int i = 0; i < page.steps(); ++i)
  {
    game::step(play.game);
  }
  if (before == game::Phase::flying && play.game.phase == game::Phase::aiming)
  {
    game::aim(play.game, pull);
  }
  if (play.game.phase != game::Phase::flying)
  {
    page.rests();
  }
  tell(page, play.game);
  play.picture = game::draw(play.game, 640, 400, page.dark());
  page.show(640, 400, play.picture.pixels);
}

} // namespace cookbook::live
