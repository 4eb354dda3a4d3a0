/// \file
/// \brief Gives the contacts of some scenes colours, and says how many can be solved side by side.

#include "06_world/contact_graph/contact_graph.hpp"
#include "06_world/contact_graph/trial/contact_graph_figures.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

// [print_colors]
void run(const Arguments& given)
{
  Table table({"scene", "contacts", "most at one body", "colours", "groups of 4", "places used"});
  for (const std::string name : {"tower", "pyramid", "wall", "wall_50", "table_on_100"})
  {
    const TouchingBodies touching(named_scene(name));
    const ContactGraph graph = touching.colored();
    const SideBySide fours = side_by_side(graph, 4);
    table.row(
        {name, std::to_string(touching.pairs.size()), std::to_string(touching.most_at_one()),
         std::to_string(graph.colors()), std::to_string(fours.groups), number(fours.used)});
  }
  std::cout << table.text();
  save_figure(given, "contact_graph.svg", contact_graph_figure().svg());
}
// [print_colors]

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "contact_graph",
      .summary = "Gives contacts colours, so that those of one colour can be solved side by side."};
  return run_program(argc, argv, arguments, run);
}
