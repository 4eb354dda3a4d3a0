/// \file
/// \brief Prints the ladder of worlds: each rung on the scene that the rung below fails, and scenes
/// in which the small world and GameWorld agree.

#include "05_resolution/small_world/trial/step_rungs.hpp"
#include "06_world/ladder/trial/ladder_rungs.hpp"
#include "tools/program/program.hpp"

#include <algorithm>
#include <iostream>

namespace
{

using namespace cookbook;

/// The lines that a rung takes, where it is named first.
std::string lines_of(const std::string& rung)
{
  const std::vector<LinesTaken> all = lines_taken();
  const auto of =
      std::find_if(all.begin(), all.end(), [&](const LinesTaken& one) { return one.rung == rung; });
  return of == all.end() ? "" : std::to_string(of->lines);
}

/// All rungs, what they take in lines behind them.
Cells ladder()
{
  std::vector<Rung> rungs = small_world::step_rungs();
  const std::vector<Rung> branches = branch_rungs();
  rungs.insert(rungs.end(), branches.begin(), branches.end());
  Cells cells = rungs_table({"rung", "adds", "scene", "rung below", "this rung", "right"}, rungs);
  cells.front().emplace_back("lines");
  for (std::size_t i = 0; i < rungs.size(); ++i)
  {
    cells[i + 1].push_back(lines_of(rungs[i].name));
  }
  return cells;
}

/// Where both worlds agree, in mm.
Cells agreement_table()
{
  Cells cells{{"scene in both worlds", "after [s]", "moved by [m]", "apart [mm]", "allowed [mm]"}};
  for (const Agreement& one : agreements())
  {
    cells.push_back(
        {one.scene, number(one.time), rounded(one.moved), rounded(1000 * one.separation),
         rounded(1000 * allowed(one))});
  }
  return cells;
}

void run(const Arguments& given)
{
  const Cells rungs = ladder(), both = agreement_table();
  std::cout << text_table(rungs) << '\n' << text_table(both);
  save_figure(given, "ladder.html", html_table(rungs));
  save_figure(given, "ladder_agreement.html", html_table(both));
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "ladder",
      .summary = "Runs each rung of the ladder of worlds on the scene that the rung below fails."};
  return run_program(argc, argv, arguments, run);
}
