/// \file
/// \brief Times ways to invert a matrix, and draws their cost against their error.

#include "01_math/inverse_chart/trial/inverse_chart.hpp"
#include "common/measure/timing.hpp"
#include "common/plot/charts/chart.hpp"
#include "common/program/program.hpp"

namespace
{

using namespace cookbook;

// [timed]
template <int Size>
plot::Chart chart(const std::string& title, double stretch, const measure::Effort& effort)
{
  const std::vector<SquareMatrix<double, Size>> matrices = conditioned<Size>(stretch, 100);
  const std::vector<TimedInverse<Size>> ways = timed_inverses<Size>();
  std::vector<SquareMatrix<double, Size>> answers(matrices.size());
  std::vector<measure::Timed> timed;
  for (const TimedInverse<Size>& way : ways)
  {
    const auto run = [&]
    {
      way.invert_all(matrices, answers);
      measure::keep(answers.front());
    };
    timed.push_back({way.name, run, static_cast<double>(matrices.size())});
  }
  const std::vector<measure::Timing> timings = measure::time_interleaved(timed, effort);
  plot::Chart chart(
      "inverse" + std::to_string(Size) +
          (stretch > 1e8 ? "_far"
           : stretch > 1 ? "_mid"
                         : ""),
      title, {"time of a call [ns]", plot::Scale::log, 4, 20000},
      {"relative error", plot::Scale::log});
  std::vector<Eigen::Vector2d> front;
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    const measure::ErrorStatistics errors = inverse_errors<Size>(ways[i], matrices);
    if (std::isinf(errors.maximum))
    {
      chart.fails(ways[i].name, timings[i].ns, plot::series_look(i));
      continue;
    }
    chart.whisker(ways[i].name, timings[i].ns, errors.p99, errors.maximum, plot::series_look(i));
    front.push_back({timings[i].ns, errors.maximum});
  }
  chart.size(400, 290).front(front).rail("says: singular");
  return chart;
}
// [timed]

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "inverse_chart",
      .summary = "Times ways to invert a matrix, and draws their cost against their error.",
      .options = {{"effort", "how long to measure", "full", {"full", "quick"}}}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        const bool quick = given.value("effort") == "quick";
        const measure::Effort effort = quick ? measure::Effort{5, 0.002} : measure::Effort{};
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
