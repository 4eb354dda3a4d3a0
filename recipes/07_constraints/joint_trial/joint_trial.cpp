/// \file
/// \brief Solvers of joints on trial: chains, loops, towers and pairs in space by each of them,
/// against what is right; or a scene of the reader's, against the laws.

#include "06_world/scenes/trial/scene_file.hpp"
#include "07_constraints/joint_trial/trial/joint_trial_figures.hpp"
#include "07_constraints/joint_trial/trial/own_scene.hpp"
#include "07_constraints/joint_trial/trial/trial_columns.hpp"
#include "07_constraints/joint_trial/trial/trial_methods.hpp"
#include "tools/program/program.hpp"

#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using namespace cookbook;

/// What a method is given in a frame.
std::string settings_of(const JointMethod& method)
{
  return std::to_string(method.usual) + " " + method.counted;
}

// [print_trial]
/// Prints a table of all methods, and returns its rows as CSV.
std::string
print_trial(const std::string& title, const std::vector<TrialColumn>& columns, bool settings)
{
  std::vector<std::string> head{title};
  if (settings)
  {
    head.emplace_back("settings");
  }
  for (const TrialColumn& column : columns)
  {
    head.push_back(column.title);
  }
  Table table(head);
  std::string csv;
  for (const JointMethod& method : trial_methods())
  {
    const JointRun run{method, method.usual};
    std::vector<std::string> row{method.name};
    if (settings)
    {
      row.push_back(settings_of(method));
    }
    for (const TrialColumn& column : columns)
    {
      row.push_back(column.of(run));
      csv += trial_row(run, column.scene, column.measure, row.back());
    }
    table.row(row);
  }
  std::cout << table.text();
  return csv;
}
// [print_trial]

// [print_own]
/// What the laws say of a scene from a file, by each method.
void print_own(const Scene& scene)
{
  if (scene.constraints.empty())
  {
    throw std::invalid_argument("the scene has no joints, \"joints\": [...], to try");
  }
  Table table(
      {scene.name, "settings", "joints open [mm]", "turned [rad]", "worst at [s]",
       "energy changes [J]", "momentum off", "angular off"});
  std::string reasons;
  double start = 0;
  for (const JointMethod& method : trial_methods())
  {
    std::vector<std::string> row{method.name, settings_of(method)};
    try
    {
      const LawsKept laws = laws_kept({method, method.usual}, scene);
      start = laws.energy_start;
      const bool closed = laws.open.length < 1e-6;
      row.insert(
          row.end(), {millimetres(laws.open.length), lost(laws.open.angle),
                      closed ? "-" : number(std::round(100 * laws.worst) / 100),
                      lost(std::abs(laws.energy_end - laws.energy_start)),
                      laws.held ? "-" : lost(laws.linear), laws.held ? "-" : lost(laws.angular)});
    }
    catch (const std::logic_error& cannot)
    {
      row.resize(8, "-");
      reasons += method.name + ": " + cannot.what() + "\n";
    }
    table.row(row);
  }
  std::cout << table.text() << "energy at the start: " << rounded(start) << " J\n" << reasons;
}
// [print_own]

void run(const Arguments& given)
{
  const std::string& file = given.value("scene-file");
  if (!file.empty())
  {
    return print_own(read_scene(std::filesystem::path(file)));
  }
  std::string csv = trial_header + print_trial("stretch [mm]", chain_columns(), false);
  std::cout << '\n';
  csv += print_trial("off by [mm]", loop_columns(), true);
  std::cout << '\n';
  csv += print_trial("energy left", law_columns(), false);
  save_figure(given, "joint_trial.svg", stretch_chart(1000, csv).svg());
  save_figure(given, "joint_trial.csv", csv);
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "joint_trial",
      .summary =
          "Chains, loops, towers and pairs by each solver of joints, as tables, as a chart, and "
          "as CSV.",
      .options = {
          {"scene-file",
           "a JSON file with your own scene and its joints: what the laws say of it",
           "",
           {},
           {},
           {},
           FileUse::read}}};
  return run_program(argc, argv, arguments, run);
}
