/// \file
/// \brief Times ways to invert a matrix, and draws their cost against their error.

#include "01_math/inverse_chart/trial/inverse_chart.hpp"
#include "tools/measure/cost_chart.hpp"
#include "tools/program/program.hpp"

namespace
{

using namespace cookbook;

template <int Size>
plot::Chart chart(const std::string& title, double stretch, const measure::Effort& effort)
{
  const std::vector<SquareMatrix<double, Size>> matrices = conditioned<Size>(stretch, 100);
  std::vector<SquareMatrix<double, Size>> answers(matrices.size());
  std::vector<measure::ChartedMethod> ways;
  for (const TimedInverse<Size>& way : timed_inverses<Size>())
  {
    const auto run = [&matrices, &answers, way]
    {
      way.invert_all(matrices, answers);
      measure::keep(answers.front());
    };
    ways.push_back(
        {{way.name, run, static_cast<double>(matrices.size())},
         inverse_errors<Size>(way, matrices)});
  }
  plot::Chart chart(
      "inverse" + std::to_string(Size) +
          (stretch > 1e8 ? "_far"
           : stretch > 1 ? "_mid"
                         : ""),
      title, {"time of a call [ns]", plot::Scale::log, 4, 20000},
      {"relative error", plot::Scale::log});
  measure::add_methods(chart, ways, effort);
  chart.size(400, 290).name_failures("says: singular");
  return chart;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "inverse_chart",
      .summary = "Times ways to invert a matrix, and draws their cost against their error.",
      .options = {effort_option()}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        const measure::Effort effort = measure::effort_named(given.value("effort"));
        plot::Grid grid("inverse_chart", "", 1);
        grid.describe("Cost against error of ways to invert; " + measure::machine_line())
            .add(chart<3>("3 by 3, stretch 1", 1, effort))
            .add(chart<3>("3 by 3, stretch 1e6", 1e6, effort))
            .add(chart<3>("3 by 3, stretch 1e12", 1e12, effort))
            .add(chart<4>("4 by 4, stretch 1", 1, effort))
            .add(chart<4>("4 by 4, stretch 1e12", 1e12, effort)
                     .note(measure::machine_line())
                     .size(400, 360));
        save_figure(given, "inverse_chart.svg", grid.svg());
      });
}
