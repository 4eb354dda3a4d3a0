/// \file
/// \brief Times four ways to normalise, and draws their cost against their error.

#include "01_math/normalize_speed/trial/normalize_speed.hpp"
#include "common/measure/pareto.hpp"
#include "common/measure/timing.hpp"
#include "common/plot/charts/chart.hpp"
#include "common/program/program.hpp"

namespace
{

using namespace cookbook;

using Vectors = std::vector<Vector3<float>>;

// [timed]
template <class Normalize>
measure::Timed timed(const std::string& name, const Vectors& vectors, Normalize normalize_one)
{
  const auto run = [&vectors, normalize_one]
  {
    for (const Vector3<float>& v : vectors)
    {
      measure::keep(normalize_one(v));
    }
  };
  return {name, run, static_cast<double>(vectors.size())};
}

/// Each way is called directly, so that the compiler may build it into the loop.
std::vector<measure::Timed> all_timed(const Vectors& vectors)
{
  return {
      timed("naive", vectors, [](const auto& v) { return normalize_naive<float>(v); }),
      timed("threshold", vectors, [](const auto& v) { return normalize_threshold<float>(v); }),
      timed("wider", vectors, [](const auto& v) { return normalize_wide<float>(v); }),
      timed("scaled", vectors, [](const auto& v) { return normalize<float>(v); })};
}
// [timed]

plot::Chart chart(
    const std::string& name, const std::string& title, const Vectors& vectors,
    const measure::Effort& effort)
{
  plot::Chart chart(
      name, title, {"time of a call [ns]", plot::Scale::log},
      {"error [ulp]", plot::Scale::log, 0.3, 3});
  const std::vector<measure::Timing> timings =
      measure::time_interleaved(all_timed(vectors), effort);
  const auto methods = normalize_methods<float>();
  std::vector<Eigen::Vector2d> front;
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    const measure::ErrorStatistics errors = normalize_errors(methods[i], vectors);
    if (std::isinf(errors.maximum))
    {
      chart.fails(methods[i].name, timings[i].ns, plot::series_look(i));
      continue;
    }
    chart.whisker(methods[i].name, timings[i].ns, errors.p99, errors.maximum, plot::series_look(i));
    front.push_back({timings[i].ns, errors.maximum});
  }
  chart.size(400, 290).front(front).rail("no length");
  return chart;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "normalize_speed",
      .summary = "Times four ways to normalise, and draws their cost against their error.",
      .options = {{"effort", "how long to measure", "full", {"full", "quick"}}}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        const bool quick = given.value("effort") == "quick";
        const measure::Effort effort = quick ? measure::Effort{5, 0.002} : measure::Effort{};
        plot::Grid grid("normalize_speed", "", 1);
        grid.describe("Cost against error of four ways to normalise; " + measure::machine_line())
            .add(chart("room", "A room: a millimetre to a kilometre", room_vectors(), effort))
            .add(chart("all", "Every size that a float can have", all_vectors(), effort)
                     .note(measure::machine_line())
                     .size(400, 360));
        save_figure(given, "normalize_speed.svg", grid.svg());
      });
}
