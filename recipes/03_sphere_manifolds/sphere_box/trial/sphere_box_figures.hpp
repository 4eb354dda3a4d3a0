#pragma once

/// \file
/// \brief A ball and its manifold with a box, as a picture.

#include "02_primitives/shapes/shapes.hpp"
#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "tools/plot/figures/figure2d.hpp"

#include <string>

namespace cookbook
{

/// Draws a ball, its contact point, and by which move it leaves the box; dotted where it then is.
inline void add_way_out(
    plot::Figure2d& figure, const Sphere<double>& sphere, const Manifold<double>& manifold,
    const std::string& move)
{
  const Eigen::Vector2d center = sphere.center.head<2>();
  const Eigen::Vector2d out = -manifold.normal.head<2>();
  figure
      .circle(
          center + manifold.depth * out, sphere.radius, plot::Ink::faint, plot::Fill::none,
          plot::Stroke::dotted)
      .circle(center, sphere.radius, plot::Ink::a)
      .arrow(center, center + manifold.depth * out, plot::Ink::overlap, move)
      .dot(center, plot::Ink::a)
      .point(manifold.points[0].position.head<2>());
}

} // namespace cookbook
