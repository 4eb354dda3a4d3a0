#pragma once

/// \file
/// \brief The figure of box_box: manifolds with their normal, depth and points.

#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_box/trial/box_box_scenes.hpp"
#include "common/plot/figures/figure3d.hpp"
#include "common/plot/panel.hpp"
#include "common/program/table.hpp"

#include <cmath>
#include <string>

namespace cookbook
{

/// The boxes of a scene with their manifold, which there must be; each point has its own depth.
inline plot::Figure3d manifold_figure(const BoxScene& scene)
{
  const Manifold<double> manifold = box_box(scene.a, scene.b).value();
  plot::Figure3d figure("box_box", scene.name, {2.5, 0.4, 300, 290});
  figure.box(scene.a.center, scene.a.axes, scene.a.half_extents, plot::Ink::a)
      .box(scene.b.center, scene.b.axes, scene.b.half_extents, plot::Ink::b);
  Vector3<double> middle(0, 0, 0);
  for (const ContactPoint<double>& point : manifold.points)
  {
    const Vector3<double> half = manifold.normal * point.depth / 2;
    figure.segment(point.position - half, point.position + half, plot::Ink::overlap)
        .point(point.position, plot::Ink::overlap);
    middle += point.position / static_cast<double>(manifold.points.size());
  }
  const std::string depth = number(std::round(manifold.depth * 1e3) * 1e-3);
  return figure.label(scene.label_a, "A", plot::Side::centre, plot::Ink::a)
      .label(scene.label_b, "B", plot::Side::centre, plot::Ink::b)
      .arrow(middle, middle + 0.7 * manifold.normal, plot::Ink::ink, "depth " + depth);
}

/// All scenes whose boxes meet, side by side.
inline std::string manifolds_figure()
{
  plot::Grid grid("box_box", "", 3);
  grid.describe("Pairs of boxes with the normal, the depth and the points of their manifold.");
  for (const BoxScene& scene : box_box_scenes())
  {
    if (box_box(scene.a, scene.b))
    {
      grid.add(manifold_figure(scene));
    }
  }
  return grid.svg();
}

} // namespace cookbook
