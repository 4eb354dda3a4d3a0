#pragma once

/// \file
/// \brief The figures of the impulse: balls before and after, a corner hit, and passes.

#include "05_resolution/impulse/trial/bounce_cases.hpp"
#include "05_resolution/impulse/trial/impulse_pitfalls.hpp"
#include "05_resolution/impulse/trial/impulse_scenes.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/figures/figure3d.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace cookbook
{

/// A point of the plane z = 0.
inline Eigen::Vector2d flat(const Vector3<double>& v)
{
  return {v.x(), v.y()};
}

/// The two balls with an arrow for each velocity, 0.25 m long for each m/s.
inline plot::Figure2d balls_panel(
    const std::string& name, const std::string& title, const TwoBalls& balls,
    const BodyPair<double>& bodies)
{
  const double scale = 0.25;
  plot::Figure2d figure(name, title, {{-0.5, -0.55}, {0.95, 0.95}, 330});
  figure.circle(flat(balls.shape_a.center), balls.shape_a.radius, plot::Ink::a)
      .circle(flat(balls.shape_b.center), balls.shape_b.radius, plot::Ink::b);
  const auto velocity = [&](const Motion<double>& motion, plot::Ink ink, const std::string& label)
  {
    const Vector3<double> tip = motion.center + scale * motion.velocity;
    figure.arrow(flat(motion.center), flat(tip), ink, motion.velocity.isZero(0) ? "" : label);
  };
  velocity(bodies.a.motion, plot::Ink::a, "v_{A}");
  velocity(bodies.b.motion, plot::Ink::b, "v_{B}");
  return figure;
}

/// The balls before the bounce, with the normal, and after it, with the impulse on each.
inline plot::Grid balls_figure(const TwoBalls& balls, const BodyPair<double>& after)
{
  const Vector3<double> contact = balls.manifold.points[0].position;
  const Vector3<double> normal = balls.manifold.normal;
  const Vector3<double> push = balls.properties_b.mass * after.b.motion.velocity;
  plot::Figure2d before_panel = balls_panel("before", "before", balls, balls.bodies);
  before_panel.arrow(flat(contact), flat(contact + 0.2 * normal), plot::Ink::ink, "n")
      .point(flat(contact));
  plot::Figure2d after_panel = balls_panel("after", "after", balls, after);
  after_panel.arrow(flat(contact), flat(contact + 0.18 * push), plot::Ink::overlap, "j n")
      .arrow(flat(contact), flat(contact - 0.18 * push), plot::Ink::overlap, "−j n")
      .point(flat(contact));
  plot::Grid grid("impulse", "", 2);
  grid.describe("Two balls before and after their bounce, with velocities and impulses.")
      .add(before_panel)
      .add(after_panel);
  return grid;
}

/// Part of a circle about an axis through a point, in the sense of a right-handed turn.
inline std::vector<Eigen::Vector3d>
turn_about(const Vector3<double>& center, const Vector3<double>& axis, double radius, double turn)
{
  const Vector3<double> u = axis.unitOrthogonal();
  const Vector3<double> v = axis.normalized().cross(u);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= 32; ++i)
  {
    const double angle = turn * i / 32;
    points.push_back(center + radius * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return points;
}

/// The cube that meets a pebble with one corner: lever, impulse, and the spin it gets.
inline plot::Figure3d corner_figure(const Landing& landing, double restitution)
{
  const Vector3<double> center = landing.cube.center;
  const Vector3<double> contact = landing.manifold.points[0].position;
  const Motion<double> after = bounce(landing.bodies, landing.manifold, restitution, 1).a.motion;
  const Vector3<double> up = -landing.manifold.normal;
  const Vector3<double> lever = (contact - center).cross(up);
  const std::vector<Eigen::Vector3d> turn =
      turn_about(center + 0.8 * lever, lever, 0.22, 1.6 * std::numbers::pi);
  plot::Figure3d figure(
      "impulse_corner", "", {.yaw = 0.25, .pitch = 0.3, .width = 560, .height = 460});
  figure.describe("A level cube that meets a pebble with one lower corner, and the spin it gets.")
      .sphere(landing.bodies.b.motion.center, 0.125, plot::Ink::b)
      .box(center, landing.cube.axes, landing.cube.half_extents, plot::Ink::a)
      .arrow(center, contact, plot::Ink::muted)
      .label((center + contact) / 2, "r", plot::Side::left, plot::Ink::muted)
      .arrow(contact, contact + 0.7 * up, plot::Ink::overlap, "−j n", plot::Side::right)
      .arrow(center, center + 1.4 * lever, plot::Ink::ink, "r × (−n)");
  if (!after.angular_velocity.isZero(0))
  {
    figure.polyline(turn, plot::Ink::ink).arrow(turn[31], turn[32], plot::Ink::ink, "ω");
  }
  figure.point(contact);
  return figure;
}

/// How far from 1 m/s the cube comes up, after each number of passes.
inline plot::Chart passes_figure()
{
  plot::Chart chart(
      "impulse_passes", "", {"passes over the four points", plot::Scale::linear},
      {"error of the speed [m/s]", plot::Scale::log});
  chart.describe("The error of a bounce against the number of passes over its points.");
  const std::vector<BounceCase<double>> cases = bounce_cases<double>();
  std::vector<Eigen::Vector2d> wide, narrow, divided;
  for (int passes = 1; passes <= 8; ++passes)
  {
    const auto error = [&](const BodyPair<double>& bodies) -> Eigen::Vector2d {
      return {passes, std::abs(bodies.a.motion.velocity.y() - 1)};
    };
    wide.push_back(error(bounce(cases[0].bodies, cases[0].manifold, 1.0, passes)));
    narrow.push_back(error(bounce(cases[1].bodies, cases[1].manifold, 1.0, passes)));
    divided.push_back(error(bounce_divided(cases[0].bodies, cases[0].manifold, 1.0, passes)));
  }
  chart.line("points at ±0.5", wide)
      .line("points at ±0.375", narrow)
      .line(
          "divided, at ±0.5", divided,
          {plot::Ink::overlap, plot::Marker::cross, plot::Stroke::dotted})
      .reference_y(0.01, "1 %");
  return chart;
}

} // namespace cookbook
