/// \file
/// \brief Times the chapter's functions that have no other chart, beside those of Eigen and GLM.

#include "01_math/math_prices/trial/math_prices.hpp"
#include "tools/measure/cost_chart.hpp"
#include "tools/program/program.hpp"

int main(int argc, char** argv)
{
  using namespace cookbook;
  const Arguments arguments{
      .name = "math_prices",
      .summary = "Times the functions of the chapter that have no other chart, and their peers.",
      .options = {effort_option()}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        const std::vector<PricedCall> calls = priced_calls();
        std::vector<measure::Timed> timed;
        for (const PricedCall& call : calls)
        {
          timed.push_back(call.timed);
        }
        const std::vector<measure::Timing> timings =
            measure::time_interleaved(timed, measure::effort_named(given.value("effort")));
        plot::BarChart chart("math_prices", "", {"time of a call [ns]"});
        for (std::size_t i = 0; i < calls.size(); ++i)
        {
          const plot::Ink ink = calls[i].whose.empty() ? plot::Ink::a : plot::Ink::muted;
          measure::add_bar(chart, timings[i], ink);
        }
        chart.describe("The time of functions beside Eigen's and GLM's.")
            .note(measure::machine_line())
            .width(560);
        save_figure(given, "math_prices.svg", chart.svg());
      });
}
