/// \file
/// \brief Chains, a bridge, a ring and a ragdoll to be dragged, under each solver of joints.

#include "06_world/game_world/trial/joint_opening.hpp"
#include "06_world/game_world/trial/world_measures.hpp"
#include "07_constraints/joint_trial/trial/live_joints.hpp"
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
double energy_at_start = 0; // [J]

/// What the reader chose.
struct Chosen
{
  LiveJoints scene;
  JointMethod method;
  int count;    ///< of what the method counts, in a frame
  double load;  ///< [kg]
  double force; ///< [N], largest of the mouse
};

template <class All>
std::vector<std::string> names_of(const All& all)
{
  std::vector<std::string> names;
  for (const auto& one : all)
  {
    names.push_back(one.name);
  }
  return names;
}

/// Asks for all inputs.
Chosen ask(Page& page)
{
  static constexpr std::array<int, 4> times{1, 2, 4, 8};
  static constexpr std::array<double, 5> loads{1, 10, 100, 1000, 10000};
  const std::vector<LiveJoints> scenes = live_joints();
  const std::vector<JointMethod> methods = joint_methods();
  const int scene = page.choice("scene", names_of(scenes));
  const int method = page.choice("solver", names_of(methods), int(methods.size()) - 1);
  const int more = page.choice("substeps or passes", {"as it comes", "× 2", "× 4", "× 8"});
  const int load = page.choice("load", {"1 kg", "10 kg", "100 kg", "1,000 kg", "10,000 kg"}, 3);
  const double force = page.slider("the mouse pulls by up to", 10, 5000, 1000, "N");
  page.restarts_with("scene").restarts_with("solver").restarts_with("load");
  page.restarts_with("substeps or passes");
  const JointMethod& by = methods[std::size_t(method)];
  return {
      scenes[std::size_t(scene)], by, by.usual * times[std::size_t(more)], loads[std::size_t(load)],
      force};
}

/// Whether joints have come so far apart that nothing is left to see.
bool has_burst(Play& play)
{
  return !(joint_opening(play.world).length < 1000);
}

/// Shows what is measured.
void read_out(Page& page, const Chosen& chosen)
{
  GameWorld& world = played->world;
  const double open = 1000 * joint_opening(world).length;
  const double gained = energy(world) - energy_at_start;
  double pull = 0;
  if (joints_of(world, played->hand).size() > 0)
  {
    const JointImpulses& given = joints_of(world, played->hand).impulses(0);
    pull = std::hypot(given[0], given[1], given[2]) / world.scene().step;
  }
  page.text("a frame takes", std::to_string(chosen.count) + " × " + chosen.method.counted);
  page.number("time", world.time(), "s");
  if (has_burst(*played)) // its numbers may be infinite
  {
    page.text("joints", "have burst");
    page.rests();
    return;
  }
  page.number("joints open by", std::round(1e6 * open) / 1e6, "mm");
  page.number("energy gained", gained, "J");
  page.number("the mouse pulls by", pull, "N");
  page.plot("joints open by", open, "mm");
  page.plot("energy gained", gained, "J");
  if (world.time() > 60 && !played->hand.held)
  {
    page.rests();
  }
}

} // namespace

void figure(Page& page)
{
  const Chosen chosen = ask(page);
  const int steps = chosen.method.steps(chosen.count);
  if (page.begins())
  {
    played = play_joints(
        chosen.scene, chosen.load, chosen.method.solver(chosen.count), 1.0 / (60 * steps));
    energy_at_start = energy(played->world);
  }
  const auto press = [&](const Ray<double>& ray)
  {
    const auto force = [&](const RigidBody&) { return chosen.force; };
    take_hold(played->world, played->hand, ray, force);
  };
  follow_pointer(*played, page.pointer(), press);
  for (int i = 0; i < steps * page.steps() && !has_burst(*played); ++i)
  {
    step(*played);
  }
  const Camera<double> camera = camera_of(*played);
  const Vector3<double> grip = played->world.bodies()[chosen.scene.grip].motion.center;
  if (const auto at = to_pixel<double>(camera, grip))
  {
    page.grip(at->pixel);
  }
  canvas = make_picture(picture_width, picture_height, 2);
  draw(canvas, camera, *played, {.dark = page.dark()}, {});
  seen = shown(canvas);
  page.show(picture_width, picture_height, seen.pixels);
  read_out(page, chosen);
}

} // namespace cookbook::live
