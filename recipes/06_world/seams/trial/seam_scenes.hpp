#pragma once

/// \file
/// \brief Floors of flush tiles beside the slab that they continue, in twenty scenes.

#include "06_world/seams/trial/seam_runs.hpp"

#include <string>
#include <utility>
#include <vector>

namespace cookbook::seams
{

/// A scene on tiles and the same on a slab; the last body of both is the one that is compared.
struct SeamScene
{
  std::string name;
  Scene tiles, slab;
  double duration = 1; ///< [s]
};

/// A scene turned about the origin and then moved [m], with its gravity.
inline Scene transformed(Scene scene, const Quaternion<double>& turn, const Vector3<double>& way)
{
  scene.gravity = turn * scene.gravity;
  for (SceneBody& body : scene.bodies)
  {
    body.position = turn * body.position + way;
    body.orientation = turn * body.orientation;
    body.velocity = turn * body.velocity;
    body.angular_velocity = turn * body.angular_velocity;
    if (PlaneShape* const plane = std::get_if<PlaneShape>(&body.shape))
    {
      plane->normal = turn * plane->normal;
      plane->offset += plane->normal.dot(way);
    }
  }
  return scene;
}

/// Both scenes turned and moved.
inline SeamScene transformed(
    const SeamScene& scene, const std::string& name, const Quaternion<double>& turn,
    const Vector3<double>& way)
{
  return {
      name, transformed(scene.tiles, turn, way), transformed(scene.slab, turn, way),
      scene.duration};
}

/// Both with bodies added before the last one.
inline SeamScene with_bodies(SeamScene scene, const std::vector<SceneBody>& bodies)
{
  for (Scene* const one : {&scene.tiles, &scene.slab})
  {
    one->bodies.insert(one->bodies.end() - 1, bodies.begin(), bodies.end());
  }
  return scene;
}

/// The tiles changed, each by `change(body, number)`.
template <class Change>
SeamScene with_tiles(SeamScene scene, const Change& change)
{
  for (std::size_t i = 0; i + 1 < scene.tiles.bodies.size(); ++i)
  {
    change(scene.tiles.bodies[i], static_cast<int>(i));
  }
  return scene;
}

/// Both with the body changed.
template <class Change>
SeamScene with_body(SeamScene scene, const Change& change)
{
  change(scene.tiles.bodies.back());
  change(scene.slab.bodies.back());
  return scene;
}

/// A run as a scene.
inline SeamScene scene_of(const std::string& name, const SeamRun& run)
{
  return {name, on_tiles(run), on_slab(run), run.duration};
}

/// Scenes of a sphere.
inline std::vector<SeamScene> sphere_scenes()
{
  const SeamRun run{rolling_sphere(0.2, 2, 0.7, 0.1, 0.05), 0.5, 0.6, 2};
  const SeamScene rolling = scene_of("rolling", run);
  const Quaternion<double> odd = whole_turn(7, 3, -2, 5), slope = turn_about_z(-0.08, 0.9968);
  SeamScene down = transformed(rolling, "down a slope", slope, {0, 0, 0});
  down.tiles.gravity = down.slab.gravity = {0, -9.81, 0};
  const auto up = [](SceneBody& body) { body.velocity.setZero(), body.angular_velocity.setZero(); };
  std::vector<SeamScene> all{
      transformed(rolling, "on turned ground", odd, {1, 2, 3}),
      transformed(rolling, "at 1 km from the origin", {1, 0, 0, 0}, {1000, 1000, -1000}),
      down,
      scene_of(
          "on the heading mirrored", {rolling_sphere(0.2, 2, -0.7 - M_PI, 0.1, 0.05), 0.5, 0.6, 2}),
      scene_of("along a seam", {rolling_sphere(0.2, 2, 0, 0, 0.25), 0.5, 0.6, 2}),
      with_body(
          scene_of(
              "at rest on a crossing of four",
              {rolling_sphere(0.2, 0, 0, 0.25, 0.25), 0.5, 0.6, 2}),
          up),
      scene_of(
          "a sphere of 1 mm on tiles of 1.5 mm",
          {rolling_sphere(1e-3, 0.05, 0.7, 2e-4, 1e-4), 1.5e-3, 0.6, 1}),
      with_body(
          rolling,
          [](SceneBody& body) {
            body.angular_velocity = {0, 40, 0};
          }),
      with_body(rolling, [](SceneBody& body) { body.angular_velocity *= -2; }),
      with_body(rolling, [](SceneBody& body) { body.position.y() += 0.3, body.restitution = 0.5; }),
      with_tiles(rolling, [](SceneBody& body, int i) { body.position.y() += (i % 3 - 1) * 1e-6; }),
      with_tiles(
          rolling,
          [](SceneBody& body, int) { std::get<BoxShape>(body.shape).half_extents.x() -= 1e-6; }),
      with_tiles(
          rolling,
          [](SceneBody& body, int) { std::get<BoxShape>(body.shape).half_extents.x() += 0.01; }),
  };
  all[7].name = "with spin about the vertical";
  all[8].name = "with backspin";
  all[9].name = "bouncing over the seams";
  all[10].name = "on tiles uneven by 1 µm";
  all[11].name = "on tiles 2 µm apart";
  all[12].name = "on tiles that overlap by 2 cm";
  return all;
}

/// Scenes of a crate.
inline std::vector<SeamScene> crate_scenes()
{
  const SeamRun run{sliding_crate({0.3, 0.2, 0.25}, 4, 0.7, 0.4, 0.1, 0.05), 0.5, 0.3, 2};
  const SeamScene sliding = scene_of("sliding", run);
  SeamScene plane = sliding; // the floor is a plane, with tiles sunk flush into it
  plane.name = "on a plane with tiles in it";
  plane.tiles.bodies.insert(plane.tiles.bodies.begin(), ground());
  plane.tiles.bodies.front().friction = 0.3;
  SeamScene bricks = sliding; // a second layer below, shifted by half a brick
  bricks.name = "on two layers of bricks";
  for (SceneBody body : std::vector(sliding.tiles.bodies.begin(), sliding.tiles.bodies.end() - 1))
  {
    body.position += Vector3<double>(0.25, -0.5, 0.25);
    bricks.tiles.bodies.insert(bricks.tiles.bodies.begin(), body);
  }
  SeamScene first = sliding; // the crate before the tiles: it is body A of all contacts
  first.name = "the crate first";
  SceneBody on_top = box_body("top", {0.2, 0.1, 0.2}, {0.1, 0.5, 0.05});
  on_top.velocity = run.body.velocity;
  on_top.friction = 0.3;
  SeamScene stacked = with_bodies(sliding, {on_top});
  stacked.name = "under another crate";
  const auto turned = [](SceneBody& body, int i)
  { body.orientation = i % 2 == 0 ? Quaternion<double>(1, 0, 0, 0) : whole_turn(1, 0, 1, 0); };
  std::vector<SeamScene> all{
      plane,
      bricks,
      stacked,
      transformed(sliding, "on turned ground", whole_turn(7, 3, -2, 5), {1, 2, 3}),
      transformed(sliding, "at 1 km from the origin", {1, 0, 0, 0}, {1000, 1000, -1000}),
      scene_of(
          "diagonally over seams",
          {sliding_crate({0.3, 0.2, 0.3}, 4, M_PI / 4, M_PI / 4, 0, 0), 0.5, 0.3, 2}),
      scene_of(
          "perpendicular to the seams",
          {sliding_crate({0.25, 0.2, 0.25}, 4, 0, 0, 0, 0), 0.5, 0.3, 2}),
      scene_of(
          "larger than the tiles",
          {sliding_crate({0.8, 0.3, 0.7}, 4, 0.7, 0.4, 0.1, 0.05), 0.3, 0.3, 2}),
      scene_of(
          "a plank over many tiles",
          {sliding_crate({1.5, 0.05, 0.1}, 2, 0.7, 0.4, 0.1, 0.05), 0.4, 0.3, 2}),
      with_tiles(sliding, turned),
      with_body(
          sliding,
          [](SceneBody& body) {
            body.angular_velocity = {0, 3, 0};
          }),
  };
  all[9].name = "on tiles turned by 90°";
  all[10].name = "spinning";
  return all;
}

} // namespace cookbook::seams
