#pragma once

/// \file
/// \brief The figure of two spheres, with their manifold where they overlap.

#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/program/table.hpp"

#include <optional>

namespace cookbook
{

/// Adds normal, depth and contact point to the figure of two spheres; the depth stands so many
/// pixels to the left of the normal.
inline void add_manifold(
    plot::Figure2d& figure, const Sphere<double>& a, const Sphere<double>& b,
    const Manifold<double>& manifold, double offset = -130)
{
  const Eigen::Vector2d n = manifold.normal.head<2>();
  const Eigen::Vector2d deepest_a = a.center.head<2>() + a.radius * n;
  const Eigen::Vector2d deepest_b = b.center.head<2>() - b.radius * n;
  figure
      .dimension(
          deepest_b, deepest_a, "depth d = " + number(manifold.depth), offset, plot::Ink::overlap)
      .dot(a.center.head<2>(), plot::Ink::a, "A", plot::Side::left)
      .dot(b.center.head<2>(), plot::Ink::b, "B", plot::Side::right)
      .arrow(deepest_a, deepest_a + 0.4 * n, plot::Ink::ink, "n", plot::Side::above)
      .dot(deepest_a, plot::Ink::a, "a", plot::Side::above)
      .dot(deepest_b, plot::Ink::b, "b", plot::Side::above)
      .point(
          manifold.points[0].position.head<2>(), plot::Ink::ink, "contact point",
          plot::Side::below);
}

/// Two spheres in the plane z = 0, their radii, their distance and their overlap.
inline plot::Figure2d
spheres_figure(const Sphere<double>& a, const Sphere<double>& b, const plot::View& view)
{
  const Eigen::Vector2d center_a = a.center.head<2>(), center_b = b.center.head<2>();
  plot::Figure2d figure("sphere_sphere", "", view);
  figure.circle(center_a, a.radius, plot::Ink::a)
      .circle(center_b, b.radius, plot::Ink::b)
      .lens(center_a, a.radius, center_b, b.radius)
      .dimension(
          center_a, center_a + a.radius * Eigen::Vector2d(-0.6, 0.8), "r_{A}", 0, plot::Ink::a)
      .dimension(
          center_b, center_b + b.radius * Eigen::Vector2d(0.6, 0.8), "r_{B}", 0, plot::Ink::b)
      .dimension(center_a, center_b, "|t|", 62, plot::Ink::ink);
  return figure;
}

/// Two spheres in the plane z = 0: radii, distance, and the manifold where they overlap.
inline plot::Figure2d sphere_sphere_figure(const Sphere<double>& a, const Sphere<double>& b)
{
  plot::Figure2d figure = spheres_figure(a, b, {{-1.1, -1.45}, {2.6, 1.15}, 400});
  figure.describe("Two unit spheres, 1.5 apart, with normal, depth and contact point.");
  if (const std::optional<Manifold<double>> manifold = plain_sphere_sphere(a, b))
  {
    add_manifold(figure, a, b, *manifold);
  }
  return figure;
}

} // namespace cookbook
