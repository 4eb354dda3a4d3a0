/// \file
/// \brief Times the accelerations of chains by two ways, and draws them over the number of links.

#include "07_constraints/articulated_chart/trial/articulated_chart.hpp"
#include "tools/measure/timing.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/program/program.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace
{

using namespace cookbook;

/// One way to find a chain's accelerations, timed.
template <class Way>
measure::Timed timed(const std::string& name, int count)
{
  const auto [links, state] = bent_chain(count);
  const auto way = std::make_shared<Way>(links);
  const double calls = std::ceil(200.0 / count);
  const auto run = [way, state = state, calls]
  {
    for (int i = 0; i < calls; ++i)
    {
      const Eigen::VectorXd faster = way->accelerations(state);
      measure::keep(faster[0]);
    }
  };
  return {name, run, calls};
}

void run(const Arguments& given)
{
  const std::vector<int> counts{1, 2, 4, 8, 16, 32, 64, 128};
  std::vector<measure::Timed> ways;
  for (const int count : counts)
  {
    ways.push_back(timed<ArticulatedBody>("articulated bodies", count));
    ways.push_back(timed<CompositeBodies>("mass matrix", count));
  }
  const std::vector<measure::Timing> timings =
      measure::time_interleaved(ways, measure::effort_named(given.value("effort")));
  plot::Chart chart(
      "articulated_chart", "", {"links", plot::Scale::log, 1, 200},
      {"time of all accelerations [µs]", plot::Scale::log, 0.1, 1000});
  for (std::size_t way = 0; way < 2; ++way)
  {
    std::vector<Eigen::Vector2d> points;
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
      const double ns = timings[2 * i + way].ns;
      if (std::isfinite(ns))
      {
        points.push_back({counts[i], ns / 1000});
      }
    }
    chart.line(ways[way].name, points, plot::series_look(way));
  }
  chart.describe("The time that all accelerations of a chain take, over its number of links.")
      .note(measure::machine_line())
      .legend(plot::Legend::below);
  save_figure(given, "articulated_chart.svg", chart.svg());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "articulated_chart",
      .summary = "Times the accelerations of chains by articulated bodies and by a mass matrix.",
      .options = {effort_option()}};
  return run_program(argc, argv, arguments, run);
}
