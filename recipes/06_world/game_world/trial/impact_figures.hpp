#pragma once

/// \file
/// \brief What a step does about a cube that comes down, as four drawings.

#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/panel.hpp"

#include <Eigen/Geometry>

#include <string>

namespace cookbook
{

/// A square of 20 cm in a drawing.
struct DrawnSquare
{
  Eigen::Vector2d center; ///< [m]
  double angle;           ///< [rad], counter-clockwise

  /// The one that stands at a place [m] on its lower left corner.
  static DrawnSquare on_corner(const Eigen::Vector2d& place, double angle)
  {
    return {place - Eigen::Rotation2Dd(angle) * Eigen::Vector2d(-0.1, -0.1), angle};
  }
  Eigen::Vector2d corner(double x, double y) const
  {
    return center + Eigen::Rotation2Dd(angle) * (0.1 * Eigen::Vector2d(x, y));
  }
  void draw(plot::Figure2d& figure, plot::Fill fill, plot::Stroke stroke) const
  {
    figure.box(center, angle, {0.1, 0.1}, plot::Ink::b, fill, stroke);
  }
};

/// A drawing with the ground.
inline plot::Figure2d above_ground(const std::string& title)
{
  plot::Figure2d figure("impact", title, {{-0.2, -0.09}, {0.2, 0.32}, 270});
  figure.half_plane({0, 1}, 0, plot::Ink::a);
  return figure;
}

/// A cube at 5 m/s that would end 5 cm deep.
inline plot::Figure2d speculative_panel()
{
  plot::Figure2d figure = above_ground("1. predicted");
  const DrawnSquare now{{0, 0.132}, 0}, end{{0, 0.132 - 5.0 / 60}, 0};
  const Eigen::Vector2d slots_to_free = end.corner(-1, -1), right = end.corner(1, -1);
  now.draw(figure, plot::Fill::wash, plot::Stroke::solid);
  figure.region({{slots_to_free.x(), 0}, slots_to_free, right, {right.x(), 0}});
  end.draw(figure, plot::Fill::none, plot::Stroke::dashed);
  figure.arrow(now.center, end.center, plot::Ink::ink, "v h", plot::Side::right)
      .point({slots_to_free.x(), 0})
      .point({right.x(), 0})
      .label({0, slots_to_free.y()}, "made a contact", plot::Side::below);
  return figure;
}

/// Where a turned cube first touches the ground [m], and how it is turned then.
inline const Eigen::Vector2d first_corner(-0.1, 0);
inline const DrawnSquare at_first_touch = DrawnSquare::on_corner(first_corner, 0.35);

/// One that is stopped at one corner, and turns about it onto another.
inline plot::Figure2d too_deep_panel()
{
  plot::Figure2d figure = above_ground("2. checked again");
  const DrawnSquare end = DrawnSquare::on_corner(first_corner, -0.25);
  const Eigen::Vector2d deep = end.corner(1, -1), right = end.corner(1, 1);
  const double fraction = deep.y() / (deep.y() - right.y());
  at_first_touch.draw(figure, plot::Fill::none, plot::Stroke::dashed);
  end.draw(figure, plot::Fill::wash, plot::Stroke::solid);
  figure.region({first_corner, deep, deep + fraction * (right - deep)})
      .point(first_corner, plot::Ink::ink, "a contact", plot::Side::below)
      .label(deep, "too deep", plot::Side::below, plot::Ink::overlap);
  return figure;
}

/// The same, touch by touch.
inline plot::Figure2d swept_panel()
{
  plot::Figure2d figure = above_ground("3. swept");
  const DrawnSquare flat = DrawnSquare::on_corner(first_corner, 0);
  at_first_touch.draw(figure, plot::Fill::none, plot::Stroke::dashed);
  flat.draw(figure, plot::Fill::wash, plot::Stroke::solid);
  figure.point(first_corner, plot::Ink::ink, "first touch", plot::Side::below)
      .point(flat.corner(1, -1), plot::Ink::ink, "second", plot::Side::below);
  return figure;
}

/// A heavy cube on a light one on the ground.
inline plot::Figure2d driven_panel()
{
  plot::Figure2d figure = above_ground("4. impact group");
  const DrawnSquare heavy{{-0.04, 0.2}, 0};
  heavy.draw(figure, plot::Fill::wash, plot::Stroke::solid);
  figure.box({-0.06, 0.05}, 0, {0.05, 0.05}, plot::Ink::muted)
      .arrow(heavy.center, heavy.center - Eigen::Vector2d(0, 0.07), plot::Ink::ink)
      .label(heavy.center, "heavy", plot::Side::above)
      .label({-0.06, 0.05}, "light", plot::Side::centre);
  for (const double x : {-0.11, -0.01})
  {
    figure.point({x, 0}).point({x, 0.1});
  }
  figure.label({-0.005, 0.05}, "all four at once", plot::Side::right);
  return figure;
}

/// All four, in the order of a step.
inline plot::Grid impact_figure()
{
  plot::Grid grid("game_world_one_step", "", 2);
  grid.describe(
          "A cube that would end deep in the ground is a contact before it touches; one that "
          "turns onto another corner is found too deep; it is swept, corner by corner; a heavy "
          "one drives a light one along, down to the ground.")
      .add(speculative_panel())
      .add(too_deep_panel())
      .add(swept_panel())
      .add(driven_panel());
  return grid;
}

} // namespace cookbook
