#pragma once

/// \file
/// \brief Pictures of lengths and angles: Pythagoras twice, the triangle of dot and cross product,
/// and the steps of the arc cosine.

#include "01_math/angles/trial/angles_cases.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/figures/figure3d.hpp"

#include <string>
#include <vector>

namespace cookbook
{

/// The diagonal of a box, and the right triangle whose sides are a·b and |a × b|.
inline plot::Grid lengths_figure()
{
  using Space = Eigen::Vector3d;
  using Plane = Eigen::Vector2d;
  using plot::Ink;
  using plot::Side;
  const Space origin(0, 0, 0), x(3, 0, 0), z(3, 0, 2), v(3, 2, 2);
  plot::Figure3d box(
      "lengths_box", "Pythagoras, twice",
      {.yaw = -0.45, .pitch = 0.3, .width = 400, .height = 270, .margin = 26});
  box.describe("A vector as the diagonal of a box, over the diagonal of the box's floor.")
      .box(v / 2, Eigen::Matrix3d::Identity(), v / 2, Ink::muted)
      .polygon({origin, z, v}, Ink::overlap, plot::Fill::wash)
      .segment(origin, z, Ink::muted, plot::Stroke::dashed)
      .arrow(origin, v, Ink::a)
      .label(v / 2, "v", Side::above, Ink::a)
      .label(x / 2, "v_{1}", Side::above, Ink::ink)
      .label((x + z) / 2, "v_{3}", Side::right, Ink::ink)
      .label((z + v) / 2, "v_{2}", Side::right, Ink::ink);
  const Plane start(0, 0), corner(4, 0), end(4, 3);
  plot::Figure2d triangle(
      "lengths_triangle", "Two sides give the angle", {{-0.6, -0.9}, {5.6, 3.5}, 400});
  triangle.describe("A right triangle with the sides a·b and |a × b|, and the angle of a and b.")
      .polygon({start, corner, end}, Ink::muted, plot::Fill::wash)
      .segment({3.7, 0}, {3.7, 0.3}, Ink::muted)
      .segment({3.7, 0.3}, {4, 0.3}, Ink::muted)
      .arrow(start, {2.1, 0}, Ink::a)
      .arrow(start, {2.0, 1.5}, Ink::b)
      .label({1.7, 0}, "a", Side::above, Ink::a)
      .label({1.6, 1.2}, "b", Side::above_left, Ink::b)
      .dimension(start, corner, "a · b = |a| |b| cos θ", -16, Ink::ink)
      .label({4, 1.7}, "|a × b|", Side::right, Ink::ink)
      .label({4, 1.25}, "= |a| |b| sin θ", Side::right, Ink::ink)
      .angle(start, 0.8, 0, std::atan2(3.0, 4.0), "θ");
  plot::Grid grid("lengths", "", 1);
  grid.describe("The length of a vector by Pythagoras; the angle of two vectors as a triangle's.");
  grid.add(box).add(triangle);
  return grid;
}

/// What the arc cosine and the arc tangent of floats find for angles up to a thousandth.
inline plot::Chart steps_chart(const std::string& name = "angles_steps", double width = 400)
{
  plot::Chart chart(
      name, "", {"angle between the vectors [0.001 rad]", plot::Scale::linear, 0, 1},
      {"angle found [0.001 rad]", plot::Scale::linear, 0, 1.2});
  std::vector<Eigen::Vector2d> by_cosine, by_both;
  for (int i = 0; i <= 400; ++i)
  {
    const double angle = i / 400.0 * 1e-3;
    const Vector3<float> a(1, 0, 0), b = turned_by_half_tangent<float>(angle / 2);
    const auto at = [&](float found)
    { return Eigen::Vector2d(angle * 1e3, static_cast<double>(found) * 1e3); };
    by_cosine.push_back(at(std::acos(a.dot(b))));
    by_both.push_back(at(cookbook::angle(a, b)));
  }
  chart.describe("The arc cosine finds only a few angles below a thousandth; atan2 finds all.")
      .line("acos", by_cosine, plot::series_look(1))
      .line("recommended", by_both, plot::series_look(0))
      .legend(plot::Legend::below)
      .size(width, 330);
  return chart;
}

} // namespace cookbook
