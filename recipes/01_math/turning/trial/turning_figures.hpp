#pragma once

/// \file
/// \brief Drawings of a step of turning: along the circle, and along its tangent.

#include "01_math/turning/trial/turning_cases.hpp"
#include "tools/plot/figures/figure2d.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace cookbook
{

/// Points of the unit circle from one angle [rad] to another.
inline std::vector<Eigen::Vector2d> arc_points(double from, double to)
{
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= 60; ++i)
  {
    const double angle = from + (to - from) * i / 60;
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  return points;
}

/// A step of half an angle of one radian: along the circle, and along the tangent and back.
inline plot::Figure2d tangent_figure()
{
  const double half = 1, lost = std::atan(half);
  const Eigen::Vector2d origin(0, 0), start(1, 0), added(1, half);
  const Eigen::Vector2d right(std::cos(half), std::sin(half));
  const Eigen::Vector2d back(std::cos(lost), std::sin(lost));
  plot::Figure2d figure("turning", "", {{-0.25, -0.2}, {1.6, 1.2}, 400});
  figure.describe("A step along the unit circle, and one along its tangent that falls short.")
      .polyline(arc_points(-0.15, 1.75), plot::Ink::muted)
      .segment(origin, start, plot::Ink::muted)
      .segment(origin, added, plot::Ink::b, plot::Stroke::dashed)
      .segment(origin, right, plot::Ink::a, plot::Stroke::dashed)
      .polyline(arc_points(0, half), plot::Ink::a, plot::Stroke::solid, 2.5)
      .polyline(arc_points(lost, half), plot::Ink::overlap, plot::Stroke::solid, 5)
      .arrow(start, added, plot::Ink::b, "½|ω|h", plot::Side::right)
      .dot(origin, plot::Ink::ink)
      .point(start, plot::Ink::ink, "q", plot::Side::below_right)
      .point(right, plot::Ink::a, "turned", plot::Side::above)
      .point(added, plot::Ink::b, "added", plot::Side::above)
      .point(back, plot::Ink::b, "length one", plot::Side::left)
      .label(0.5 * (right + back) * 1.02, "lost", plot::Side::right, plot::Ink::overlap);
  return figure;
}

/// Quaternions of turns about one axis, as points of the plane of w and the part along the axis:
/// where steps lead that are turned, and where those of another way do.
inline plot::Figure2d ways_figure(
    const std::string& name, const std::string& other, const std::vector<Eigen::Vector2d>& turned,
    const std::vector<Eigen::Vector2d>& way, const plot::View& view)
{
  plot::Figure2d figure(name, "", view);
  figure.circle({0, 0}, 1, plot::Ink::a, plot::Fill::none);
  for (std::size_t i = 1; i < way.size(); ++i)
  {
    figure.dot(turned[i], plot::Ink::a).dot(way[i], plot::Ink::b);
  }
  figure.polyline(way, plot::Ink::b)
      .segment({0, 0}, way.back(), plot::Ink::b, plot::Stroke::dashed)
      .segment({0, 0}, turned.back(), plot::Ink::a, plot::Stroke::dashed)
      .point(turned.front(), plot::Ink::ink, "q", plot::Side::right)
      .point(way.back(), plot::Ink::b, other, plot::Side::below)
      .point(turned.back(), plot::Ink::a, "turned", plot::Side::right);
  return figure;
}

/// Nine steps of half an angle of 0.4 radians, added: the quaternion runs away from the circle.
inline plot::Figure2d spiral_figure()
{
  const double half = 0.4;
  std::vector<Eigen::Vector2d> turned{{1, 0}}, added{{1, 0}};
  for (int i = 1; i <= 9; ++i)
  {
    turned.emplace_back(std::cos(half * i), std::sin(half * i));
    added.push_back(added.back() + half * Eigen::Vector2d(-added.back().y(), added.back().x()));
  }
  plot::Figure2d figure =
      ways_figure("turning_way", "added", turned, added, {{-2.35, -1.2}, {1.45, 1.85}, 400});
  figure.describe("Nine steps added spiral outwards; the same steps turned stay on the circle.");
  return figure;
}

} // namespace cookbook
