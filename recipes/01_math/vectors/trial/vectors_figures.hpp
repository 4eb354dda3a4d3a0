#pragma once

/// \file
/// \brief Pictures of vectors: components, sums, the dot and the cross product, mirror images.

#include "01_math/numbers/difference_of_products.hpp"
#include "01_math/vectors/vectors.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/figures/figure3d.hpp"

namespace cookbook
{

/// An arrow with its components, and two arrows tip to tail.
inline plot::Grid adding_figure()
{
  using Plane = Eigen::Vector2d;
  using plot::Ink;
  using plot::Side;
  const Plane origin(0, 0), a(4, 3);
  plot::Figure2d parts("vectors_parts", "A vector is a step", {{-0.9, -1.0}, {6.0, 3.7}, 400});
  parts.describe("The vector (4, 3): four to the right, three up, and five long.")
      .grid(1)
      .segment(origin, {4, 0}, Ink::muted, plot::Stroke::dashed)
      .segment({4, 0}, a, Ink::muted, plot::Stroke::dashed)
      .arrow(origin, a, Ink::a)
      .label({1.9, 2.15}, "a = (4, 3)", Side::above, Ink::a)
      .dimension(origin, {4, 0}, "a_{1} = 4", -14, Ink::ink)
      .dimension({4, 0}, a, "a_{2} = 3", -14, Ink::ink);
  const Plane p(3, 1), q(1.5, 2);
  plot::Figure2d sum("vectors_sum", "Adding: tip to tail", {{-0.9, -0.6}, {6.0, 3.7}, 400});
  sum.describe("The sum of two vectors, drawn tip to tail in both orders.")
      .grid(1)
      .segment(origin, q, Ink::b, plot::Stroke::dashed)
      .segment(q, p + q, Ink::a, plot::Stroke::dashed)
      .arrow(origin, p, Ink::a)
      .arrow(p, p + q, Ink::b)
      .arrow(origin, p + q)
      .label({2.0, 0.55}, "a", Side::below_right, Ink::a)
      .label({3.85, 2.0}, "b", Side::right, Ink::b)
      .label({2.3, 1.6}, "a + b", Side::above_left, Ink::ink);
  plot::Grid grid("vectors", "", 1);
  grid.describe("A vector and its components; the sum of two vectors, tip to tail.");
  grid.add(parts).add(sum);
  return grid;
}

/// Projections on the line of n: the dot products, and the parts along and across.
inline plot::Figure2d dot_figure()
{
  using Plane = Eigen::Vector2d;
  using plot::Ink;
  using plot::Side;
  const Plane origin(0, 0), a(4, 3), c(-2, 3), square(0, 2.6);
  plot::Figure2d figure("vectors_dot", "", {{-3.0, -1.25}, {5.6, 3.8}, 400});
  figure
      .describe("Three vectors over the line of a unit vector, with their projections 4, 0 and -2.")
      .segment({-2.9, 0}, {5.5, 0}, Ink::faint)
      .segment(a, {4, 0}, Ink::muted, plot::Stroke::dashed)
      .segment(c, {-2, 0}, Ink::muted, plot::Stroke::dashed)
      .arrow(origin, a, Ink::a)
      .arrow(origin, c, Ink::b)
      .arrow(origin, square, Ink::muted)
      .arrow(origin, {1, 0})
      .label({0.7, 0}, "n", Side::above, Ink::ink)
      .label({2.2, 1.65}, "a", Side::above_left, Ink::a)
      .label({-1.15, 1.7}, "c", Side::below_left, Ink::b)
      .label({0, 2.6}, "e · n = 0", Side::above, Ink::muted)
      .label({4, 1.5}, "perp_{n} a", Side::right, Ink::muted)
      .dimension(origin, {4, 0}, "a · n = 4", -16, Ink::ink)
      .dimension({-2, 0}, origin, "c · n = −2", -16, Ink::ink)
      .angle(origin, 1.6, 0, std::atan2(3.0, 4.0), "θ");
  return figure;
}

/// The cross product over its parallelogram, with the turn from a to b.
inline plot::Figure3d cross_figure()
{
  using Space = Eigen::Vector3d;
  using plot::Ink;
  using plot::Side;
  const Space origin(0, 0, 0), a(0.35, 0, 1.5), b(1.6, 0, 0.25);
  const Space up = 0.65 * accurate_cross<double>(a, b);
  std::vector<Space> arc;
  for (int i = 0; i <= 16; ++i)
  {
    const Space at = lerp<double>(a, b, i / 16.0);
    arc.push_back(at * (0.62 / at.norm()));
  }
  plot::Figure3d figure(
      "vectors_cross", "", {.yaw = 0.35, .pitch = 0.5, .width = 400, .height = 330});
  figure
      .describe("Two vectors, their parallelogram, and the cross product at right angles to both.")
      .polygon({origin, a, a + b, b}, Ink::overlap, plot::Fill::wash)
      .polyline(arc, Ink::muted)
      .arrow(arc[14], arc[16], Ink::muted)
      .arrow(origin, a, Ink::a, "a", Side::left)
      .arrow(origin, b, Ink::b, "b", Side::right)
      .arrow(origin, up, Ink::ink, "a × b", Side::right)
      .label(0.62 * (a + b), "area |a × b|", Side::centre, Ink::overlap);
  return figure;
}

/// A ball's velocity before and after a wall, with its parts.
inline plot::Figure2d mirror_figure()
{
  using Plane = Eigen::Vector2d;
  using plot::Ink;
  using plot::Side;
  const Vector3<double> v(3, -2, 0), n(0, 1, 0);
  const Plane in = v.head<2>(), out = reflect<double>(v, n).head<2>(), origin(0, 0);
  plot::Figure2d figure("vectors_reflect", "", {{-3.5, -0.7}, {4.1, 2.6}, 400});
  figure.describe("A velocity that hits a floor, and its mirror image.")
      .half_plane({0, 1}, 0)
      .arrow(origin - in, origin, Ink::a)
      .arrow(origin, out, Ink::b)
      .segment(out, {3, 0}, Ink::muted, plot::Stroke::dashed)
      .arrow(origin, {0, 1}, Ink::ink, "n", Side::above)
      .label({-1.4, 0.95}, "v", Side::below_left, Ink::a)
      .label({1.4, 0.95}, "v'", Side::above_left, Ink::b)
      .label({1.9, 0}, "across: kept", Side::above, Ink::muted)
      .label({3, 1.0}, "along:", Side::right, Ink::muted)
      .label({3, 0.6}, "turned", Side::right, Ink::muted);
  return figure;
}

} // namespace cookbook
