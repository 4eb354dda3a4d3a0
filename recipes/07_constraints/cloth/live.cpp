/// \file
/// \brief A flag, a square and a cloth on a ball, to be dragged, in the wind.

#include "07_constraints/cloth/trial/live_cloth.hpp"
#include "tools/live/page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cookbook::live
{

namespace
{

constexpr int width = 640, height = 400; // of the picture in every host, so that pointers agree

/// What is kept from one event to the next.
struct Play
{
  Cloth cloth;
  Orbit orbit;
  std::optional<DraggedParticle> held{};
  Vector2<double> pointer{0, 0}; ///< [pixels], where it was
  double time = 0;               ///< [s]
};

std::optional<Play> played;
Picture canvas, seen;

/// What the pointer does in this event: drags a particle, or turns the camera.
void follow_pointer(const Pointer& pointer)
{
  Play& play = *played;
  const Camera<double> camera = orbit_camera(play.orbit, width, height);
  if (pointer.wheel != 0)
  {
    zoom(play.orbit, pointer.wheel > 0 ? 0.9 : 1 / 0.9);
  }
  if (pointer.pressed)
  {
    let_go(play.cloth, play.held);
    play.held = take_hold(play.cloth, picking_ray(camera, pointer.at));
  }
  else if (pointer.down && play.held)
  {
    Vector3<double>& target = play.held->target;
    target = drag_point(camera, pointer.at, target).value_or(target);
  }
  else if (pointer.down)
  {
    turn(play.orbit, pointer.at.x() - play.pointer.x(), pointer.at.y() - play.pointer.y());
  }
  if (!pointer.down)
  {
    let_go(play.cloth, play.held);
  }
  play.pointer = pointer.at;
}

} // namespace

void figure(Page& page)
{
  static constexpr std::array<int, 5> counts{1, 2, 5, 10, 20};
  const std::vector<LiveCloth> scenes = live_cloths();
  std::vector<std::string> names;
  for (const LiveCloth& one : scenes)
  {
    names.push_back(one.name);
  }
  const LiveCloth& scene = scenes[std::size_t(page.choice("scene", names))];
  const double wind = page.slider("wind", 0, 12, 4, "m/s");
  const int substeps = counts[std::size_t(page.choice("substeps", {"1", "2", "5", "10", "20"}, 3))];
  page.restarts_with("scene");
  if (page.begins())
  {
    played = Play{scene.make(), scene.orbit};
  }
  follow_pointer(page.pointer());
  const StepSettings settings{.damping = 0.2, .substeps = substeps};
  for (int i = 0; i < page.steps(); ++i)
  {
    if (played->held)
    {
      pull(played->cloth, *played->held, settings.step);
    }
    step_cloth(played->cloth, settings, scene.obstacles, {.wind = {wind, 0, wind / 4}});
    played->time += settings.step;
  }
  const double stretch = 100 * worst_thread(played->cloth);
  page.number("threads stretch by", std::round(1e4 * stretch) / 1e4, "%");
  page.number("area, of what it was", area_of(played->cloth) / area_of(scene.make()));
  page.number("time", played->time, "s");
  page.plot("threads stretch by", stretch, "%");
  if (played->time > 60 && !played->held)
  {
    page.rests();
  }
  const Camera<double> camera = orbit_camera(played->orbit, width, height);
  if (const auto at = to_pixel(camera, played->cloth.particles.positions[scene.grip]))
  {
    page.grip(at->pixel);
  }
  canvas = make_picture(width, height, 2);
  draw_cloth(
      canvas, camera, played->cloth, scene.obstacles,
      page.dark() ? dark_palette() : light_palette());
  seen = shown(canvas);
  page.show(width, height, seen.pixels);
}

} // namespace cookbook::live
