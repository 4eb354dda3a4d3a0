#pragma once

/// \file
/// \brief The figure of joints on trial: how far a loaded chain comes apart, against the cost.

#include "07_constraints/joint_trial/trial/joint_trial.hpp"
#include "07_constraints/joint_trial/trial/trial_cells.hpp"
#include "07_constraints/joint_trial/trial/trial_methods.hpp"
#include "tools/plot/charts/chart.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// The counts with which a method is charted.
inline std::vector<int> charted_counts(const JointMethod& method)
{
  if (method.per_step > 0)
  {
    return {6, 12, 24};
  }
  std::vector<int> counts;
  for (int count = method.price > 2 ? 1 : 2; count * method.price <= 64; count *= 2)
  {
    counts.push_back(count);
  }
  return counts;
}

// [trial_chart]
/// How far a nudged chain with a load [kg] comes apart in 2 s, against what a frame costs; its
/// points are added to a CSV, too.
inline plot::Chart stretch_chart(double load, std::string& csv)
{
  plot::Chart chart(
      "joint_trial", "", {"cost of a frame [substeps of soft_steps]", plot::Scale::log, 1.5, 160},
      {"joints come apart by up to [mm]", plot::Scale::log, 1e-6, 1e3});
  chart.describe(
      "The cost of a frame against how far the joints of a nudged chain with a load come apart, "
      "for seven solvers.");
  std::vector<Eigen::Vector2d> all;
  std::size_t look = 0;
  for (const JointMethod& method : trial_methods())
  {
    // Joints of wide steps give the answers of soft steps, and a tree cannot come apart.
    if (method.name == "wide_steps" || method.name == "articulated")
    {
      continue;
    }
    const plot::Look style = plot::series_look(look++);
    std::vector<Eigen::Vector2d> points;
    for (const int count : charted_counts(method))
    {
      const double cost = static_cast<double>(method.price) * count;
      const double apart = 1000 * stretch_of({method, count}, nudged_chain(load), 120);
      csv += trial_row(
          {method, count}, "chain with " + number(load) + " kg nudged", "joints open in 2 s [mm]",
          millimetres(apart / 1000));
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
