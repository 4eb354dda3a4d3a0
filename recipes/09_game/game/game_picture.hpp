#pragma once

/// \file
/// \brief The game as a picture: the sling with its bird, bricks, pigs, and where the bird will
/// fly.

// [head]
#include "02_primitives/picture/picture.hpp"
#include "09_game/game/game.hpp"

namespace cookbook::game
{
// [head]

// [camera]
/// The camera of a picture of width × height pixels: from the side, a little raised.
inline Camera<double> game_camera(int width, int height)
{
  return orbit_camera({{7.3, 3.4, 0}, 24.5, 0, 0.13, 0.52}, width, height);
}

/// The pull [m] for which the bird is under a pixel: the pixel's ray meets the plane z = 0 there.
inline Vector2<double> pull_at(const Camera<double>& camera, const Vector2<double>& pixel)
{
  const Ray<double> ray = picking_ray(camera, pixel);
  const double time = -ray.origin.z() / ray.direction.z();
  return (ray.origin + time * ray.direction - sling).head<2>();
}
// [camera]

// [colours]
/// A meadow by day, or by night where the page is dark.
inline Palette meadow(bool dark)
{
  Palette palette = dark ? dark_palette() : light_palette();
  palette.sky = dark ? Colour{20, 28, 46} : Colour{142, 200, 238};
  palette.horizon = dark ? Colour{44, 58, 84} : Colour{226, 241, 250};
  palette.ground = dark ? Colour{40, 62, 44} : Colour{158, 197, 112};
  palette.grid = dark ? Colour{46, 70, 50} : Colour{150, 189, 105};
  return palette;
}

inline constexpr Colour wood_colour{201, 151, 88};
inline constexpr Colour stone_colour{134, 142, 150};
inline constexpr Colour bird_colour{206, 44, 48};
inline constexpr Colour pig_colour{240, 150, 164};
inline constexpr Colour dark_colour{40, 36, 34};

/// What the picture shows a body as.
enum class Look
{
  none, ///< it is out of the game
  bird,
  pig,
  wood,
  stone
};

/// The look of the body at a place in the world's list.
inline Look look_of(const Game& game, std::size_t i)
{
  const small_world::RigidBody& body = game.world.bodies[i];
  if (body.motion.center.y() < -10)
  {
    return Look::none;
  }
  if (body.is_sphere)
  {
    return i < game.first_pig ? Look::bird : Look::pig;
  }
  const double density = 1 / (body.inverse_mass * 8 * body.half_extents.prod());
  return density > 1000 ? Look::stone : Look::wood;
}
// [colours]

// [face]
/// What all parts of a picture are drawn into.
struct Stage
{
  Picture picture;
  Camera<double> camera;
};

/// A small sphere on another: at `place`, in units of its radius and in its own axes.
inline void draw_on(
    Stage& stage, const small_world::RigidBody& body, const Vector3<double>& place, double size,
    const Colour& colour)
{
  const double radius = body.half_extents.x();
  const Vector3<double> center = body.motion.center + body.orientation * (radius * place);
  draw_sphere(
      stage.picture, stage.camera, {center, size * radius}, Matrix3<double>::Identity(), colour);
}

/// Two eyes, and a beak or a snout.
inline void draw_face(Stage& stage, const small_world::RigidBody& body, Look look)
{
  const bool is_bird = look == Look::bird;
  const Vector3<double> nose = is_bird ? Vector3<double>(0.85, 0, 0.5) : Vector3<double>(0, 0, 0.9);
  draw_on(stage, body, nose, 0.3, is_bird ? Colour{240, 176, 40} : lit(pig_colour, 0.8));
  for (const double side : {-1.0, 1.0})
  {
    const Vector3<double> eye = is_bird ? Vector3<double>(0.45 + 0.25 * side, 0.45, 0.7)
                                        : Vector3<double>(0.45 * side, 0.4, 0.75);
    draw_on(stage, body, eye, 0.22, {255, 255, 255});
    draw_on(stage, body, eye + Vector3<double>(0.03, 0, 0.16), 0.1, dark_colour);
  }
}
// [face]

// [draw_body]
/// Draws a body that looks like this.
inline void draw_body(Stage& stage, const small_world::RigidBody& body, Look look)
{
  if (look == Look::wood || look == Look::stone)
  {
    draw_box(
        stage.picture, stage.camera, small_world::box_of(body),
        look == Look::wood ? wood_colour : stone_colour);
    return;
  }
  draw_sphere(
      stage.picture, stage.camera, small_world::sphere_of(body),
      body.orientation.toRotationMatrix(), look == Look::bird ? bird_colour : pig_colour);
  draw_face(stage, body, look);
}

/// Draws the sling's two posts, its rubber, and dots where a bird that is pulled will fly.
inline void draw_sling(Stage& stage, const Game& game)
{
  for (const double side : {-0.3, 0.3})
  {
    const Vector3<double> foot(0, 1, side), top(0, 2.1, side);
    draw_box(
        stage.picture, stage.camera, {foot, Matrix3<double>::Identity(), {0.07, 1.1, 0.07}},
        lit(wood_colour, 0.6));
    draw_segment(stage.picture, stage.camera, {top, sling + game.pull}, dark_colour, 2.5);
  }
  for (int i = 1; i < 40 && !game.pull.isZero(0) && flight(game, 0.05 * i).y() > 0; ++i)
  {
    draw_dot(stage.picture, stage.camera, flight(game, 0.05 * i), bird_colour, 2);
  }
}
// [draw_body]

// [draw]
/// The game in a picture of width × height pixels.
inline Picture draw(const Game& game, int width, int height, bool dark)
{
  const Palette palette = meadow(dark);
  Stage stage{make_picture(width, height, 2), game_camera(width, height)};
  clear(stage.picture, palette);
  const Obb<double> ground = floor_at(0, 60);
  draw_ground(stage.picture, stage.camera, ground, palette);
  for (std::size_t i = 1; i < game.world.bodies.size(); ++i)
  {
    const small_world::RigidBody& body = game.world.bodies[i];
    const auto cast = [&](const auto& shape)
    { draw_shadow(stage.picture, stage.camera, ground, shape, palette.shadow); };
    body.is_sphere ? cast(small_world::sphere_of(body)) : cast(small_world::box_of(body));
  }
  draw_sling(stage, game);
  for (std::size_t i = 1; i < game.world.bodies.size(); ++i)
  {
    const Look look = look_of(game, i);
    if (look != Look::none)
    {
      draw_body(stage, game.world.bodies[i], look);
    }
  }
  return shown(stage.picture);
}
// [draw]

} // namespace cookbook::game
