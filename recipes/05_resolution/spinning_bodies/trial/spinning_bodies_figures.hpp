#pragma once

/// \file
/// \brief The figures of spinning bodies: a racket that flips, its spin, its energy, and what a
/// right orientation costs.

#include "05_resolution/spinning_bodies/trial/spinning_bodies_cases.hpp"
#include "05_resolution/spinning_bodies/trial/steady_spin_cases.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure3d.hpp"

#include <string>
#include <vector>

namespace cookbook
{

/// A plate with the moments of a free spin, seven times while its y axis turns over.
inline plot::Figure3d racket_figure()
{
  plot::Figure3d figure(
      "spinning_bodies", "", {.yaw = 0, .pitch = 0.3, .width = 720, .height = 240});
  figure.describe("A plate that spins about its middle axis turns over; its momentum stays.");
  const FreeSpin scene = tennis_racket();
  const std::vector<double> times{0.9, 1.2, 1.35, 1.5, 1.65, 1.8, 2.1};
  const SpinMethod method = spin_methods().back();
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const auto nothing = [](double, const Spinning<double>&) {};
    const Matrix3<double> axes =
        stepped(scene, method, times[i], 60, nothing).orientation.toRotationMatrix();
    const Vector3<double> center(1.5 * double(i), 0, 0);
    const Vector3<double> up = axes.col(1);
    figure.box(center, axes, {0.5, 0.36, 0.04}, plot::Ink::a)
        .arrow(center, center + 0.75 * up, plot::Ink::b, i == 0 ? "y" : "")
        .label(center - Vector3<double>(0, 1, 0), number(times[i]) + " s", plot::Side::below);
  }
  return figure;
}

/// How the i-th of many lines is drawn: without marks.
inline plot::Look plain_look(std::size_t i)
{
  plot::Look look = plot::series_look(i);
  look.marker = plot::Marker::none;
  return look;
}

/// The spin about the middle axis over ten seconds, by each of some methods.
inline plot::Chart flips_figure(const FreeSpin& scene, double rate)
{
  plot::Chart chart("spinning_bodies_flips", "", {"time [s]"}, {"spin about y [rad/s]"});
  chart.describe("The spin about the middle axis of a body that flips, by five methods.")
      .legend(plot::Legend::below);
  const std::vector<SpinMethod> methods = spin_methods();
  for (const std::size_t i : {0u, 1u, 2u, 3u, 7u})
  {
    std::vector<Eigen::Vector2d> points{{0, scene.spin.y()}};
    const auto visit = [&](double time, const Spinning<double>& body)
    {
      if (time >= points.back().x() + 0.049)
      {
        points.emplace_back(time, own_spin(body).y());
      }
    };
    stepped(scene, methods[i], 10, rate, visit);
    chart.line(methods[i].name, points, plain_look(i));
  }
  for (const double flip : flip_times(scene.moments, scene.spin))
  {
    chart.reference_x(flip, "");
  }
  return chart;
}

/// The largest energy drift so far of the free spin of case I4, over a hundred seconds at 60 Hz.
inline plot::Chart spin_energy_figure()
{
  plot::Chart chart(
      "spinning_bodies_energy", "", {"time [s]"},
      {"energy off by at most", plot::Scale::log, 1e-9, 10});
  chart.describe("The energy drift of seven ways to step a free spin.").legend(plot::Legend::below);
  const FreeSpin scene = tennis_racket();
  const double energy = doubled_energy({Quaternion<double>::Identity(), scene.spin}, scene.moments);
  const std::vector<SpinMethod> methods = spin_methods();
  for (const std::size_t i : {1u, 2u, 3u, 5u, 6u, 7u, 9u})
  {
    std::vector<Eigen::Vector2d> points;
    double worst = 0;
    const auto visit = [&](double time, const Spinning<double>& body)
    {
      worst = worse(worst, std::abs(doubled_energy(body, scene.moments) / energy - 1));
      const double next = points.empty() ? 0.5 : points.back().x() + 0.999;
      if (worst >= 1e-9 && worst <= 10 && time >= next)
      {
        points.emplace_back(time, worst);
      }
    };
    stepped(scene, methods[i], 100, 60, visit);
    chart.line(methods[i].name, points, plain_look(i));
  }
  return chart;
}

/// How far off an orientation is after ten seconds, against the stages a second that it took: a
/// stage solves or evaluates Euler's equations once, or takes the body's axes in turn once.
inline plot::Chart spin_cost_figure()
{
  plot::Chart chart(
      "spinning_bodies_cost", "", {"stages a second", plot::Scale::log},
      {"orientation after 10 s, off by [rad]", plot::Scale::log});
  chart.describe("The error of an orientation against the work, for eight ways to step.")
      .legend(plot::Legend::below);
  const FreeSpin scene = tennis_racket();
  const std::vector<SpinMethod> methods = spin_methods();
  const auto nothing = [](double, const Spinning<double>&) {};
  const Quaternion<double> right = true_orientation(scene, 10);
  const std::vector<int> stages{0, 1, 1, 1, 4, 4, 1, 1, 1, 5};
  for (const std::size_t i : {2u, 3u, 4u, 5u, 6u, 7u, 8u, 9u})
  {
    std::vector<Eigen::Vector2d> points;
    for (double rate = 15; rate < 4000 / stages[i]; rate *= 2)
    {
      const Spinning<double> end = stepped(scene, methods[i], 10, rate, nothing);
      points.emplace_back(rate * stages[i], angle_between(end.orientation, right));
    }
    chart.line(methods[i].name, points, plot::series_look(i));
  }
  return chart;
}

} // namespace cookbook
