#pragma once

/// \file
/// \brief The figure of joints on trial: how far a loaded chain comes apart, against the cost; and
/// what tables of them say.

#include "07_constraints/joint_trial/trial/joint_trial.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// A length [m] in millimetres, or that it fails.
inline std::string millimetres(double length)
{
  const double size = 1000 * std::abs(length);
  return !std::isfinite(size) ? "fails" : size < 1e-3 ? "<0.001" : rounded(size);
}

/// A fraction that is to be one, or that it fails.
inline std::string kept(double fraction)
{
  return std::isfinite(fraction) ? number(std::round(1000 * fraction) / 1000) : "fails";
}

/// The counts with which a method is charted.
inline std::vector<int> charted_counts(const JointMethod& method)
{
  if (method.per_step > 0)
  {
    return {6, 12, 24};
  }
  return {2, 4, 8, 16, 32, 64};
}

// [trial_chart]
/// How far a nudged chain with a load [kg] comes apart, against what a frame costs.
inline plot::Chart stretch_chart(double load)
{
  plot::Chart chart(
      "joint_trial", "", {"cost of a frame [substeps of soft_steps]", plot::Scale::log, 1.5, 160},
      {"joints come apart by up to [mm]", plot::Scale::log, 1e-6, 1e3});
  chart.describe(
      "The cost of a frame against how far the joints of a nudged chain with a load come apart, "
      "for five solvers.");
  std::vector<Eigen::Vector2d> all;
  std::size_t look = 0;
  for (const JointMethod& method : joint_methods())
  {
    if (method.name == "wide_steps") // whose joints give the answers of soft_steps
    {
      continue;
    }
    const plot::Look style = plot::series_look(look++);
    std::vector<Eigen::Vector2d> points;
    for (const int count : charted_counts(method))
    {
      const double cost = static_cast<double>(method.price) * count;
      const double apart = 1000 * stretch_of({method, count}, nudged_chain(load), 120);
      if (std::isfinite(apart)) // a line begins where its solver no longer fails
      {
        points.push_back({cost, apart});
      }
    }
    all.insert(all.end(), points.begin(), points.end());
    chart.line(method.name, points, style);
  }
  return chart.front(all, "best answers").legend(plot::Legend::below).size(640, 480);
}
// [trial_chart]

} // namespace cookbook
