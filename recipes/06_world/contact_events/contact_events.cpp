/// \file
/// \brief Crates that fall on a table: how a game uses a world.

#include "06_world/contact_events/contact_events.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/world_inputs.hpp"
#include "06_world/game_world/world_queries.hpp"
#include "tools/program/number_option.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <algorithm>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace
{

using namespace cookbook;

/// A crate of half a metre, its centre at a height [m], a little to one side.
SceneBody crate(int number, double height)
{
  const Vector3<double> half(0.25, 0.25, 0.25), place(number % 2 == 0 ? 0.06 : -0.06, height, 0);
  return {
      .name = "crate " + std::to_string(number),
      .shape = BoxShape{half},
      .mass = 20,
      .position = place};
}

// [game]
/// Drops crates on a table, one a second, shoots at the heap, and takes the table away.
Table game(int crates)
{
  Scene scene;
  scene.bodies.push_back({.name = "floor", .shape = PlaneShape{{0, 1, 0}, 0}});
  scene.bodies.push_back({.name = "table", .shape = BoxShape{{1, 0.05, 1}}, .position = {0, 1, 0}});
  GameWorld world(scene, solver_named("soft_steps"), true);
  ContactEvents watch;
  Table told({"time [s]", "what happens"});
  const auto tell = [&](const std::string& what) { told.row({number(world.time()), what}); };
  const auto name = [&](BodyId id) { return world.scene().bodies[world.index(id)].name; };
  const int second = 60;
  std::vector<BodyId> fallen;
  std::map<ContactEvents::Pair, double> parted; // [s]
  for (int frame = 0; frame < (crates + 6) * second; ++frame)
  {
    if (frame % second == 0 && frame / second < crates)
    {
      const auto top = WorldQueries(world).cast({{0, 10, 0}, {0, -1, 0}});
      fallen.push_back(world.add(crate(frame / second + 1, 10 - top->hit.t + 1)));
    }
    if (frame == (crates + 1) * second)
    {
      apply_impulse(world, fallen.back(), {60, 0, 0});
      tell(name(fallen.back()) + " is shot at: 60 N s");
    }
    if (frame == (crates + 3) * second)
    {
      world.remove(1);
      tell("the table is taken away");
    }
    world.step();
    watch.update(world.contacts(), world.bodies());
    for (const auto& [a, b] : watch.begun())
    {
      if (!parted.count({a, b}) || world.time() - parted[{a, b}] > 0.5) // more than a hop
      {
        tell(name(b) + " lands on " + name(a));
      }
    }
    for (const auto& pair : watch.ended())
    {
      parted[pair] = world.time();
    }
  }
  const auto asleep =
      std::count_if(fallen.begin(), fallen.end(), [&](BodyId id) { return world.is_asleep(id); });
  tell(std::to_string(asleep) + " of " + std::to_string(crates) + " crates sleep");
  return told;
}
// [game]

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "contact_events",
      .summary = "Drops crates on a table, shoots at them, and takes the table away.",
      .options = {{"crates", "how many, 1 to 20", "4", {}}}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      { std::cout << game(int(number_option(given, "crates", 1, 20))).text(); });
}
