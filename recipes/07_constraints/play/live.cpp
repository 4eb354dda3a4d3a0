/// \file
/// \brief A scene of the game's world to throw balls at, to drag bodies in, and to look inside.

#include "06_world/game_world/trial/joint_opening.hpp"
#include "06_world/game_world/trial/world_measures.hpp"
#include "06_world/scenes/trial/scene_text.hpp"
#include "07_constraints/play/trial/play_drawing.hpp"
#include "07_constraints/play/trial/play_pointer.hpp"
#include "tools/live/page.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace cookbook::live
{

namespace
{

using namespace play;

std::unique_ptr<Play> played;
Picture canvas, seen;

/// What the pointer does in this event: drags a body or the camera, or throws.
void follow_pointer(Page& page, bool throws, const Throw& how)
{
  const auto press = [&](const Ray<double>& ray)
  {
    if (take_hold(*played, ray) && throws)
    {
      throw_ball(*played, ray, how);
      let_go(played->world, played->hand);
    }
  };
  play::follow_pointer(*played, page.pointer(), press);
}

/// Shows what is measured.
void read_out(Page& page, const Islands& islands)
{
  const GameWorld& world = played->world;
  int movable = 0, awake = 0, points = 0;
  for (std::size_t i = 0; i < world.bodies().size(); ++i)
  {
    const bool moves = !is_fixed(world.bodies()[i]);
    movable += moves ? 1 : 0;
    awake += moves && !world.is_asleep(world.id(i)) ? 1 : 0;
  }
  for (const WorldContact& contact : world.contacts())
  {
    points += static_cast<int>(contact.points.size());
  }
  const double joules = energy(world);
  const double deepest = std::round(1e6 * deepest_overlap(world)) / 1000; // [mm]
  page.text("bodies awake", std::to_string(awake) + " of " + std::to_string(movable));
  page.number("contact points", points);
  page.number("islands", static_cast<double>(islands.size()));
  page.number("energy", joules, "J");
  page.number("deepest overlap", deepest, "mm");
  if (played->world.constraint_sets() > 1) // besides the hand's
  {
    page.number(
        "joints open by", std::round(1e6 * joint_opening(played->world).length) / 1000, "mm");
  }
  page.number("time", world.time(), "s");
  page.plot("energy", joules, "J");
  page.plot("deepest overlap", deepest, "mm");
  if (awake == 0 && !played->hand.held)
  {
    page.rests();
  }
}

/// The names of the scenes.
std::vector<std::string> names_of_scenes()
{
  std::vector<std::string> names;
  for (const PlayScene& one : play_scenes())
  {
    names.push_back(one.name);
  }
  return names;
}

/// The scene of a file, or without one that of the choice; throws where the file cannot be read.
Scene scene_of(const File& file, int choice)
{
  constexpr std::size_t most = 1000;
  if (file.name.empty())
  {
    return play_scenes()[std::size_t(choice)].scene();
  }
  Scene scene = scene_in(file.text, file.name);
  if (scene.bodies.size() > most)
  {
    throw SceneError(file.name, 1, "a scene to play with has at most 1000 bodies");
  }
  return scene;
}

/// What the reader chose.
struct Chosen
{
  int scene;          ///< of the list
  bool thrown;        ///< a ball, by its button
  bool throws;        ///< whether a press on a body throws a ball at it
  Throw ball;         ///< which
  std::string solver; ///< by name
  int substeps;       ///< 0: its own
  bool sleeps;        ///< bodies that rest
  Shown shown;
  File file; ///< in place of the list's scene
};

/// Asks for all inputs.
Chosen ask(Page& page)
{
  const int scene = page.choice("scene", names_of_scenes());
  if (page.changed("scene"))
  {
    page.close("scene file");
  }
  const bool thrown = page.button("throw a ball");
  const bool throws = page.choice("a body that is pressed", {"is dragged", "is thrown at"}) == 1;
  const double mass = page.slider("mass of the ball", 1, 100, 20, "kg");
  const Throw ball{mass, page.slider("its speed", 2, 60, 25, "m/s")};
  const int solver = page.choice("solver", solver_names());
  static constexpr std::array<int, 7> counts{0, 1, 2, 4, 8, 16, 32};
  const int substeps = page.choice("substeps", {"its own", "1", "2", "4", "8", "16", "32"});
  const bool sleeps = page.toggle("bodies fall asleep", true);
  const Shown shown{
      page.toggle("contacts"), page.toggle("normals"), page.toggle("impulses"),
      page.toggle("islands"), page.dark()};
  const File file = page.file("scene file");
  page.restarts_with("scene").restarts_with("scene file").restarts_with("bodies fall asleep");
  return {scene,
          thrown,
          throws,
          ball,
          solver_names()[std::size_t(solver)],
          counts[std::size_t(substeps)],
          sleeps,
          shown,
          file};
}

/// Begins anew, or goes on with another solver.
void prepare(Page& page, const Chosen& chosen)
{
  const bool begins = page.begins();
  if (begins)
  {
    played = std::make_unique<Play>(scene_of(chosen.file, chosen.scene), chosen.sleeps);
  }
  if (begins || page.changed("solver") || page.changed("substeps"))
  {
    wake_all(played->world);
    played->solver.change(solver_named(chosen.solver, chosen.substeps));
  }
}

} // namespace

void figure(Page& page)
{
  const Chosen chosen = ask(page);
  prepare(page, chosen);
  follow_pointer(page, chosen.throws, chosen.ball);
  const Camera<double> camera = camera_of(*played);
  if (chosen.thrown)
  {
    const Vector2<double> middle(picture_width / 2.0, picture_height / 2.0);
    throw_ball(*played, picking_ray(camera, middle), chosen.ball);
  }
  for (int i = 0; i < page.steps(); ++i)
  {
    step(*played);
  }
  Islands islands;
  islands.find(played->world.bodies(), played->world.contacts());
  canvas = make_picture(picture_width, picture_height, 2);
  draw(canvas, camera, *played, chosen.shown, islands);
  seen = shown(canvas);
  page.show(picture_width, picture_height, seen.pixels);
  read_out(page, islands);
}

} // namespace cookbook::live
