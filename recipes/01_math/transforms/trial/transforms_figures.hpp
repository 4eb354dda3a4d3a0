#pragma once

/// \file
/// \brief The figures of transforms: two orders, a normal through a scale, a pose and its inverse.

#include "01_math/transforms/transforms.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/panel.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// A house with a chimney, turned and then moved: it shows where a pose sends things.
inline void draw_house(
    plot::Figure2d& figure, double angle, const Eigen::Vector2d& move, plot::Ink ink,
    plot::Stroke stroke = plot::Stroke::solid)
{
  const Eigen::Rotation2Dd turn(angle);
  std::vector<Eigen::Vector2d> corners;
  for (const Eigen::Vector2d& corner : std::vector<Eigen::Vector2d>{
           {-0.4, -0.4},
           {0.4, -0.4},
           {0.4, 0.2},
           {0.3, 0.3},
           {0.3, 0.55},
           {0.15, 0.55},
           {0.15, 0.45},
           {0, 0.6},
           {-0.4, 0.2}})
  {
    corners.push_back(turn * corner + move);
  }
  figure.polygon(corners, ink, plot::Fill::wash, stroke);
}

/// One order of turning and moving: what stands first is drawn dashed.
inline plot::Figure2d order_figure(bool turn_first)
{
  const double angle = 0.9;
  const Eigen::Vector2d move(2.2, 0), zero(0, 0);
  const Eigen::Vector2d end = turn_first ? move : Eigen::Rotation2Dd(angle) * move;
  plot::Figure2d figure(
      turn_first ? "turn_move" : "move_turn", turn_first ? "turn, then move" : "move, then turn",
      {{-0.8, -0.7}, {3.2, turn_first ? 0.9 : 2.5}, 400});
  figure.axes(1);
  draw_house(figure, 0, zero, plot::Ink::a);
  draw_house(
      figure, turn_first ? angle : 0, turn_first ? zero : move, plot::Ink::muted,
      plot::Stroke::dashed);
  draw_house(figure, angle, end, plot::Ink::b);
  if (turn_first)
  {
    figure.angle(zero, 0.75, 0, angle).arrow(zero, 0.95 * move, plot::Ink::ink, "");
  }
  else
  {
    figure.arrow(zero, 0.95 * move, plot::Ink::ink, "").angle(zero, 2.2, 0, angle);
  }
  return figure;
}

/// A ramp before and after a scale along x, with the normal by M and the right one.
inline plot::Figure2d normal_figure(bool after)
{
  const double stretch = after ? 3 : 1;
  const Eigen::Vector2d foot(0, 1), end(stretch, 0), middle(stretch / 2, 0.5);
  const Eigen::Vector2d n = Eigen::Vector2d(1, 1).normalized();
  plot::Figure2d figure(
      after ? "normal_after" : "normal_before", after ? "after Scale(3, 1)" : "before",
      {{-0.3, -0.15}, {3.5, after ? 1.45 : 1.4}, 400});
  figure.polygon({{0, 0}, end, foot}, plot::Ink::a);
  if (!after)
  {
    figure.arrow(middle, middle + 0.8 * n, plot::Ink::ink, "n", plot::Side::right);
    return figure;
  }
  const Eigen::Vector2d by_matrix(3 * n.x(), n.y()), right(n.x() / 3, n.y());
  figure
      .arrow(
          middle, middle + 0.8 * by_matrix.normalized(), plot::Ink::overlap, "M n",
          plot::Side::right)
      .arrow(middle, middle + 0.8 * right.normalized(), plot::Ink::ink, "n'", plot::Side::above)
      .angle(middle, 0.3, std::atan2(-1.0, 3.0), std::atan2(3.0, 1.0), "90°");
  return figure;
}

/// A pose carries the body's frame into the world; its inverse carries the world's frame back.
inline plot::Figure2d pose_figure()
{
  const double angle = 0.6;
  const Eigen::Rotation2Dd turn(angle);
  const Eigen::Vector2d zero(0, 0), move(2.3, 0.7);
  plot::Figure2d figure("pose", "", {{-0.5, -0.45}, {3.9, 2.2}, 400});
  figure.describe("A pose of a body: its axes in the world, and where its origin is.")
      .arrow(zero, {0.9, 0}, plot::Ink::a, "x", plot::Side::below)
      .arrow(zero, {0, 0.9}, plot::Ink::a, "y", plot::Side::left)
      .arrow(move, move + turn * Eigen::Vector2d(0.9, 0), plot::Ink::b, "column 0")
      .arrow(
          move, move + turn * Eigen::Vector2d(0, 0.9), plot::Ink::b, "column 1", plot::Side::left)
      .segment(zero, move, plot::Ink::muted, plot::Stroke::dashed)
      .label(0.5 * move, "t", plot::Side::below_right, plot::Ink::muted)
      .label({0.1, 1.3}, "world", plot::Side::centre, plot::Ink::a)
      .label({2.75, 0.45}, "body", plot::Side::centre, plot::Ink::b);
  return figure;
}

/// All figures of the page but the first.
inline plot::Grid order_figures()
{
  plot::Grid grid("transforms_order", "", 1);
  grid.describe("A house turned and then moved, and moved and then turned: it ends elsewhere.")
      .add(order_figure(true))
      .add(order_figure(false));
  return grid;
}

/// The first figure of the page.
inline plot::Grid normal_figures()
{
  plot::Grid grid("transforms", "", 1);
  grid.describe(
          "A ramp stretched along x: its normal by M leans, the right one is perpendicular to it.")
      .add(normal_figure(false))
      .add(normal_figure(true));
  return grid;
}

} // namespace cookbook
