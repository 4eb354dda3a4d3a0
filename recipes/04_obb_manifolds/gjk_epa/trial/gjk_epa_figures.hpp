#pragma once

/// \file
/// \brief What gjk_epa draws: the Minkowski difference, the polytope in its solid, and the error
/// while it grows.

#include "04_obb_manifolds/gjk_epa/gjk_epa.hpp"
#include "04_obb_manifolds/gjk_epa/trial/gjk_epa_cases.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/figures/figure3d.hpp"
#include "tools/plot/panel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace cookbook
{

/// Draws two boxes seen along z, and beside them their solid A ⊖ B about the origin.
inline void add_minkowski_difference(
    plot::Grid& grid, const Obb<double>& a, const Obb<double>& b, double turn_b,
    const std::string& title, const std::string& solid_title)
{
  const auto plane = [](const Vector3<double>& v) -> Eigen::Vector2d { return v.head<2>(); };
  plot::Figure2d boxes("boxes", title, {{-1, -1.45}, {3.1, 1.45}, 189});
  boxes.box(plane(a.center), 0, plane(a.half_extents), plot::Ink::a)
      .box(plane(b.center), turn_b, plane(b.half_extents), plot::Ink::b)
      .dot(plane(a.center), plot::Ink::a, "A")
      .dot(plane(b.center), plot::Ink::b, "B");
  // Midway between two neighbouring edge normals the farthest point is a corner.
  const MinkowskiDifference<double> support{relative_boxes(a, b)};
  std::vector<Eigen::Vector2d> corners;
  for (int eighth = 0; eighth < 8; ++eighth)
  {
    const double way = eighth * std::numbers::pi / 4 + turn_b / 2;
    corners.push_back(plane(support({std::cos(way), std::sin(way), 0}).point));
  }
  plot::Figure2d solid("solid", solid_title, {{-3.2, -1.6}, {0.9, 1.3}, 189});
  solid.polygon(corners, plot::Ink::ink)
      .label(plane(-b.center) - Eigen::Vector2d(0.2, 0.6), "A ⊖ B", plot::Side::centre)
      .dot({0, 0}, plot::Ink::ink, "0", plot::Side::below);
  if (const std::optional<Manifold<double>> manifold = gjk_epa(a, b))
  {
    solid.dimension({0, 0}, plane(manifold->depth * manifold->normal), "depth");
  }
  grid.add(boxes).add(solid);
}

/// Two boxes apart and overlapping: their solid holds the origin only where they overlap; O18.
inline plot::Grid minkowski_grid()
{
  const Obb<double> a = upright({0, 0, 0}, {0.7, 0.5, 2});
  const double turn = 0.6;
  const auto b = [turn](double x, double y) {
    return Obb<double>{{x, y, 0}, turned(turn, {0, 0, 1}), {0.6, 0.4, 2}};
  };
  plot::Grid grid("gjk_epa_minkowski_difference", "", 2);
  grid.describe("Two boxes and their Minkowski difference, apart and overlapping.");
  add_minkowski_difference(grid, a, b(1.7, 0.3), turn, "Apart", "0 is outside");
  add_minkowski_difference(grid, a, b(0.7, 0.3), turn, "Overlapping", "0 is inside");
  return grid;
}

/// Draws the faces of A ⊖ B that the camera sees: one for each pair of six edge directions; O1.
inline void draw_solid(plot::Figure3d& figure, const RelativeBoxes<double>& boxes)
{
  std::vector<Vector3<double>> edges;
  for (int i = 0; i < 3; ++i)
  {
    edges.push_back(boxes.half_a[i] * Vector3<double>::Unit(i));
    edges.push_back(boxes.half_b[i] * boxes.rotation.col(i));
  }
  const MinkowskiDifference<double> support{boxes};
  for (std::size_t j = 0; j < edges.size(); ++j)
  {
    for (std::size_t i = 0; i < j; ++i)
    {
      const Vector3<double> across = edges[i].cross(edges[j]);
      const double front = (figure.to_camera(across) - figure.to_camera({0, 0, 0})).z();
      const Vector3<double> out = front < 0 ? Vector3<double>(-across) : across;
      if (out.norm() < 1e-9)
      {
        continue;
      }
      const Vector3<double> u = 2 * edges[i], v = 2 * edges[j];
      const Vector3<double> p = support(out + 1e-6 * (u + v)).point;
      figure.polygon(
          {p, p - u, p - u - v, p - v}, plot::Ink::muted, plot::Fill::none, plot::Stroke::dotted);
    }
  }
}

/// Draws a polytope in its solid, hidden faces dashed, the closest face red, and the way there from
/// the origin.
inline plot::Figure3d polytope_figure(
    const RelativeBoxes<double>& boxes, const Expansion<double>& expansion,
    const std::string& title)
{
  plot::Figure3d figure("gjk_epa", title, {1.3, 0.3, 189, 190, 8});
  draw_solid(figure, boxes);
  const Polytope<double>& polytope = expansion.polytope;
  const PolytopeFace<double>& closest = polytope.faces[closest_face(polytope)];
  for (std::size_t f = 0; f < polytope.face_count; ++f)
  {
    const PolytopeFace<double>& face = polytope.faces[f];
    const auto corner = [&](std::size_t i) { return polytope.corner(face, i).point; };
    const bool is_closest = &face == &closest;
    const bool is_hidden = (figure.to_camera(face.normal) - figure.to_camera({0, 0, 0})).z() < 0;
    figure.polygon(
        {corner(0), corner(1), corner(2)}, is_closest ? plot::Ink::overlap : plot::Ink::a,
        is_closest || !is_hidden ? plot::Fill::wash : plot::Fill::none,
        is_hidden ? plot::Stroke::dashed : plot::Stroke::solid);
  }
  return figure.arrow({0, 0, 0}, closest.distance * closest.normal, plot::Ink::overlap)
      .arrow({0, 0, 0}, {0, 0, 0}, plot::Ink::ink, "0", plot::Side::right);
}

/// Draws how a polytope grows from GJK's tetrahedron to the face that counts.
inline plot::Grid polytope_steps(const Obb<double>& a, const Obb<double>& b)
{
  const RelativeBoxes<double> boxes = relative_boxes(a, b);
  const MinkowskiDifference<double> support{boxes};
  const double tolerance = rounding_tolerance(boxes);
  Expansion<double> expansion =
      start_expansion(support, gjk(support, boxes.offset, tolerance).simplex, tolerance);
  plot::Grid grid("gjk_epa", "", 2);
  grid.describe("A tetrahedron in the Minkowski difference grows towards the closest face.");
  for (bool more = true; more; more = expand(expansion, support))
  {
    const std::string corners = std::to_string(expansion.polytope.corner_count);
    grid.add(polytope_figure(boxes, expansion, corners + " corners"));
  }
  return grid;
}

/// How far the best depth [m] is above the right one after each direction that EPA tries.
inline std::vector<double> excess_by_step(const ConvexPair<double>& pair, double depth)
{
  const double tolerance = tolerance_of(pair);
  Expansion<double> expansion =
      start_expansion(pair.support, gjk(pair.support, pair.start, tolerance).simplex, tolerance);
  std::vector<double> excess;
  bool more = true;
  while (static_cast<int>(excess.size()) < epa_limit)
  {
    more = more && expand(expansion, pair.support);
    // What is below a few roundings is drawn as none.
    const double above = expansion.depth - depth;
    excess.push_back(above < tolerance ? 0 : above);
  }
  return excess;
}

/// The chart of the error against the directions tried.
inline plot::Chart excess_chart(int pairs)
{
  plot::Chart chart(
      "gjk_epa_error", "", {"directions tried", plot::Scale::linear, 0.0, 64.0},
      {"depth so far less the depth [m]", plot::Scale::log});
  chart.describe("Boxes end exactly after a few steps; two spheres creep and never end.")
      .size(400, 340);
  std::vector<std::vector<double>> by_step(static_cast<std::size_t>(epa_limit));
  RandomCubes draw(2);
  for (int i = 0; i < pairs; ++i)
  {
    const Obb<double> a = draw.next(), b = draw.next();
    const double separation = largest_separation(a, b);
    if (separation < 0)
    {
      const std::vector<double> excess = excess_by_step(convex_pair(a, b), -separation);
      for (std::size_t step = 0; step < excess.size(); ++step)
      {
        by_step[step].push_back(excess[step]);
      }
    }
  }
  std::vector<Eigen::Vector2d> worst, median, spheres;
  const std::vector<double> of_spheres = excess_by_step(two_spheres(), two_spheres_depth);
  for (std::size_t step = 0; step < by_step.size(); ++step)
  {
    std::sort(by_step[step].begin(), by_step[step].end());
    const double x = static_cast<double>(step + 1);
    worst.push_back({x, by_step[step].back()});
    median.push_back({x, by_step[step][by_step[step].size() / 2]});
    spheres.push_back({x, of_spheres[step]});
  }
  chart.line("cubes, worst", worst).line("cubes, median", median).line("two spheres", spheres);
  return chart;
}

} // namespace cookbook
