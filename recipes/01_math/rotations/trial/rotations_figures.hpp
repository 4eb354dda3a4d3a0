#pragma once

/// \file
/// \brief Drawings of rotations: the circle about an axis, the axes that lock, arc and chord.

#include "01_math/rotations/rotations.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/figures/figure3d.hpp"

#include <numbers>
#include <string>
#include <vector>

namespace cookbook
{

/// Points on the way of `v` about an axis, as it turns from one angle [rad] to another.
inline std::vector<Vector3<double>>
turned_points(const Vector3<double>& axis, const Vector3<double>& v, double from, double to)
{
  std::vector<Vector3<double>> points;
  for (int i = 0; i <= 60; ++i)
  {
    points.push_back(rotation_about<double>(axis, from + (to - from) * i / 60) * v);
  }
  return points;
}

/// A vector that turns about an axis: its tip goes round a circle.
inline plot::Figure3d axis_figure()
{
  const Vector3<double> k(0, 1, 0), v(1.15, 0.85, 0), origin(0, 0, 0);
  const double angle = 70 * std::numbers::pi / 180;
  const Vector3<double> along = k * v.dot(k), across = v - along, beside = k.cross(v);
  const Vector3<double> turned = rotation_about(k, angle) * v;
  plot::Figure3d figure("rotations_axis", "", {-0.8, 0.5, 400, 330});
  figure.describe("A vector turned about an axis by 70 degrees; its tip runs along a circle.")
      .polyline(
          turned_points(k, v, 0, 2 * std::numbers::pi), plot::Ink::muted, plot::Stroke::dashed)
      .polyline(turned_points(k, v, 0, angle), plot::Ink::overlap, plot::Stroke::solid, 2.5)
      .segment(origin, along, plot::Ink::muted, plot::Stroke::dotted)
      .arrow(origin, 1.5 * k, plot::Ink::ink, "k", plot::Side::left)
      .arrow(origin, v, plot::Ink::a, "v", plot::Side::right)
      .arrow(origin, turned, plot::Ink::b, "Rv", plot::Side::left)
      .arrow(along, v, plot::Ink::a)
      .arrow(along, along + beside, plot::Ink::muted, "k × v", plot::Side::above)
      .arrow(along, turned, plot::Ink::b)
      .label(
          along + 0.55 * (rotation_about(k, angle / 2) * across), "θ", plot::Side::centre,
          plot::Ink::overlap);
  return figure;
}

/// The three axes of Euler's angles at a pitch, each with the ring in which it turns.
inline plot::Figure3d axes_at_pitch(const std::string& name, const std::string& title, double pitch)
{
  const Vector3<double> origin(0, 0, 0), y(0, 1, 0), x(1, 0, 0), z(0, 0, 1);
  const Vector3<double> tail = rotation_about<double>(x, pitch) * z; // from the nose to the tail
  plot::Figure3d figure(name, title, {0.55, 0.35, 400, 250, 26});
  const auto ring = [&](const Vector3<double>& axis, const Vector3<double>& start, plot::Ink ink)
  { figure.polyline(turned_points(axis, start, 0, 2 * std::numbers::pi), ink); };
  ring(y, 1.12 * x, plot::Ink::a);
  ring(tail, 0.8 * x, plot::Ink::b);
  figure.describe("The axes of heading, pitch and roll at one pitch.")
      .frame({{0, 0, 0}, 4.2})
      .arrow(origin, 1.4 * y, plot::Ink::a, "heading", plot::Side::left)
      .arrow(origin, 1.4 * x, plot::Ink::ink, "pitch", plot::Side::below)
      .arrow(origin, (pitch > 1 ? 1.05 : 1.5) * tail, plot::Ink::b, "roll", plot::Side::right);
  return figure;
}

/// Level, and with the nose straight up.
inline plot::Grid lock_grid()
{
  plot::Grid grid("rotations_lock", "", 1);
  grid.describe("Level, three axes; with the nose straight up, heading and roll share one.")
      .add(axes_at_pitch("level", "Level: three axes, three ways to turn", 0))
      .add(axes_at_pitch("up", "Nose up: two axes on one line", std::numbers::pi / 2));
  return grid;
}

/// Five equal steps of the way between two quaternions, along the circle and along its chord.
inline plot::Figure2d slerp_figure()
{
  const double least = -0.2, most = 2.4;
  const auto on_circle = [](double angle)
  { return Eigen::Vector2d(std::cos(angle), std::sin(angle)); };
  const Eigen::Vector2d a = on_circle(least), b = on_circle(most), origin(0, 0);
  plot::Figure2d figure("rotations_slerp", "", {{-1.25, -0.45}, {1.55, 1.35}, 400});
  figure.describe("Equal parts of an arc, and equal parts of its chord seen from the centre.");
  std::vector<Eigen::Vector2d> arc;
  for (int i = 0; i <= 60; ++i)
  {
    arc.push_back(on_circle(least + (most - least) * i / 60));
  }
  figure.polyline(arc, plot::Ink::ink).segment(a, b, plot::Ink::muted, plot::Stroke::dashed);
  for (int i = 1; i < 5; ++i)
  {
    const Eigen::Vector2d straight = a + (b - a) * (i / 5.0);
    figure.segment(origin, straight.normalized(), plot::Ink::b, plot::Stroke::dotted)
        .dot(straight.normalized(), plot::Ink::b)
        .dot(on_circle(least + (most - least) * i / 5), plot::Ink::a);
  }
  figure.point(a, plot::Ink::ink, "a", plot::Side::right)
      .point(b, plot::Ink::ink, "b", plot::Side::left)
      .label(on_circle(1.1), "slerp: equal angles", plot::Side::above, plot::Ink::a)
      .label({0, 0}, "nlerp: equal steps of the chord", plot::Side::below, plot::Ink::b);
  return figure;
}

} // namespace cookbook
