#pragma once

/// \file
/// \brief What the program of tunnelling draws: paths at a wall, looks against errors, near misses.

#include "05_resolution/tunnelling/trial/tunnelling_scenes.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/panel.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// A ball of 5 cm on its way to a wall of 2 cm at 30 m/s, slightly upwards, drawn at every step.
inline plot::Figure2d wall_panel(const FlightMethod& method)
{
  const Shots shots{wide_wall(0.02), 0.05, {30, 4, 0}, 0, 0.8};
  const double edge = 0.24;
  plot::Figure2d figure("wall", method.name, {{-0.9, -0.15}, {0.9, edge}, 560});
  figure.box({0, (edge - 0.15) / 2}, 0, {0.01, (edge + 0.15) / 2}, plot::Ink::b, plot::Fill::solid);
  MovingSphere<double> flight{{{-0.72, -0.07, 0}, 0.05}, shots.velocity};
  std::vector<Eigen::Vector2d> path;
  for (int step = 0; step < 5; ++step)
  {
    const Eigen::Vector2d place = flight.sphere.center.head<2>();
    path.push_back(place);
    if (std::abs(place.x()) < 0.85 && place.y() < edge - 0.05)
    {
      figure.circle(place, 0.05, plot::Ink::a)
          .label(place, std::to_string(step), plot::Side::centre, plot::Ink::a);
    }
    const Vector3<double> displacement = shots.step * flight.velocity;
    const auto hit = swept_sphere_box(flight.sphere, displacement, shots.wall);
    if (hit && hit->time > 0 && method.name == swept_method().name)
    {
      path.push_back((flight.sphere.center + hit->time * displacement).head<2>());
      figure.circle(path.back(), 0.05, plot::Ink::overlap, plot::Fill::none, plot::Stroke::dotted);
    }
    flight = method.stepped(flight, shots.wall, shots.restitution, shots.step);
  }
  figure.polyline(path, plot::Ink::muted, plot::Stroke::dashed, 1);
  return figure;
}

/// The same ball under three methods.
inline plot::Grid wall_figure()
{
  const std::vector<FlightMethod> methods = flight_methods();
  plot::Grid grid("tunnelling", "", 1);
  grid.describe("A ball that jumps a wall, one that is braked in front of it, one that bounces.")
      .add(wall_panel(methods[0]))
      .add(wall_panel(methods[3]))
      .add(wall_panel(methods.back()));
  return grid;
}

/// How often the recommended method looks at the gap in a step, on average over all balls.
inline double mean_looks(const Shots& shots)
{
  int looks = 0;
  for (int i = 0; i < shots.count; ++i)
  {
    MovingSphere<double> flight = shots.start(i);
    for (int step = 0; step < shots.steps(); ++step)
    {
      MovingSphere<double> now = flight;
      for (double left = shots.step; left > 0;)
      {
        const auto gap = [&](const Vector3<double>& offset)
        {
          ++looks;
          return direction_to({now.sphere.center + offset, now.sphere.radius}, shots.wall);
        };
        const auto hit = first_touch<double>(left * now.velocity, 1e-12, gap);
        const double free = hit ? hit->time * left : left;
        now = moved(now, free);
        now.velocity =
            hit ? rebound_velocity(now.velocity, hit->normal, shots.restitution) : now.velocity;
        left -= free;
      }
      flight = swept_method().stepped(flight, shots.wall, shots.restitution, shots.step);
    }
  }
  return static_cast<double>(looks) / (shots.count * shots.steps());
}

/// The fraction of balls that pass a wall against the number of looks at the gap in a step.
inline plot::Chart cost_chart()
{
  plot::Chart chart(
      "tunnelling_cost", "", {"looks at the gap in a step", plot::Scale::log, 0.7, 2048},
      {"balls answered wrongly [%]", plot::Scale::linear, 0, 100});
  chart.describe("The fraction of balls that pass a wall, against substeps, at three speeds.")
      .name_failures("stops near misses");
  double looks = 0;
  for (const double speed : {10.0, 100.0, 1000.0})
  {
    const Shots shots{wide_wall(0.02), 0.05, {speed, 0, 0}, 0, 0.5, 1.0 / 60, 499};
    std::vector<Eigen::Vector2d> points;
    for (int count = 1; count <= 1024; count *= 2)
    {
      const FlightMethod method = substeps_method("", count);
      points.push_back({count, 100 * share_passed(shots, method)});
    }
    chart.line(number(speed) + " m/s", points);
    looks += mean_looks(shots) / 3;
  }
  chart.point("swept", {looks, 0}, {plot::Ink::good, plot::Marker::star, {}})
      .fails("speculative", 1);
  return chart;
}

/// How much of its velocity a ball loses that passes a wall's edge by 3 cm, against its speed.
inline plot::Chart beside_chart()
{
  plot::Chart chart(
      "tunnelling_beside", "", {"speed [m/s]", plot::Scale::log},
      {"change of velocity [%]", plot::Scale::linear, 0, 100});
  chart.describe("A ball that passes an edge by 3 cm: speculative braking changes its velocity.");
  const Obb<double> wall{{0, 0, 0}, Matrix3<double>::Identity(), {0.01, 1, 1}};
  const std::vector<FlightMethod> methods = flight_methods();
  for (const std::size_t method : {3u, 5u})
  {
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i <= 24; ++i)
    {
      const double speed = std::pow(10, i / 8.0);
      const Shots shots{wall, 0.05, {speed, 0, 0}, 0.03};
      points.push_back({speed, 100 * most_velocity_lost(shots, methods[method])});
    }
    chart.line(methods[method].name, points);
  }
  return chart;
}

} // namespace cookbook
