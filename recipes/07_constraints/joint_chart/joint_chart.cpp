/// \file
/// \brief Times solvers of joints beside Bullet and ODE, and draws cost against error.

#include "07_constraints/joint_chart/trial/joint_chart.hpp"
#include "07_constraints/joint_trial/trial/joint_trial_figures.hpp"
#include "tools/measure/timing.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace
{

using namespace cookbook;

/// How the frames of a scene are timed.
struct Timing
{
  int turns, repetitions;
};

/// The colour is the author's, the marker one of his solvers'.
plot::Look look_of(const std::string& line)
{
  using enum plot::Marker;
  static const std::map<std::string, plot::Look> looks{
      {"Bullet", {plot::Ink::series2, circle, plot::Stroke::dashed}},
      {"Bullet, iterations", {plot::Ink::series2, cross, plot::Stroke::dashed}},
      {"Bullet, Dantzig", {plot::Ink::series2, square, plot::Stroke::dashed}},
      {"Bullet, multibody", {plot::Ink::series2, star, plot::Stroke::dashed}},
      {"ODE, quick", {plot::Ink::series3, circle, plot::Stroke::dotted}},
      {"ODE, iterations", {plot::Ink::series3, cross, plot::Stroke::dotted}},
      {"ODE, direct", {plot::Ink::series3, square, plot::Stroke::dotted}},
      {"sequential_impulses", {plot::Ink::series1, circle}},
      {"soft_steps", {plot::Ink::series1, triangle}},
      {"position_based", {plot::Ink::series1, inverted_triangle}},
      {"avbd", {plot::Ink::series1, diamond}},
      {"direct", {plot::Ink::series1, square}},
      {"articulated", {plot::Ink::series1, star}}};
  const auto known = looks.find(line);
  return known == looks.end() ? plot::Look{plot::Ink::series1, plus} : known->second;
}

/// Cost against an error: a curve for each solver, over its substeps or iterations.
plot::Chart cost_chart(
    const std::string& file, const std::string& axis, const JointError& error,
    const std::vector<JointContender>& contenders, const Timing& timing)
{
  plot::Chart chart(
      file, "", {"time a body and frame [µs]", plot::Scale::log}, {axis, plot::Scale::log});
  chart.note(measure::machine_line()).legend(plot::Legend::below).size(640, 520);
  const std::vector<double> costs =
      joint_costs(contenders, error.scene, timing.turns, timing.repetitions);
  std::vector<Eigen::Vector2d> line, all;
  for (std::size_t i = 0; i < contenders.size(); ++i)
  {
    const JointContender& one = contenders[i];
    const double cost = costs[i] * 1e6, size = 1000 * error_of(one, error);
    if (std::isfinite(size))
    {
      line.emplace_back(cost, size);
    }
    if (i + 1 < contenders.size() && contenders[i + 1].line == one.line)
    {
      continue;
    }
    if (line.empty())
    {
      const std::string author = one.line.substr(0, one.line.find(','));
      chart.fails(
          author + ", " + one.settings, cost, {look_of(one.line).ink, plot::Marker::cross, {}});
    }
    else
    {
      chart.line(one.line, line, look_of(one.line));
    }
    all.insert(all.end(), line.begin(), line.end());
    line.clear();
  }
  return chart.front(all, "best answers").name_failures("bursts");
}

/// Some of the contenders.
template <class Test>
std::vector<JointContender> those(const std::vector<JointContender>& all, const Test& is_one)
{
  std::vector<JointContender> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some), is_one);
  return some;
}

/// Solvers as they come; engines with four substeps, too, and with the most iterations.
bool in_table(const JointContender& one)
{
  const bool iterates = one.line.ends_with("iterations");
  return iterates ? one.number == 3 : one.number == 0 || one.substeps == 4;
}

