#pragma once

/// \file
/// \brief The figure of box_box: manifolds with their normal, depth and points.

#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_box/trial/box_box_scenes.hpp"
#include "tools/plot/panel.hpp"

#include <optional>
#include <string>

namespace cookbook
{

/// All scenes whose boxes meet, side by side.
inline std::string manifolds_figure()
{
  plot::Grid grid("box_box", "", 2);
  grid.describe("Pairs of boxes with the normal, the depth and the points of their manifold.");
  for (const BoxScene& scene : box_box_scenes())
  {
    if (const std::optional<Manifold<double>> manifold = box_box(scene.a, scene.b))
    {
      grid.add(contacts_figure(scene, *manifold, {2.5, scene.pitch, 189, 190, 22}));
    }
  }
  return grid.svg();
}

} // namespace cookbook
