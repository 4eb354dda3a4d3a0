/// \file
/// \brief Prints and draws up which ways to two boxes' manifold survive the cases that break
/// others.

#include "04_obb_manifolds/box_failures/trial/box_failures.hpp"
#include "04_obb_manifolds/box_failures/trial/box_failures_methods.hpp"
#include "tools/program/program.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

/// For each method: in how many cases it holds, and where it fails.
void print(const VerdictPart& part)
{
  const std::vector<VerdictRow> rows = verdict_rows(part);
  Table table({part.caption, "holds", "of", "fails at"});
  for (std::size_t i = 0; i < part.methods.size(); ++i)
  {
    std::size_t holds = 0, asked = 0;
    std::string fails, last;
    for (const VerdictRow& row : rows)
    {
      const Verdict& verdict = row.verdicts[i];
      last = row.id.empty() ? last : row.id;
      asked += verdict.applies ? 1 : 0;
      holds += verdict.holds ? 1 : 0;
      const bool told =
          fails.size() >= last.size() && fails.substr(fails.size() - last.size()) == last;
      fails += verdict.holds || !verdict.applies || told ? "" : (fails.empty() ? "" : " ") + last;
    }
    table.row({part.methods[i].name, std::to_string(holds), std::to_string(asked), fails});
  }
  std::cout << table.text() << "\n";
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "box_failures",
      .summary = "Which ways to two boxes' manifold survive the cases that break others."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        for (const VerdictPart& part : verdict_parts())
        {
          print(part);
          const std::string mark = part.name == "box_failures" ? "case" : part.name;
          const auto save = [&](const std::string& name, CaseChoice choice)
          {
            save_figure(
                given, name,
                verdict_table(
                    part.caption, names_of(part.methods), verdict_rows(part, choice), mark));
          };
          save(part.name + ".html", CaseChoice::telling);
          save(part.name + "_rest.html", CaseChoice::others);
        }
      });
}
