/// \file
/// \brief Finds angles from a hundred-millionth to a right angle in five ways, in float.

#include "01_math/angles/angles.hpp"
#include "01_math/angles/trial/angles_cases.hpp"
#include "01_math/angles/trial/angles_figures.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <iostream>

namespace
{

using namespace cookbook;

void print_angles()
{
  std::vector<std::string> header{"angle"};
  for (const std::string& name : names_of(angle_methods<float>()))
  {
    header.push_back(name);
  }
  Table table(header);
  const auto add = [&](const std::string& what, const Vector3<float>& b)
  {
    std::vector<std::string> cells{what};
    for (const AngleMethod<float>& method : angle_methods<float>())
    {
      const float found = method.angle({1, 0, 0}, b);
      cells.push_back(std::isnan(found) ? "nan" : number(static_cast<double>(found)));
    }
    table.row(cells);
  };
  for (const double angle : {1e-8, 1e-6, 1e-4, 3e-4, 1e-3, 1e-2, 0.1})
  {
    add(number(angle), turned_by_half_tangent<float>(std::tan(angle / 2)));
  }
  add("pi / 2", {0, 1, 0});
  add("any, of 0", {0, 0, 0});
  std::cout << table.text();
}

std::string verdicts()
{
  std::vector<VerdictRow> rows = angles_verdicts(angles_cases(0.0f));
  const std::vector<VerdictRow> doubles = angles_verdicts(angles_cases(0.0));
  rows.insert(rows.end(), doubles.begin(), doubles.end());
  return verdict_table(
      "Ways to find an angle: right means within 12 roundings of itself.",
      names_of(angle_methods<float>()), rows, "angle");
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "angles",
      .summary = "Finds angles from a hundred-millionth to a right angle in five ways, in float."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_angles();
        save_figure(given, "angles.svg", lengths_figure().svg());
        save_figure(given, "angles_steps.svg", steps_chart().svg());
        save_figure(given, "angles_cases.html", verdicts());
        save_figure(
            given, "angles_equal.html",
            verdict_table(
                "Ways to ask whether two vectors are equal.", equal_methods, equal_verdicts(),
                "equal"));
      });
}