/// Costs and errors [mm], and what is left of a pendulum's energy.
Cells errors_table(const std::vector<JointContender>& all, const Timing& timing)
{
  const std::vector<JointContender> shown = those(all, in_table);
  const std::vector<double> costs =
      joint_costs(shown, loaded_chain_of(1), timing.turns, timing.repetitions);
  double bullet = 0; // as it comes
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    bullet = shown[i].line == "Bullet" && shown[i].number == 0 ? costs[i] : bullet;
  }
  const std::vector<JointError> errors = joint_errors();
  Cells table{{"solver", "settings", "µs a body and frame", "× Bullet"}};
  for (const JointError& error : errors)
  {
    table[0].push_back(error.name);
  }
  table[0].push_back("energy left");
  const JointedScene pendulum = pendulum_of(0.96, 0.28);
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    table.push_back(
        {shown[i].line, shown[i].settings, rounded(costs[i] * 1e6),
         bullet > 0 ? rounded(costs[i] / bullet) : "–"});
    for (const JointError& error : errors)
    {
      table.back().push_back(
          takes(shown[i], error.scene) ? millimetres(error_of(shown[i], error)) : "–");
    }
    const JointMethod method = shown[i].on(pendulum);
    table.back().push_back(kept(energy_left({method, shown[i].count}, pendulum, -2 * 9.81, 1200)));
  }
  return table;
}

/// What a link costs in longer and longer chains, by solvers that hold them.
std::string growth_chart(const std::vector<JointContender>& all, bool quick)
{
  plot::Chart chart(
      "joint_chart_links", "", {"links of a chain", plot::Scale::log},
      {"time a link and frame [µs]", plot::Scale::log});
  chart.describe("The cost of a link and frame over the number of links of a hanging chain.")
      .note(measure::machine_line())
      .legend(plot::Legend::below)
      .size(640, 460);
  const std::vector<JointContender> shown = those(
      all,
      [](const JointContender& one)
      {
        const bool steps = one.line == "direct" || one.line == "soft_steps";
        return (steps && one.number == 0) || one.substeps == 4;
      });
  std::vector<std::vector<Eigen::Vector2d>> lines(shown.size());
  for (const int links : {5, 10, 20, 40, 80, 160})
  {
    if (quick && links > 80)
    {
      break; // a dense matrix of so many takes a tenth of a second a frame
    }
    const JointedScene chain = chain_of(std::vector<double>(index_of(links), 1.0));
    const std::vector<double> costs = joint_costs(shown, chain, 1, quick ? 1 : 5);
    for (std::size_t i = 0; i < shown.size(); ++i)
    {
      lines[i].emplace_back(links, costs[i] * 1e6);
    }
  }
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    chart.line(shown[i].line, lines[i], look_of(shown[i].line));
  }
  return chart.svg();
}

void run(const Arguments& given)
{
  const bool quick = given.value("effort") == "quick";
  const Timing timing{quick ? 2 : 12, quick ? 2 : 9};
  const std::vector<JointContender> all = joint_contenders();
  const auto opens = [](const JointContender& one) { return !one.chains_only; };
  save_figure(
      given, "joint_chart.svg",
      cost_chart(
          "joint_chart", "joints come apart by up to [mm]", stretch_error("", nudged_chain(1000)),
          those(all, opens), timing)
          .describe(
              "The cost of a frame against how far the joints of a nudged chain with 1,000 kg "
              "come apart, for this book's solvers, Bullet's and ODE's.")
          .svg());
  save_figure(
      given, "joint_chart_swung.svg",
      cost_chart(
          "joint_chart_swung", "a swung load is off by [mm]", {"", swung_chain(), swing_off}, all,
          timing)
          .describe("The cost of a frame against how far a swung load is from where it belongs, "
                    "for this book's solvers, Bullet's and ODE's.")
          .svg());
  save_figure(given, "joint_chart_links.svg", growth_chart(all, quick));
  const Cells table = errors_table(all, quick ? Timing{6, 3} : timing);
  std::cout << text_table(table);
  save_figure(given, "joint_chart.html", html_table(table));
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "joint_chart",
      .summary = "Times solvers of joints beside Bullet and ODE, and draws cost against error.",
      .options = {effort_option()}};
  return run_program(argc, argv, arguments, run);
}
