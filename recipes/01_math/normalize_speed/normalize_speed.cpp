/// \file
/// \brief Times eight ways to normalise, and draws their cost against their error.

#include "01_math/normalize_speed/trial/normalize_speed.hpp"
#include "01_math/normalize/trial/normalize_libraries.hpp"
#include "common/measure/timing.hpp"
#include "common/plot/charts/chart.hpp"
#include "common/program/program.hpp"

#ifdef COOKBOOK_HAS_GLM
#include <glm/glm.hpp>
#endif

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

/// A way to time, and how its answer is judged.
struct Contender
{
  measure::Timed timed;
  NormalizeMethod<float> method;
};

#ifdef COOKBOOK_HAS_GLM
Vector3<float> normalized_glm(const Vector3<float>& v)
{
  const glm::vec3 unit = glm::normalize(glm::vec3(v.x(), v.y(), v.z()));
  return {unit.x, unit.y, unit.z};
}
#endif

/// Each way is called directly, so that the compiler may build it into the loop. Eigen and GLM do
/// not say the length; they are judged by their directions.
std::vector<Contender> contenders(const Vectors& vectors)
{
  const auto ours = normalize_methods<float>();
  const auto libraries = normalize_libraries<float>();
  std::vector<Contender> all{
      {timed("naive", vectors, [](const auto& v) { return normalize_naive<float>(v); }), ours[0]},
      {timed("threshold", vectors, [](const auto& v) { return normalize_threshold<float>(v); }),
       ours[1]},
      {timed("wider", vectors, [](const auto& v) { return normalize_wide<float>(v); }), ours[2]},
      {timed("scaled", vectors, [](const auto& v) { return normalize<float>(v); }), ours[3]},
      {timed("Eigen", vectors, [](const auto& v) { return Vector3<float>(v.normalized()); }),
       libraries[0]},
      {timed("stable", vectors, [](const auto& v) { return Vector3<float>(v.stableNormalized()); }),
       libraries[1]},
      {timed("hypot", vectors, [](const auto& v) { return normalize_hypot<float>(v); }),
       libraries[2]}};
#ifdef COOKBOOK_HAS_GLM
  all.push_back(
      {timed("GLM", vectors, normalized_glm),
       {"GLM", [](const Vector3<float>& v) {
          return Direction<float>{normalized_glm(v), normalize_naive<float>(v).length};
        }}});
#endif
  return all;
}
// [timed]

plot::Chart chart(
    const std::string& name, const std::string& title, const Vectors& vectors,
    const measure::Effort& effort)
{
  plot::Chart chart(
      name, title, {"time of a call [ns]", plot::Scale::log},
      {"error [ulp]", plot::Scale::log, 0.3, 3});
  const std::vector<Contender> all = contenders(vectors);
  std::vector<measure::Timed> to_time;
  for (const Contender& one : all)
  {
    to_time.push_back(one.timed);
  }
  const std::vector<measure::Timing> timings = measure::time_interleaved(to_time, effort);
  std::vector<Eigen::Vector2d> front;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const measure::ErrorStatistics errors = normalize_errors(all[i].method, vectors);
    if (errors.maximum > 1000)
    {
      chart.fails(timings[i].name, timings[i].ns, plot::series_look(i));
      continue;
    }
    chart.whisker(timings[i].name, timings[i].ns, errors.p99, errors.maximum, plot::series_look(i));
    front.push_back({timings[i].ns, errors.maximum});
  }
  chart.size(400, 330).front(front).rail("lost");
  return chart;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "normalize_speed",
      .summary = "Times eight ways to normalise, and draws their cost against their error.",
      .options = {{"effort", "how long to measure", "full", {"full", "quick"}}}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        const bool quick = given.value("effort") == "quick";
        const measure::Effort effort = quick ? measure::Effort{5, 0.002} : measure::Effort{};
        plot::Grid grid("normalize_speed", "", 1);
        grid.describe("Cost against error of eight ways to normalise; " + measure::machine_line())
            .add(chart("room", "A room: a millimetre to a kilometre", room_vectors(), effort))
            .add(chart("all", "Every size that a float can have", all_vectors(), effort)
                     .note(measure::machine_line())
                     .size(400, 380));
        save_figure(given, "normalize_speed.svg", grid.svg());
      });
}
