#pragma once

/// \file
/// \brief A live figure of a small world, under any of several steps or solvers.

#include "05_resolution/small_world/trial/live_scenes.hpp"
#include "tools/live/page.hpp"

#include <utility>
#include <variant>

namespace cookbook::small_world
{

/// The seconds that a figure runs until it stops by itself.
inline constexpr double longest_run = 60;

/// A world of one of several types, with scenes such as StepScenes, and how it is looked at.
template <class Scenes, class... Worlds>
class LiveWorlds
{
public:
  /// Asks for scene and balls, moves the world on, and shows it; `method` is the type's place in
  /// the list, asked for as "step" or "solver".
  void show(live::Page& page, int method)
  {
    std::vector<std::string> names;
    for (const auto& scene : Scenes::template list<std::variant_alternative_t<0, Any>>())
    {
      names.push_back(scene.name);
    }
    const auto scene = static_cast<std::size_t>(page.choice("scene", names));
    page.restarts_with("step").restarts_with("solver").restarts_with("scene");
    const bool marks = page.toggle("contact points");
    const double speed = page.slider("speed of the ball", 5, 40, 15, "m/s");
    const bool thrown = page.button("throw a ball");
    if (page.begins())
    {
      begin(static_cast<std::size_t>(method), scene, std::index_sequence_for<Worlds...>());
    }
    look(page);
    std::visit(
        [&](auto& world)
        {
          if (thrown && balls_++ < Scenes::most_balls)
          {
            throw_ball(world, from_, aim_, speed);
          }
          run(page, world);
          draw(page, world, marks);
        },
        world_);
  }

private:
  using Any = std::variant<Worlds...>;

  /// Puts up a scene under a method.
  template <std::size_t... I>
  void begin(std::size_t method, std::size_t scene, std::index_sequence<I...>)
  {
    const auto put = [&]<class World>(std::in_place_type_t<World>)
    {
      const LiveScene<World> chosen = Scenes::template list<World>()[scene];
      world_ = chosen.make();
      aim_ = chosen.aim;
      from_ = chosen.from;
      orbit_ = {{0, 0.75 * chosen.aim + 0.3, 0}, chosen.distance, 0.35, 0.25, 0.8};
    };
    (void)((I == method && (put(std::in_place_type<Worlds>), true)) || ...);
    balls_ = 0;
    time_ = 0;
  }

  /// Lets the pointer turn the camera, and the wheel move it.
  void look(const live::Page& page)
  {
    const live::Pointer& pointer = page.pointer();
    if (pointer.down && !pointer.pressed)
    {
      turn(orbit_, pointer.at.x() - last_.x(), pointer.at.y() - last_.y());
      orbit_.pitch = std::max(orbit_.pitch, 0.02);
    }
    last_ = pointer.at;
    if (pointer.wheel != 0)
    {
      zoom(orbit_, pointer.wheel > 0 ? 0.9 : 1 / 0.9);
      orbit_.distance = std::clamp(orbit_.distance, 3.0, 40.0);
    }
  }

  /// Moves the world on, and shows what is measured of it.
  template <class World>
  void run(live::Page& page, World& world)
  {
    for (int i = 0; i < page.steps(); ++i)
    {
      step(world, frame);
      time_ += frame;
    }
    const Measured measured = measure(world);
    page.plot("energy", measured.energy, "J");
    page.plot("deepest overlap", 1000 * measured.overlap, "mm");
    page.number("time", time_, "s");
    page.number("energy", measured.energy, "J");
    page.number("deepest overlap", 1000 * measured.overlap, "mm");
    page.number("contact points solved", static_cast<double>(measured.contacts));
    page.number("bodies awake", static_cast<double>(measured.awake));
    if (measured.awake == 0 || time_ > longest_run)
    {
      page.rests();
    }
  }

  /// Draws the world.
  template <class World>
  void draw(live::Page& page, const World& world, bool marks)
  {
    const int width = static_cast<int>(page.fit(500)), height = width * 5 / 8;
    if (picture_.width != 2 * width)
    {
      picture_ = make_picture(width, height, 2);
    }
    const Camera<double> camera = orbit_camera(orbit_, width, height);
    const Palette palette = page.dark() ? dark_palette() : light_palette();
    draw_world(picture_, camera, world, floor_at(0, 12), palette);
    if (marks)
    {
      draw_contacts(picture_, camera, world, 0.3, palette);
    }
    shown_ = shown(picture_);
    page.show(width, height, shown_.pixels);
  }

  Any world_;
  Orbit orbit_;
  Picture picture_, shown_;
  Vector3<double> from_{0, 0, 0};
  Vector2<double> last_{0, 0}; ///< [pixels] where the pointer was
  double aim_ = 0, time_ = 0;
  int balls_ = 0;
};

} // namespace cookbook::small_world
