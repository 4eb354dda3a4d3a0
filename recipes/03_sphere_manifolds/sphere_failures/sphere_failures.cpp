/// \file
/// \brief Prints which methods for a sphere's manifold hold in the cases that break
/// others.

#include "03_sphere_manifolds/sphere_failures/trial/sphere_failures.hpp"
#include "03_sphere_manifolds/sphere_failures/trial/sphere_box_failures.hpp"
#include "tools/program/program.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

void print(const std::vector<std::string>& methods, const std::vector<VerdictRow>& rows)
{
  std::vector<std::string> header{"case"};
  header.insert(header.end(), methods.begin(), methods.end());
  Table table(header);
  for (const VerdictRow& row : rows)
  {
    std::vector<std::string> cells{row.id};
    for (const Verdict& verdict : row.verdicts)
    {
      cells.push_back(verdict.what);
    }
    table.row(cells);
  }
  std::cout << table.text();
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "sphere_failures",
      .summary = "Which methods for a sphere's manifold hold in the cases that break others."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print(sphere_method_names(), sphere_verdicts());
        std::cout << '\n';
        print(box_method_names(), box_verdicts());
        save_figure(
            given, "sphere_failures.html",
            verdict_table("Two spheres", sphere_method_names(), sphere_verdicts()));
        save_figure(
            given, "sphere_failures_box.html",
            verdict_table("A sphere and a box", box_method_names(), box_verdicts()));
      });
}
