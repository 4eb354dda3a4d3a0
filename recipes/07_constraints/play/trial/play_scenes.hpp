#pragma once

/// \file
/// \brief The scenes that are played with, and where the camera of each begins.

#include "02_primitives/picture/orbit.hpp"
#include "06_world/scenes/trial/crowd_scenes.hpp"
#include "06_world/scenes/trial/motion_scenes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

namespace cookbook::play
{

/// A scene to choose.
struct PlayScene
{
  std::string name; ///< for a reader
  Scene (*scene)(); ///< as it begins
};

/// All of them; the first one is what a reader sees first.
inline const std::vector<PlayScene>& play_scenes()
{
  using namespace scenes;
  static const std::vector<PlayScene> all{
      {"wall of 48 bricks", [] { return wall(5); }},
      {"tower of 10", [] { return tower(10); }},
      {"twisted tower of 10", [] { return tower_turned(10); }},
      {"pyramid of 55", [] { return pyramid(10); }},
      {"20 dominoes", [] { return domino(20); }},
      {"house of cards", [] { return card_house(3); }},
      {"heap of 50 boxes", [] { return pile(50); }},
      {"64 cubes that fall", [] { return cubes(64); }},
      {"20 plates", [] { return plates(20); }},
      {"table on 4 legs", [] { return table_on(4); }},
      {"100 kg on 1 kg", [] { return heavy_on_light(100); }},
      {"cubes inside each other", [] { return overlap(); }},
      {"ball and cube that bounce", [] { return bounce(); }},
      {"cube on a slope of 30°", [] { return incline(0.5, 0.5); }},
      {"cube over flush tiles", [] { return tiles(); }},
      {"100 balls without gravity", [] { return swarm(100); }}};
  return all;
}

/// How far [m] a shape reaches from its body's centre; a plane not at all.
inline double reach_of(const SceneBody& body)
{
  if (const auto* const box = std::get_if<BoxShape>(&body.shape))
  {
    return box->half_extents.norm();
  }
  const auto* const sphere = std::get_if<SphereShape>(&body.shape);
  return sphere != nullptr ? sphere->radius : 0;
}

/// A camera's orbit from which all of a scene's bodies are seen.
inline Orbit orbit_around(const Scene& scene)
{
  Eigen::AlignedBox<double, 3> around;
  for (const SceneBody& body : scene.bodies)
  {
    const Vector3<double> reach = Vector3<double>::Constant(reach_of(body));
    if (!std::holds_alternative<PlaneShape>(body.shape))
    {
      around.extend(Vector3<double>(body.position - reach));
      around.extend(Vector3<double>(body.position + reach));
    }
  }
  if (around.isEmpty())
  {
    return {};
  }
  const Vector3<double> middle = around.center(), sides = around.sizes();
  const double distance = 2 + 0.75 * std::max(sides.x(), 1.6 * sides.y()) + 0.3 * sides.z();
  return {.target = middle, .distance = distance, .yaw = 0.45, .pitch = 0.28};
}

} // namespace cookbook::play
